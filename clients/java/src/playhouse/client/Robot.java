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
public final class Robot implements AutoCloseable {
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

  public Position2d position2d() {
    return (Position2d) device("position2d");
  }

  public List<Position2d> position2ds() {
    return all(Position2d.class, "position2d");
  }

  public Ranger ranger() {
    return (Ranger) device("ranger");
  }

  public List<Ranger> rangers() {
    return all(Ranger.class, "ranger");
  }

  public Laser laser() {
    return (Laser) device("laser");
  }

  public List<Laser> lasers() {
    return all(Laser.class, "laser");
  }

  public Sonar sonar() {
    return (Sonar) device("sonar");
  }

  public List<Sonar> sonars() {
    return all(Sonar.class, "sonar");
  }

  public Fiducial fiducial() {
    return (Fiducial) device("fiducial");
  }

  public List<Fiducial> fiducials() {
    return all(Fiducial.class, "fiducial");
  }

  public Bumper bumper() {
    return (Bumper) device("bumper");
  }

  public List<Bumper> bumpers() {
    return all(Bumper.class, "bumper");
  }

  public Aio aio() {
    return (Aio) device("aio");
  }

  public List<Aio> aios() {
    return all(Aio.class, "aio");
  }

  public Camera camera() {
    return (Camera) device("camera");
  }

  public List<Camera> cameras() {
    return all(Camera.class, "camera");
  }

  public Ptz ptz() {
    return (Ptz) device("ptz");
  }

  public List<Ptz> ptzs() {
    return all(Ptz.class, "ptz");
  }

  public Opaque opaque() {
    return (Opaque) device("opaque");
  }

  public List<Opaque> opaques() {
    return all(Opaque.class, "opaque");
  }

  public Position3d position3d() {
    return (Position3d) device("position3d");
  }

  public List<Position3d> position3ds() {
    return all(Position3d.class, "position3d");
  }

  public Imu imu() {
    return (Imu) device("imu");
  }

  public List<Imu> imus() {
    return all(Imu.class, "imu");
  }

  public Gps gps() {
    return (Gps) device("gps");
  }

  public List<Gps> gpses() {
    return all(Gps.class, "gps");
  }

  public PointCloud3d pointCloud3d() {
    return (PointCloud3d) device("pointcloud3d");
  }

  public List<PointCloud3d> pointCloud3ds() {
    return all(PointCloud3d.class, "pointcloud3d");
  }

  public Speech speech() {
    return (Speech) device("speech");
  }

  public List<Speech> speeches() {
    return all(Speech.class, "speech");
  }

  public SpeechRecognition speechRecognition() {
    return (SpeechRecognition) device("speech_recognition");
  }

  public List<SpeechRecognition> speechRecognitions() {
    return all(SpeechRecognition.class, "speech_recognition");
  }

  public Localize localize() {
    return (Localize) device("localize");
  }

  public List<Localize> localizes() {
    return all(Localize.class, "localize");
  }

  public Planner planner() {
    return (Planner) device("planner");
  }

  public List<Planner> planners() {
    return all(Planner.class, "planner");
  }

  public GridMap map() {
    return (GridMap) device("map");
  }

  public List<GridMap> maps() {
    return all(GridMap.class, "map");
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

  private <D extends Device> List<D> all(Class<D> type, String interfaceName) {
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
