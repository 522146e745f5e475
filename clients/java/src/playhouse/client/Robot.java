package playhouse.client;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A model and its descendants by its name in the world file, returned by {@link Client#robot} and {@link
 * Client#robots}.
 *
 * <p>laser() is its first laser, lasers() are all, and so on; they are opened on first use. They throw
 * RequestRefusedException if it has none of that interface, and as Client.device(). Closing the robot closes
 * the devices that were opened here; a moving robot is stopped first.
 */
public final class Robot extends Devices implements AutoCloseable {
  private final Client client;
  private final List<Model> models;
  private final List<DeviceAddress> devices;
  private final int port;  // of the connected server, as reported by the server
  private final Map<DeviceAddress, Device> opened = new LinkedHashMap<>();

  Robot(Client client, List<Model> models, int port) {
    this.client = client;
    this.models = List.copyOf(models);
    this.port = port;
    devices = models.stream().flatMap(model -> model.devices().stream()).toList();
  }

  /** Its name in the world file. */
  public String name() {
    return models.get(0).name();
  }

  /** Its type in the world file, independent of macros. */
  public String type() {
    return models.get(0).type();
  }

  /** The model itself and its descendants. */
  public List<Model> models() {
    return models;
  }

  /** The addresses of all their devices. */
  public List<DeviceAddress> devices() {
    return devices;
  }

  /** The robot's first device of an interface. */
  @Override
  public Device device(String interfaceName) {
    return device(interfaceName, 0);
  }

  /** The robot's device of an interface at index {@code nth}, from 0. */
  public Device device(String interfaceName, int nth) {
    List<DeviceAddress> here = reachable(interfaceName);
    if (nth < 0 || nth >= here.size()) {
      String number = nth == 0 ? "" : " number " + nth;
      throw new RequestRefusedException(
          "robot \"" + name() + "\" has no " + interfaceName + number + " " + elsewhere(interfaceName));
    }
    return open(here.get(nth));
  }

  /** Closes devices opened here, in reverse order of opening. They reopen on use. */
  @Override
  public void close() {
    while (!opened.isEmpty()) {
      DeviceAddress last = new ArrayList<>(opened.keySet()).get(opened.size() - 1);
      opened.remove(last).close();
    }
  }

  @Override
  public String toString() {
    return "Robot \"" + name() + "\": " + names(devices);
  }

  @Override
  <D extends Device> List<D> all(Class<D> type, String interfaceName) {
    return reachable(interfaceName).stream().map(this::open).map(type::cast).toList();
  }

  /** A connection reaches the devices of its own port only. */
  private List<DeviceAddress> reachable(String interfaceName) {
    return devices.stream().filter(at -> at.interfaceName().equals(interfaceName) && at.port() == port).toList();
  }

  /** Text: other ports with devices of this interface, or else the existing devices. */
  private String elsewhere(String interfaceName) {
    String others = devices.stream().filter(at -> at.interfaceName().equals(interfaceName) && at.port() != port)
        .map(at -> at.name() + " at port " + at.port()).collect(Collectors.joining(", "));
    if (!others.isEmpty()) {
      return "at port " + port + ", but " + others + ": connect there";
    }
    return "(it has " + (devices.isEmpty() ? "no devices" : names(devices)) + ")";
  }

  private Device open(DeviceAddress address) {
    Device device = opened.get(address);
    if (device == null || !device.isOpen()) {
      device = client.device(address.interfaceName(), address.index());
      opened.put(address, device);
    }
    return device;
  }

  private static String names(List<DeviceAddress> devices) {
    return devices.stream().map(DeviceAddress::name).collect(Collectors.joining(", "));
  }
}
