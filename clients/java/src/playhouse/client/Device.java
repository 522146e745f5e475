package playhouse.client;

import java.time.Duration;
import java.util.Arrays;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.Nothing;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;

/**
 * An open device of any interface, base of the proxies for specific interfaces. Opened by a function of
 * {@link Client} or {@link Robot}; closed by {@link #close}.
 *
 * <p>Every function may throw ConnectionLostException, DeviceClosedException and DeviceGoneException; those
 * that wait for the server also RequestRefusedException, RequestTimeoutException and
 * WaitInterruptedException.
 */
public class Device implements AutoCloseable {
  private static final int LAST_INDEX = 65535;

  private final Client client;
  private final Session session;
  private final int code;
  private final int index;
  private final Access access;
  private final String driver;
  private final Map<MessageType<?>, Stamped<?>> latest = new IdentityHashMap<>();
  private DataListener listener = (message, value, time) -> {};
  private double timestamp;
  private boolean fresh;
  private boolean open;
  private String gone = "";  // why requests are refused

  Device(Opening opening) {
    client = opening.client();
    session = opening.session();
    code = codeOf(opening.interfaceName());
    index = opening.index();
    access = opening.access();
    if (index < 0 || index > LAST_INDEX) {
      throw new InvalidValueException(
          "there is no " + opening.interfaceName() + ":" + index + ": indices are 0 to " + LAST_INDEX);
    }
    driver = setAccess(access.code(), "open");
    open = true;
  }

  /** INTERFACE:INDEX, for instance "position2d:0". */
  public String name() {
    return Session.deviceName(code, index);
  }

  /** The name of its interface. */
  public String interfaceName() {
    return Catalogue.interfaceName(code);
  }

  /** The code of its interface. */
  public int code() {
    return code;
  }

  public int index() {
    return index;
  }

  public Access access() {
    return access;
  }

  /** The name of the driver behind the device. */
  public String driver() {
    return driver;
  }

  /** The server's time of the last data in s; 0 before the first. */
  public double timestamp() {
    return timestamp;
  }

  /** Whether data have arrived since the last {@link #nextData}. */
  public boolean isFresh() {
    return fresh;
  }

  /** Whether any data have arrived since this device was opened, and since the run was restarted. */
  public boolean hasData() {
    return !latest.isEmpty();
  }

  /** False after close(), of the device or of its client. */
  public boolean isOpen() {
    return open;
  }

  /**
   * Whether read() has received the notice that the server retired the device. From then on its use throws
   * DeviceGoneException, its last data remain, and close() has no effect on the server. Before, the server
   * refuses requests and drops commands.
   */
  public boolean isGone() {
    return !gone.isEmpty();
  }

  /** Sends a request without contents and waits for the answer; empty if that has none. */
  public <P extends Struct> Optional<P> request(MessageType<P> message) {
    return request(message, null);
  }

  /** Sends a request and waits for the answer; empty if that has no contents. {@code payload} may be null. */
  public <P extends Struct> Optional<P> request(MessageType<P> message, P payload) {
    return request(message, payload, session.timeout());
  }

  /** The same with a time-out of its own. */
  public <P extends Struct> Optional<P> request(MessageType<P> message, P payload, Duration timeout) {
    insistOnOpen();
    byte[] body = session.request(code, index, message, payload, timeout).body();
    return message.hasPayload() && body.length > 0 ? Optional.of(message.decode(body)) : Optional.empty();
  }

  /** Sends a command without contents; commands have no answer. */
  public void command(MessageType<Nothing> message) {
    command(message, null);
  }

  /** Sends a command; commands have no answer. */
  public <P extends Struct> void command(MessageType<P> message, P payload) {
    insistOnOpen();
    session.send(code, index, message, payload);
  }

  /** The newest value of a data message; empty before the first. */
  public <P extends Struct> Optional<P> latest(MessageType<P> message) {
    return found(message).map(Stamped::value);
  }

  /** Sets what takes all data of this device within {@link Client#read}; it replaces the one before. */
  public void onData(DataListener listener) {
    this.listener = listener;
  }

  /** Waits for data newer than those of the last call. */
  public void nextData() {
    nextData(session.timeout());
  }

  /** The same with a time-out of its own. Throws RequestTimeoutException. */
  public void nextData(Duration timeout) {
    Deadline deadline = Deadline.after(Deadline.checked(timeout));
    while (!fresh) {
      insistOnOpen();
      try {
        client.read(deadline.left());
      } catch (RequestTimeoutException error) {
        throw late(timeout);
      }
      if (!fresh && deadline.isPast()) {  // read() is busy with other devices
        throw late(timeout);
      }
    }
    fresh = false;
  }

  /** A property by its key. Throws RequestRefusedException if there is none of this key and type. */
  public boolean getBoolean(String key) {
    return property(key, "bool", CommonMessages.REQ_GET_BOOLPROP,
        new CommonMessages.BoolpropReq(Text.field(key), 0)).value() != 0;
  }

