package playhouse.client;

/** Base of every error of this library; its message is one line. */
public class PlayerException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public PlayerException(String message) {
    super(message);
  }
}
