package playhouse.client;

/** An invalid argument, such as a speed that is not a number or an unknown interface. Nothing was sent. */
public final class InvalidValueException extends PlayerException {
  private static final long serialVersionUID = 1;

  public InvalidValueException(String message) {
    super(message);
  }
}
