package playhouse.client;

/** The server answered NACK, or has no device or model of that name. */
public final class RequestRefusedException extends PlayerException {
  private static final long serialVersionUID = 1;

  private final byte[] body;

  public RequestRefusedException(String message) {
    this(message, new byte[0]);
  }

  public RequestRefusedException(String message, byte[] body) {
    super(message);
    this.body = body;
  }

  /** The undecoded body of the NACK; empty if it has none. */
  public byte[] body() {
    return body;
  }
}
