package playhouse.client;

/** A device was used after the device or its client was closed. */
public final class DeviceClosedException extends PlayerException {
  private static final long serialVersionUID = 1;

  public DeviceClosedException(String message) {
    super(message);
  }
}
