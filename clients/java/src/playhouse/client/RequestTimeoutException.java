package playhouse.client;

/** No answer, or no data, before the time-out. The connection remains usable. */
public final class RequestTimeoutException extends PlayerException {
  private static final long serialVersionUID = 1;

  public RequestTimeoutException(String message) {
    super(message);
  }
}
