package playhouse.client;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntPredicate;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Header;
import playhouse.client.wire.Kind;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.SimulationMessages;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;

/**
 * A connection to a Player server, and requests to the server itself.
 *
 * <p>A client and its devices are for one thread at a time. A thread that waits in them can be interrupted:
 * WaitInterruptedException. Closing the client closes its devices first, and moving robots are stopped.
 */
public final class Client extends Openers implements AutoCloseable {
  /** Not localhost: a machine without /etc/hosts cannot resolve it. */
  public static final String DEFAULT_HOST = "127.0.0.1";

  public static final int DEFAULT_PORT = 6665;

  private static final int TOKEN_BYTES = 32;
  private static final Duration LONGEST_CLOSING = Duration.ofSeconds(1);

  /** Where a device is, in the list of devices and in that of models. */
  private record Place(long port, String interfaceName, int index) {}

  /** The model behind a device, and its top-level model. */
  private record Owner(String model, String robot) {}

  /** A robot stays the same object as long as these stay the same. */
  private record RobotKey(String name, List<DeviceAddress> devices) {}

  private final Session session;
  private final Map<Long, List<Device>> devices = new LinkedHashMap<>();  // by address
  private final Map<RobotKey, Robot> robots = new HashMap<>();
  private List<List<Model>> families = List.of();  // as of the last query
  private boolean reading;
  private Mode mode = Mode.PUSH;  // initial mode of a server

  /**
   * Connects to a server. Throws ConnectionLostException if there is none, WaitInterruptedException, and
   * InvalidValueException for a negative time-out or a token of more than 32 bytes, and RequestRefusedException for a
   * wrong token.
   */
  public Client(String host, int port, Options options) {
    session = new Session(new Connection(host, port, options.timeout()), options.timeout(), this::retire);
    try {
      if (!options.token().isEmpty()) {
        authenticate(options.token());
      }
      if (options.mode() != Mode.PUSH) {
        setMode(options.mode());
      }
    } catch (PlayerException error) {
      close();
      throw error;
    }
  }

  /** Connects to "host", "host:port", ":port" or "[::1]:port"; the defaults are 127.0.0.1 and 6665. */
  public static Client connect(String address) {
    return connect(address, Options.DEFAULT);
  }

  /** The same with other options than those by default. */
  public static Client connect(String address, Options options) {
    boolean bracketed = address.startsWith("[");  // an IPv6 host
    int end = bracketed ? address.indexOf(']') + 1 : address.lastIndexOf(':');
    end = end < (bracketed ? 1 : 0) ? address.length() : end;
    String port = end == address.length() ? Integer.toString(DEFAULT_PORT) : address.substring(end + 1);
    if (!port.matches("[0-9]{1,5}") || Integer.parseInt(port) < 1 || Integer.parseInt(port) > 65535) {
      throw new ConnectionLostException("\"" + address + "\" is not HOST or HOST:PORT");
    }
    String host = bracketed ? address.substring(1, end).replace("]", "") : address.substring(0, end);
    return new Client(host.isEmpty() ? DEFAULT_HOST : host, Integer.parseInt(port), options);
  }

  /** The server's greeting, for instance "Player v.3.1". */
  public String banner() {
    return session.connection().banner();
  }

  public boolean isConnected() {
    return session.connection().isAlive();
  }

  public Mode mode() {
    return mode;
  }

  /** Data messages dropped because they were not read in time, here or in the server. */
  public long overflowCount() {
    return session.overflowCount();
  }

  /**
   * Queries the number of data messages lost on the way to this client, in any mode: the server's count plus
   * those not read here in time. Throws RequestRefusedException if the server does not report it.
   */
  public long lostCount() {
    CommonMessages.IntpropReq question = new CommonMessages.IntpropReq(Text.field("lost"), 0);
    Message answer = request(CommonMessages.REQ_GET_INTPROP, question);
    return CommonMessages.IntpropReq.decode(answer.body()).value() + session.unreadCount();
  }

  /** Messages without a recipient, and invalid messages. */
  public long skippedCount() {
    return session.skippedCount();
  }

