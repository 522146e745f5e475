package playhouse.client;

/**
 * The thread was interrupted while it waited; its interrupt status is cleared. The connection remains usable.
 */
public final class WaitInterruptedException extends PlayerException {
  private static final long serialVersionUID = 1;

  public WaitInterruptedException(String message) {
    super(message);
  }
}
