package playhouse.client;

import playhouse.client.wire.PlayerMessages;

/** Delivery of data: immediately (push), or in rounds requested by the client (pull). */
public enum Mode {
  PUSH(PlayerMessages.DATAMODE_PUSH),
  PULL(PlayerMessages.DATAMODE_PULL);

  private final int code;

  Mode(int code) {
    this.code = code;
  }

  /** The number on the wire. */
  public int code() {
    return code;
  }
}
