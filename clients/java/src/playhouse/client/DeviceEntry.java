package playhouse.client;

/**
 * One entry of the server's list of devices.
 *
 * @param interfaceName Its name, or a number if it has no known name.
 * @param index Which device of that interface.
 * @param driver The name of the driver; empty if the server does not tell.
 * @param model The full name of the model behind the device; empty if the server does not report it.
 * @param robot The name of that model's top-level model; empty if the server does not report it.
 */
public record DeviceEntry(String interfaceName, int index, String driver, String model, String robot) {
  /** INTERFACE:INDEX, for instance "position2d:12". */
  public String name() {
    return interfaceName + ":" + index;
  }
}
