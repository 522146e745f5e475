package playhouse.client;

/** Bytes that do not decode as the message of their header, or a value outside the range of its field. */
public final class WireException extends PlayerException {
  private static final long serialVersionUID = 1;

  public WireException(String message) {
    super(message);
  }
}