  /** The devices of the server, in its own order, with the driver and the model behind each. */
  public List<DeviceEntry> devices() {
    Message answer = request(PlayerMessages.REQ_DEVLIST, null);
    List<CommonMessages.Devaddr> listed = PlayerMessages.DeviceDevlist.decode(answer.body()).devices();
    boolean simulated = listed.stream().anyMatch(address -> address.interf() == SimulationMessages.CODE);
    Map<Place, Owner> owners = simulated ? findOwners() : Map.of();
    return listed.stream().map(address -> describe(address, owners)).toList();
  }

  public void setMode(Mode wanted) {
    request(PlayerMessages.REQ_DATAMODE, new PlayerMessages.DeviceDatamodeReq(wanted.code()));
    mode = wanted;
  }

  /** Sets the server's rule for all messages queued for this client. */
  public void setReplaceRule(Rule rule) {
    setReplaceRule(rule, -1, -1, -1, -1);
  }

  /**
   * Sets the server's rule for messages queued for this client; -1 matches any interface, index, kind and
   * subtype.
   */
  public void setReplaceRule(Rule rule, int interfaceCode, int index, int kind, int subtype) {
    request(PlayerMessages.REQ_ADD_REPLACE_RULE,
        new PlayerMessages.AddReplaceRuleReq(interfaceCode, index, kind, subtype, rule.code()));
  }

  /** The same as read(Duration) with the client's own time-out. */
  public int read() {
    return read(session.timeout());
  }

  /**
   * Waits for data and delivers them to the devices; returns the number of messages.
   *
   * <p>In pull mode this is one round: everything the server has queued for this client. In push mode it is
   * what has arrived, at least one message, or none if a device was retired before (Device.isGone). Throws
   * RequestTimeoutException without data; the next read() continues to wait. If the server disconnects, data
   * it had sent are delivered first; the next read() throws ConnectionLostException.
   */
  public int read(Duration timeout) {
    if (reading) {
      throw new PlayerException("read() was called from a callback that read() itself is running");
    }
    Deadline deadline = Deadline.after(Deadline.checked(timeout));
    reading = true;
    session.forgetNotices();
    try {
      return mode == Mode.PULL ? readRound(deadline) : readPushed(deadline);
    } finally {
      reading = false;
    }
  }

  /** Opens a device of any interface for everything, as the proxy of that interface if there is one. */
  public Device device(String interfaceName, int index) {
    return device(interfaceName, index, Access.ALL);
  }

  /**
   * Opens a device of any interface, as the proxy of that interface if there is one. This and the functions
   * below throw RequestRefusedException if there is no such device, and InvalidValueException for an unknown
   * interface or an invalid index.
   */
  public Device device(String interfaceName, int index, Access access) {
    return open(PROXIES.getOrDefault(interfaceName, Device::new), interfaceName, index, access);
  }

  /**
   * All models in the simulated world now, with their devices, parents before children. Throws
   * RequestRefusedException if the server does not report models (not every simulator does, and no real
   * robot).
   */
  public List<Model> models() {
    return listFamilies().stream().map(family -> family.get(0)).toList();
  }

  /**
   * The robot, or any other model, of this name, with the devices of all its descendants. It is looked up in
   * the last list of models() or robots(), and if it is not there, in a new list.
   *
   * <p>The same name gives the same Robot object while its devices are the same; of several models with one
   * name it is the last. Throws RequestRefusedException if there is none, and as models().
   */
  public Robot robot(String name) {
    List<Model> family = lastNamed(name).or(() -> {
      listFamilies();
      return lastNamed(name);
    }).orElseThrow(() -> {
      List<String> names = families.stream().map(each -> each.get(0).name()).toList();
      return new RequestRefusedException(
          "there is no robot \"" + name + "\" at " + session.peer() + Words.didYouMean(name, names));
    });
    return robotOf(family);
  }

