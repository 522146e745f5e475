package playhouse.client;

/**
 * Address of a device of a simulated model.
 *
 * @param port Port of its server.
 * @param interfaceName Name of its interface.
 * @param index Which device of that interface.
 * @param model Full name of its model.
 */
public record DeviceAddress(int port, String interfaceName, int index, String model) {
  /** INTERFACE:INDEX, for instance "position2d:12". */
  public String name() {
    return interfaceName + ":" + index;
  }
}
