package playhouse.client.wire;

/** Type of a message: the header's {@code type}. */
public enum Kind {
  DATA(1),
  CMD(2),
  REQ(3),
  ACK(4),
  SYNCH(5),
  NACK(6);

  private final int code;

  Kind(int code) {
    this.code = code;
  }

  /** The number on the wire. */
  public int code() {
    return code;
  }
}
