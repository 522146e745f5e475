// Generated from interfaces/066_coopobject.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that report to
 * each other.
 */
public final class CoopobjectMessages {
  /** The interface's code. */
  public static final int CODE = 66;

  // Values of Header.origin.
  public static final int ORIGIN_STATICBASE = 0;
  public static final int ORIGIN_MOBILEBASE = 1;
  public static final int ORIGIN_MOTE = 2;
  public static final int ORIGIN_ROBOT = 3;

  // Types of messages between nodes.
  public static final int MSG_NONE = -1;
  public static final int MSG_HEALTH = 0;
  public static final int MSG_POSITION = 1;
  public static final int MSG_RSSI = 2;
  public static final int MSG_SENSOR = 3;
  public static final int MSG_ALARM = 4;
  public static final int MSG_REQUEST = 5;
  public static final int MSG_COMMAND = 6;

  // Values of Sensor.type.
  public static final int TEMPERATURE = 0;
  public static final int HUMIDITY = 1;
  public static final int PRESSURE = 2;
  public static final int LIGHT_1 = 3;
  public static final int LIGHT_2 = 4;
  public static final int ACCEL_X = 5;
  public static final int ACCEL_Y = 6;
  public static final int ACCEL_Z = 7;
  public static final int MAGNETOMETER_X = 8;
  public static final int MAGNETOMETER_Y = 9;
  public static final int MAGNETOMETER_Z = 10;
  public static final int COMPASS = 11;
  public static final int CO = 12;
  public static final int CO2 = 13;
  public static final int H2 = 14;
  public static final int SMOKE = 15;
  public static final int OPTSWITCH = 16;

