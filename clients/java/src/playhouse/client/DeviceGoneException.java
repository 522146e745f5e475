package playhouse.client;

/** A device was used that the server has retired: its model was removed. */
public final class DeviceGoneException extends PlayerException {
  private static final long serialVersionUID = 1;

  public DeviceGoneException(String message) {
    super(message);
  }
}