  /** A property by its key. Throws RequestRefusedException if there is none of this key and type. */
  public int getInt(String key) {
    return property(key, "int", CommonMessages.REQ_GET_INTPROP,
        new CommonMessages.IntpropReq(Text.field(key), 0)).value();
  }

  /** A property by its key. Throws RequestRefusedException if there is none of this key and type. */
  public double getDouble(String key) {
    return property(key, "double", CommonMessages.REQ_GET_DBLPROP,
        new CommonMessages.DblpropReq(Text.field(key), 0)).value();
  }

  /** A property by its key. Throws RequestRefusedException if there is none of this key and type. */
  public String getString(String key) {
    return Text.of(property(key, "string", CommonMessages.REQ_GET_STRPROP,
        new CommonMessages.StrpropReq(Text.field(key), new byte[0])).value());
  }

  /**
   * Why the driver of a position2d or planner does not drive to the goal that it was given last, as its log
   * says; empty if it does, has arrived, has not planned yet, or gives no reasons.
   */
  public String whyRefused() {
    try {
      return getString("refusal");
    } catch (RequestRefusedException error) {
      return "";
    }
  }

  /**
   * Sets a property. Throws RequestRefusedException if there is none of this key and type, or the value is
   * none for it.
   */
  public void setBoolean(String key, boolean value) {
    setProperty(key, String.valueOf(value), CommonMessages.REQ_SET_BOOLPROP,
        new CommonMessages.BoolpropReq(Text.field(key), value ? 1 : 0));
  }

  /**
   * Sets a property. Throws RequestRefusedException if there is none of this key and type, or the value is
   * none for it.
   */
  public void setInt(String key, int value) {
    setProperty(key, String.valueOf(value), CommonMessages.REQ_SET_INTPROP,
        new CommonMessages.IntpropReq(Text.field(key), value));
  }

  /**
   * Sets a property. Throws RequestRefusedException if there is none of this key and type, or the value is
   * none for it.
   */
  public void setDouble(String key, double value) {
    setProperty(key, Words.of(value), CommonMessages.REQ_SET_DBLPROP,
        new CommonMessages.DblpropReq(Text.field(key), value));
  }

  /**
   * Sets a property. Throws RequestRefusedException if there is none of this key and type, or the value is
   * none for it.
   */
  public void setString(String key, String value) {
    setProperty(key, "'" + value + "'", CommonMessages.REQ_SET_STRPROP,
        new CommonMessages.StrpropReq(Text.field(key), Text.field(value)));
  }

  /** Whether the driver reports that it supports a message. Many drivers never do. */
  public boolean hasCapability(MessageType<?> message) {
    try {
      request(CommonMessages.REQ_CAPABILITIES,
          new CommonMessages.CapabilitiesReq(message.kind().code(), message.subtype()));
    } catch (RequestRefusedException error) {
      return false;
    }
    return true;
  }

  /** Closes the device; a second call has no effect. */
  @Override
  public void close() {
    if (!open) {
      return;
    }
    open = false;
    client.forget(this);
    if (session.connection().isAlive() && !isGone()) {
      setAccess(PlayerMessages.CLOSE_MODE, "close");
    }
  }

  @Override
  public String toString() {
    return name();
  }

  /** Requests constant data for a proxy. Called after opening. */
  void prepare() {}

  /** Receives data from read(). */
  void take(MessageType<?> message, Struct value, double time) {
    latest.put(message, new Stamped<>(value, time));
    timestamp = time;
    fresh = true;
    listener.take(message, value, time);
  }

  /** Whether data of this time are earlier than the last of their kind: the simulated time went back. */
  final boolean goesBack(MessageType<?> message, double time) {
    Stamped<?> last = latest.get(message);
    return last != null && time < last.time();
  }

  /** Drops all data, as before the first: the run that they are of is over. */
  void forgetData() {
    latest.clear();
    timestamp = 0;
    fresh = false;
  }

  /** Marks the device as retired by the server, whose own port number is {@code port}. */
  void retire(long port) {
    gone = isGone() ? gone : port + ":" + name() + " is gone: the server retired it";
  }

  final Client client() {
    return client;
  }

  final Session session() {
    return session;
  }

  /** The newest value of a data message. Throws NoDataException before the first. */
  final <P extends Struct> Stamped<P> stamped(MessageType<P> message) {
    return found(message)
        .orElseThrow(() -> new NoDataException(session.peer() + ": " + name() + " " + lackOf(message)));
  }

  /** The newest of several kinds of data; of those with one time the first. */
  final Struct newestOf(MessageType<?>... kinds) {
    return Arrays.stream(kinds).filter(kind -> latest(kind).isPresent()).<Stamped<? extends Struct>>map(this::stamped)
        .max(Comparator.comparingDouble(Stamped::time)).orElseGet(() -> stamped(kinds[0])).value();
  }

  /** The first value of a list. Throws NoDataException without one. */
  final <T> T firstOf(List<T> values, String what) {
    if (values.isEmpty()) {
      throw new NoDataException(session.peer() + ": " + name() + " has no " + what);
    }
    return values.get(0);
  }