  /**
   * Id of the node. (player_coopobject_header_t)
   *
   * @param origin Type of node.
   * @param id Id.
   * @param parentId Node that relayed the message.
   */
  public record Header(int origin, int id, int parentId) implements Struct {
    /** Every number 0, every list empty. */
    public Header() {
      this(0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Header decode(byte[] body) {
      return Reader.decode("coopobject.Header", body, Header::read);
    }

    static Header read(Reader in) {
      int origin = in.uint8();
      int id = in.uint16();
      int parentId = in.uint16();
      return new Header(origin, id, parentId);
    }

    @Override
    public void write(Writer out) {
      out.uint8(origin);
      out.uint16(id);
      out.uint16(parentId);
    }
  }

  /**
   * Radio signal strength. (player_coopobject_rssi_t)
   *
   * @param header Header.
   * @param senderId Node that sent the signal.
   * @param rssi As the radio reports it.
   * @param stamp Counter of measurements.
   * @param nodeTimeHigh Clock of the node: upper half.
   * @param nodeTimeLow Clock of the node: lower half.
   * @param x Position of the receiver (in m, frame p_WS).
   * @param y In m, frame p_WS.
   * @param z In m, frame p_WS.
   */
  public record Rssi(
      Header header, int senderId, int rssi, int stamp, @WireName("nodeTimeHigh") long nodeTimeHigh,
      @WireName("nodeTimeLow") long nodeTimeLow, float x, float y, float z)
      implements Struct {
    /** Every number 0, every list empty. */
    public Rssi() {
      this(new Header(), 0, 0, 0, 0L, 0L, 0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Rssi decode(byte[] body) {
      return Reader.decode("coopobject.Rssi", body, Rssi::read);
    }

    static Rssi read(Reader in) {
      Header header = Header.read(in);
      int senderId = in.uint16();
      int rssi = in.uint16();
      int stamp = in.uint16();
      long nodeTimeHigh = in.uint32();
      long nodeTimeLow = in.uint32();
      float x = in.float32();
      float y = in.float32();
      float z = in.float32();
      return new Rssi(header, senderId, rssi, stamp, nodeTimeHigh, nodeTimeLow, x, y, z);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.uint16(senderId);
      out.uint16(rssi);
      out.uint16(stamp);
      out.uint32(nodeTimeHigh);
      out.uint32(nodeTimeLow);
      out.float32(x);
      out.float32(y);
      out.float32(z);
    }
  }

  /**
   * Position of a node. (player_coopobject_position_t)
   *
   * @param header Header.
   * @param x In m, frame p_WS.
   * @param y In m, frame p_WS.
   * @param z In m, frame p_WS.
   * @param status Driver-specific.
   */
  public record Position(Header header, float x, float y, float z, int status) implements Struct {
    /** Every number 0, every list empty. */
    public Position() {
      this(new Header(), 0f, 0f, 0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Position decode(byte[] body) {
      return Reader.decode("coopobject.Position", body, Position::read);
    }

    static Position read(Reader in) {
      Header header = Header.read(in);
      float x = in.float32();
      float y = in.float32();
      float z = in.float32();
      int status = in.uint8();
      return new Position(header, x, y, z, status);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.float32(x);
      out.float32(y);
      out.float32(z);
      out.uint8(status);
    }
  }

  /**
   * One reading. (player_coopobject_sensor_t)
   *
   * @param type Measured quantity.
   * @param value As the sensor reports it.
   */
  public record Sensor(int type, int value) implements Struct {
    /** Every number 0, every list empty. */
    public Sensor() {
      this(0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Sensor decode(byte[] body) {
      return Reader.decode("coopobject.Sensor", body, Sensor::read);
    }

    static Sensor read(Reader in) {
      int type = in.uint8();
      int value = in.int16();
      return new Sensor(type, value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(type);
      out.int16(value);
    }
  }

  /**
   * Readings of a node. (player_coopobject_data_sensor_t)
   *
   * @param header Header.
   * @param data Data.
   */
  public record DataSensor(Header header, List<Sensor> data) implements Struct {
    /** Every number 0, every list empty. */
    public DataSensor() {
      this(new Header(), List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataSensor decode(byte[] body) {
      return Reader.decode("coopobject.DataSensor", body, DataSensor::read);
    }

    static DataSensor read(Reader in) {
      Header header = Header.read(in);
      long dataCount = in.uint32();
      List<Sensor> data = in.structs(in.length("data", dataCount, 8), Sensor::read);
      return new DataSensor(header, data);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.length("data", data.size(), 4194299);
      out.length("data", data.size(), 4194299);
      out.structs(data);
    }
  }

  /**
   * Bytes from or to a node. (player_coopobject_data_userdefined_t)
   *
   * @param header Header.
   * @param type User-specific.
   * @param data Data.
   */
  public record DataUserdefined(Header header, int type, byte[] data) implements Struct {
    /** Every number 0, every list empty. */
    public DataUserdefined() {
      this(new Header(), 0, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataUserdefined decode(byte[] body) {
      return Reader.decode("coopobject.DataUserdefined", body, DataUserdefined::read);
    }

    static DataUserdefined read(Reader in) {
      Header header = Header.read(in);
      int type = in.uint8();
      long dataCount = in.uint32();
      byte[] data = in.bytes(in.length("data", dataCount, 1));
      return new DataUserdefined(header, type, data);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.uint8(type);
      out.length("data", data.length, 33554392);
      out.length("data", data.length, 33554392);
      out.bytes(data);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DataUserdefined that && header.equals(that.header) && type == that.type
          && Arrays.equals(data, that.data);
    }

    @Override
    public int hashCode() {
      return Objects.hash(header, type, Arrays.hashCode(data));
    }
  }

  /**
   * A request. (player_coopobject_req_t)
   *
   * @param header Header.
   * @param request Which.
   * @param parameters Request-specific.
   */
  public record Req(Header header, int request, byte[] parameters) implements Struct {
    /** Every number 0, every list empty. */
    public Req() {
      this(new Header(), 0, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Req decode(byte[] body) {
      return Reader.decode("coopobject.Req", body, Req::read);
    }

    static Req read(Reader in) {
      Header header = Header.read(in);
      int request = in.uint8();
      long parametersCount = in.uint32();
      byte[] parameters = in.bytes(in.length("parameters", parametersCount, 1));
      return new Req(header, request, parameters);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.uint8(request);
      out.length("parameters", parameters.length, 33554392);
      out.length("parameters", parameters.length, 33554392);
      out.bytes(parameters);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Req that && header.equals(that.header) && request == that.request
          && Arrays.equals(parameters, that.parameters);
    }

    @Override
    public int hashCode() {
      return Objects.hash(header, request, Arrays.hashCode(parameters));
    }
  }

  /**
   * A command. (player_coopobject_cmd_t)
   *
   * @param header Header.
   * @param command Which.
   * @param parameters Command-specific.
   */
  public record Cmd(Header header, int command, byte[] parameters) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(new Header(), 0, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("coopobject.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      Header header = Header.read(in);
      int command = in.uint8();
      long parametersCount = in.uint32();
      byte[] parameters = in.bytes(in.length("parameters", parametersCount, 1));
      return new Cmd(header, command, parameters);
    }

    @Override
    public void write(Writer out) {
      header.write(out);
      out.uint8(command);
      out.length("parameters", parameters.length, 33554392);
      out.length("parameters", parameters.length, 33554392);
      out.bytes(parameters);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Cmd that && header.equals(that.header) && command == that.command
          && Arrays.equals(parameters, that.parameters);
    }

    @Override
    public int hashCode() {
      return Objects.hash(header, command, Arrays.hashCode(parameters));
    }
  }

  /** A node is alive. */
  public static final MessageType<Header> DATA_HEALTH =
      new MessageType<>(66, Kind.DATA, 1, "coopobject.data.health", Header::decode);

  /** Signal strength received by a node. */
  public static final MessageType<Rssi> DATA_RSSI =
      new MessageType<>(66, Kind.DATA, 2, "coopobject.data.rssi", Rssi::decode);

  /** Readings of a node. */
  public static final MessageType<DataSensor> DATA_SENSOR =
      new MessageType<>(66, Kind.DATA, 3, "coopobject.data.sensor", DataSensor::decode);

  /** Readings of a node that crossed a threshold. */
  public static final MessageType<DataSensor> DATA_ALARM =
      new MessageType<>(66, Kind.DATA, 4, "coopobject.data.alarm", DataSensor::decode);

  /** Bytes from a node. */
  public static final MessageType<DataUserdefined> DATA_USERDEFINED =
      new MessageType<>(66, Kind.DATA, 5, "coopobject.data.userdefined", DataUserdefined::decode);

  /** A request of a node. */
  public static final MessageType<Req> DATA_REQUEST =
      new MessageType<>(66, Kind.DATA, 6, "coopobject.data.request", Req::decode);

  /** A command of a node. */
  public static final MessageType<Cmd> DATA_COMMAND =
      new MessageType<>(66, Kind.DATA, 7, "coopobject.data.command", Cmd::decode);

  /** Position of a node. */
  public static final MessageType<Position> DATA_POSITION =
      new MessageType<>(66, Kind.DATA, 8, "coopobject.data.position", Position::decode);

  /** Sends a command to a node. */
  public static final MessageType<Cmd> CMD_STANDARD =
      new MessageType<>(66, Kind.CMD, 1, "coopobject.cmd.standard", Cmd::decode);

  /** Sends bytes to a node. */
  public static final MessageType<DataUserdefined> CMD_DATA =
      new MessageType<>(66, Kind.CMD, 2, "coopobject.cmd.data", DataUserdefined::decode);

  /** Sends the position of a node to a node. */
  public static final MessageType<Position> CMD_POSITION =
      new MessageType<>(66, Kind.CMD, 3, "coopobject.cmd.position", Position::decode);

  /** Sends a request to a node. */
  public static final MessageType<Req> REQ_STANDARD =
      new MessageType<>(66, Kind.REQ, 1, "coopobject.req.standard", Req::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_HEALTH, DATA_RSSI, DATA_SENSOR, DATA_ALARM, DATA_USERDEFINED, DATA_REQUEST, DATA_COMMAND,
      DATA_POSITION, CMD_STANDARD, CMD_DATA, CMD_POSITION, REQ_STANDARD);

  private CoopobjectMessages() {}
}