  /**
   * The top-level models with devices on this connection, of their own or of descendants, in the order of the
   * world file. Throws RequestRefusedException as models().
   */
  public List<Robot> robots() {
    return listFamilies().stream().filter(family -> family.get(0).parent().isEmpty()).map(this::robotOf)
        .filter(robot -> robot.devices().stream().anyMatch(at -> at.port() == session.serverPort())).toList();
  }

  /** Closes all devices in reverse order of opening, and waits until the server has read everything. */
  @Override
  public void close() {
    List<Device> opened = new ArrayList<>();
    devices.values().forEach(opened::addAll);
    Collections.reverse(opened);
    boolean interrupted = false;
    for (Device device : opened) {
      try {
        device.close();
      } catch (WaitInterruptedException error) {
        interrupted = true;
      } catch (PlayerException error) {
        // closing the connection closes it as well
      }
    }
    session.connection().close(LONGEST_CLOSING);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** In push mode, delivers data that have arrived to the devices, without waiting for more. */
  void deliverPushed() {
    if (mode != Mode.PUSH || reading) {
      return;
    }
    reading = true;
    try {
      deliver();
    } finally {
      reading = false;
    }
  }

  /** Drops all data received so far: the run that they are of is over. Called by Simulation.reset(). */
  void forgetRun() {
    session.dropWaiting();
    forgetLater(Double.NEGATIVE_INFINITY);
  }

  /** Removes a closed device from the list; called by Device.close(). */
  void forget(Device device) {
    List<Device> same = devices.getOrDefault(address(device.code(), device.index()), List.of());
    if (!same.remove(device) || !same.isEmpty()) {
      return;
    }
    devices.remove(address(device.code(), device.index()));
    if (device.isGone()) {
      session.dropWaiting(device.code(), device.index());
    }
  }

  private static long address(long interfaceCode, int index) {
    return interfaceCode << 16 | index;
  }

  private void authenticate(String token) {
    byte[] key = token.getBytes(StandardCharsets.UTF_8);
    if (key.length > TOKEN_BYTES) {
      throw new InvalidValueException("a token has " + TOKEN_BYTES + " letters at most, not " + key.length);
    }
    try {
      request(PlayerMessages.REQ_AUTH, new PlayerMessages.DeviceAuthReq(key));
    } catch (RequestRefusedException error) {
      throw new RequestRefusedException(session.peer() + ": the token is refused; a run without --guests needs none");
    }
  }

  private Message request(MessageType<?> message, Struct payload) {
    return session.request(PlayerMessages.CODE, 0, message, payload, session.timeout());
  }

  private DeviceEntry describe(CommonMessages.Devaddr address, Map<Place, Owner> owners) {
    CommonMessages.Devaddr here = new CommonMessages.Devaddr(0, 0, address.interf(), address.index());
    String driver = "";
    try {
      Message answer = request(PlayerMessages.REQ_DRIVERINFO, new PlayerMessages.DeviceDriverinfo(here, new byte[0]));
      driver = Text.of(PlayerMessages.DeviceDriverinfo.decode(answer.body()).driverName());
    } catch (RequestRefusedException | WireException error) {
      // the server does not tell
    }
    String name = Catalogue.interfaceName(address.interf());
    Owner owner = owners.getOrDefault(new Place(address.robot(), name, address.index()), new Owner("", ""));
    return new DeviceEntry(name, address.index(), driver, owner.model(), owner.robot());
  }

  /** The model behind each device and its top-level model; empty if the server does not report models. */
  private Map<Place, Owner> findOwners() {
    Map<Place, Owner> owners = new HashMap<>();
    try {
      for (List<Model> family : listFamilies()) {
        if (!family.get(0).parent().isEmpty()) {
          continue;
        }
        for (Model model : family) {
          model.devices().forEach(at -> owners.put(
              new Place(at.port(), at.interfaceName(), at.index()), new Owner(at.model(), family.get(0).name())));
        }
      }
    } catch (RequestRefusedException error) {
      // models stay unknown
    }
    return owners;
  }

  /** All current models, each with its descendants. */
  private List<List<Model>> listFamilies() {
    try (Simulation simulator = simulation(0)) {
      families = ModelList.families(ModelList.request(simulator));
    } catch (RequestRefusedException error) {
      throw new RequestRefusedException(
          session.peer() + ": this server does not tell the names of models; open devices by number");
    }
    return families;
  }

  private Optional<List<Model>> lastNamed(String name) {
    return families.stream().filter(family -> family.get(0).name().equals(name)).reduce((first, second) -> second);
  }

  private Robot robotOf(List<Model> family) {
    List<DeviceAddress> all = family.stream().flatMap(model -> model.devices().stream()).toList();
    return robots.computeIfAbsent(
        new RobotKey(family.get(0).name(), all), key -> new Robot(this, family, session.serverPort()));
  }

  /** Drops the data of devices whose last are later than this time: of a run that is over when time goes back. */
  private void forgetLater(double time) {
    devices.values().stream().flatMap(List::stream).filter(device -> device.timestamp() > time)
        .forEach(Device::forgetData);
  }

  private void retire(CommonMessages.Devaddr at) {
    devices.getOrDefault(address(at.interf(), at.index()), List.of()).forEach(device -> device.retire(at.robot()));
  }

  @Override
  <D extends Device> D open(Function<Opening, D> make, String interfaceName, int index, Access access) {
    D device = make.apply(new Opening(this, session, interfaceName, index, access));
    List<Device> same = devices.computeIfAbsent(address(device.code(), index), at -> new ArrayList<>());
    if (same.stream().anyMatch(Device::isGone)) {
      session.dropWaiting(device.code(), index);
    }
    same.add(device);
    try {
      device.prepare();
    } catch (RequestRefusedException error) {
      // it works without the results
    } catch (PlayerException error) {
      device.close();
      throw error;
    }
    return device;
  }

  private int readRound(Deadline deadline) {
    session.beginRound();
    int delivered = receive(deadline, count -> session.roundIsOpen());
    if (session.roundWasRefused() && delivered == 0) {
      throw new RequestRefusedException(session.peer() + ": the server refuses to send data");
    }
    return delivered;
  }

  private int readPushed(Deadline deadline) {
    return receive(deadline, count -> count == 0 || session.connection().hasMessage());
  }

  /**
   * Delivers queued messages, and new ones while {@code more} holds for the count so far; returns the number
   * of messages. A disconnection after data is left to the next call, so that the data are delivered first.
   */
  private int receive(Deadline deadline, IntPredicate more) {
    int delivered = deliver();
    while (more.test(delivered) && !(session.wasTold() && delivered == 0)) {
      try {
        session.sortNext(deadline);
      } catch (RequestTimeoutException error) {
        if (delivered > 0) {
          break;
        }
        throw new RequestTimeoutException(session.peer() + ": no data in time");
      } catch (ConnectionLostException error) {
        if (delivered > 0) {
          break;
        }
        throw error;
      }
      delivered += deliver();
    }
    return delivered;
  }

  private int deliver() {
    int count = 0;
    for (Message message = session.nextWaiting(); message != null; message = session.nextWaiting()) {
      if (deliver(message)) {
        ++count;
      } else {
        session.skip();
      }
    }
    return count;
  }

  /** Whether the message makes sense and a device takes it. */
  private boolean deliver(Message message) {
    Header header = message.header();
    List<Device> takers = devices.getOrDefault(address(header.interfaceCode(), header.index()), List.of());
    MessageType<?> row = Catalogue.find(header.interfaceCode(), Kind.DATA.code(), header.subtype()).orElse(null);
    if (takers.isEmpty() || row == null || !row.hasPayload()) {
      return false;
    }
    Struct value;
    try {
      value = row.decode(message.body());
    } catch (WireException error) {
      return false;
    }
    if (takers.stream().anyMatch(device -> device.goesBack(row, header.timestamp()))) {
      forgetLater(header.timestamp());  // another client restarted or rewound the run
    }
    // The last data of a retired device belong to it, unless a new device has its address.
    List<Device> here = takers.stream().filter(device -> !device.isGone()).toList();
    for (Device device : here.isEmpty() ? List.copyOf(takers) : here) {
      device.take(row, value, header.timestamp());
    }
    return true;
  }
}
