package playhouse.client;

/** The server is unreachable, has disconnected, or sent bytes that violate the protocol. */
public class ConnectionLostException extends PlayerException {
  private static final long serialVersionUID = 1;

  public ConnectionLostException(String message) {
    super(message);
  }
}
