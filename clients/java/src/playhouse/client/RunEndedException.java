package playhouse.client;

/** The server closed the connection in order, after sending all data: the run has ended. */
public final class RunEndedException extends ConnectionLostException {
  private static final long serialVersionUID = 1;

  public RunEndedException(String message) {
    super(message);
  }
}
