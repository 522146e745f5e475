package playhouse.client;

import playhouse.client.wire.PlayerMessages;

/** Access to a device. The numbers of READ and WRITE are the letters of Player's first servers. */
public enum Access {
  ALL(PlayerMessages.OPEN_MODE),
  READ('r'),
  WRITE('w');

  private final int code;

  Access(int code) {
    this.code = code;
  }

  /** The number on the wire. */
  public int code() {
    return code;
  }
}
