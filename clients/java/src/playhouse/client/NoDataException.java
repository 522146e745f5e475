package playhouse.client;

/** A value was read before the first data of the device; {@link Device#nextData} waits for them. */
public final class NoDataException extends PlayerException {
  private static final long serialVersionUID = 1;

  public NoDataException(String message) {
    super(message);
  }
}