  /** Why there is no value of a data message. */
  String lackOf(MessageType<?> message) {
    if (!hasData()) {
      return "has sent no data yet; nextData() waits for them";
    }
    String sent = latest.keySet().stream().map(MessageType::name).sorted().collect(Collectors.joining(", "));
    return "sends " + sent + ", not " + message.name();
  }

  /** The answer to a request, which must have contents. */
  final <P extends Struct> P answer(MessageType<P> message) {
    return answer(message, null);
  }

  final <P extends Struct> P answer(MessageType<P> message, P payload) {
    return request(message, payload).orElseThrow(() -> new WireException("an answer came without its contents"));
  }

  final void insistOnFinite(String what, double value) {
    if (!Double.isFinite(value)) {
      throw new InvalidValueException(name() + ": " + what + " is " + Words.of(value) + ", not a finite number");
    }
  }

  final void insistOnFinite(Pose pose) {
    insistOnFinite("x", pose.x());
    insistOnFinite("y", pose.y());
    insistOnFinite("a", pose.a());
  }

  final void insistOnFinite(Pose3d pose) {
    insistOnFinite("x", pose.x());
    insistOnFinite("y", pose.y());
    insistOnFinite("z", pose.z());
    insistOnFinite("roll", pose.roll());
    insistOnFinite("pitch", pose.pitch());
    insistOnFinite("yaw", pose.yaw());
  }

  final void insistOnWhole(String what, long value, long least, long most) {
    if (value < least || value > most) {
      throw new InvalidValueException(
          name() + ": " + what + " is " + value + ", not a whole number from " + least + " to " + most);
    }
  }

  /** Finite numbers for a field of 32 bits each. */
  final float[] narrowed(String what, double[] values) {
    float[] narrow = new float[values.length];
    for (int i = 0; i < values.length; ++i) {
      narrow[i] = narrowed(what, values[i]);
    }
    return narrow;
  }

  /** A finite number for a field of 32 bits. */
  final float narrowed(String what, double value) {
    insistOnFinite(what, value);
    if (!Float.isFinite((float) value)) {
      throw new WireException("float too large to pack with f format");
    }
    return (float) value;
  }

  private static int codeOf(String interfaceName) {
    return Catalogue.interfaceCode(interfaceName).orElseThrow(() -> new InvalidValueException("there is no interface \""
        + interfaceName + "\"" + Words.didYouMean(interfaceName, Catalogue.interfaceNames())));
  }

  @SuppressWarnings("unchecked")  // take() stores a value with the message that decoded it
  private <P extends Struct> Optional<Stamped<P>> found(MessageType<P> message) {
    return Optional.ofNullable((Stamped<P>) latest.get(message));
  }

  private void insistOnOpen() {
    if (!open) {
      throw new DeviceClosedException(session.peer() + ": " + name() + " is closed");
    }
    if (isGone()) {
      throw new DeviceGoneException(gone);
    }
  }

  private RequestTimeoutException late(Duration timeout) {
    return new RequestTimeoutException(
        session.peer() + ": no data of " + name() + " in " + Words.seconds(timeout) + " s");
  }

  private <P extends Struct> P property(String key, String type, MessageType<P> get, P question) {
    Optional<P> answer = Optional.empty();
    try {
      answer = request(get, question);
    } catch (RequestRefusedException error) {
      // told as an answer without contents
    }
    return answer.orElseThrow(() -> new RequestRefusedException(
        session.peer() + ": " + name() + " has no " + type + " property \"" + key + "\""));
  }

  private <P extends Struct> void setProperty(String key, String shown, MessageType<P> set, P body) {
    try {
      request(set, body);
    } catch (RequestRefusedException error) {
      throw new RequestRefusedException(session.peer() + ": " + name() + " refuses " + shown + " as \"" + key + "\"");
    }
  }

  /** Opens or closes; returns the name of the driver. */
  private String setAccess(int wanted, String verb) {
    CommonMessages.Devaddr address = new CommonMessages.Devaddr(0, 0, code, index);
    PlayerMessages.DeviceReq body = new PlayerMessages.DeviceReq(address, wanted, new byte[0]);
    Message answer;
    try {
      answer = session.request(PlayerMessages.CODE, 0, PlayerMessages.REQ_DEV, body, session.timeout());
    } catch (RequestRefusedException error) {
      throw new RequestRefusedException(session.peer() + ": there is no " + name() + " to " + verb);
    } catch (RequestTimeoutException error) {
      throw new RequestTimeoutException(session.peer() + ": no answer in time: " + verb + " " + name());
    }
    PlayerMessages.DeviceReq granted = PlayerMessages.DeviceReq.decode(answer.body());
    if (granted.access() == PlayerMessages.ERROR_MODE) {
      throw new RequestRefusedException(session.peer() + ": cannot " + verb + " " + name());
    }
    return Text.of(granted.driverName());
  }
}
