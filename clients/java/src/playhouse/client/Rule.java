package playhouse.client;

import playhouse.client.wire.PlayerMessages;

/** Handling of a message for this client while an older one of the same type is queued. */
public enum Rule {
  ACCEPT(PlayerMessages.MSG_REPLACE_RULE_ACCEPT),
  REPLACE(PlayerMessages.MSG_REPLACE_RULE_REPLACE),
  IGNORE(PlayerMessages.MSG_REPLACE_RULE_IGNORE);

  private final int code;

  Rule(int code) {
    this.code = code;
  }

  /** The number on the wire. */
  public int code() {
    return code;
  }
}
