// Generated from interfaces/057_wsn.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface wsn, code 57. A network of wireless sensor nodes. */
public final class WsnMessages {
  /** The interface's code. */
  public static final int CODE = 57;

  /**
   * Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t)
   *
   * @param light In 1 or lx.
   * @param mic Mic.
   * @param accelX In 1 or m/s^2.
   * @param accelY In 1 or m/s^2.
   * @param accelZ In 1 or m/s^2.
   * @param magnX In 1 or G.
   * @param magnY In 1 or G.
   * @param magnZ In 1 or G.
   * @param temperature In 1 or degC.
   * @param battery In 1 or V.
   */
  public record NodeData(
      float light, float mic, float accelX, float accelY, float accelZ, float magnX, float magnY, float magnZ,
      float temperature, float battery)
      implements Struct {
    /** Every number 0, every list empty. */
    public NodeData() {
      this(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static NodeData decode(byte[] body) {
      return Reader.decode("wsn.NodeData", body, NodeData::read);
    }

    static NodeData read(Reader in) {
      float light = in.float32();
      float mic = in.float32();
      float accelX = in.float32();
      float accelY = in.float32();
      float accelZ = in.float32();
      float magnX = in.float32();
      float magnY = in.float32();
      float magnZ = in.float32();
      float temperature = in.float32();
      float battery = in.float32();
      return new NodeData(light, mic, accelX, accelY, accelZ, magnX, magnY, magnZ, temperature, battery);
    }

    @Override
    public void write(Writer out) {
      out.float32(light);
      out.float32(mic);
      out.float32(accelX);
      out.float32(accelY);
      out.float32(accelZ);
      out.float32(magnX);
      out.float32(magnY);
      out.float32(magnZ);
      out.float32(temperature);
      out.float32(battery);
    }
  }

  /**
   * Readings of one node. (player_wsn_data_t)
   *
   * @param nodeType Type of node.
   * @param nodeId Id of the node.
   * @param nodeParentId Node that relayed the readings.
   * @param dataPacket Data packet.
   */
  public record Data(long nodeType, long nodeId, long nodeParentId, NodeData dataPacket) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L, 0L, new NodeData());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("wsn.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long nodeType = in.uint32();
      long nodeId = in.uint32();
      long nodeParentId = in.uint32();
      NodeData dataPacket = NodeData.read(in);
      return new Data(nodeType, nodeId, nodeParentId, dataPacket);
    }

    @Override
    public void write(Writer out) {
      out.uint32(nodeType);
      out.uint32(nodeId);
      out.uint32(nodeParentId);
      dataPacket.write(out);
    }
  }

  /**
   * Switch of an actuator of a node. (player_wsn_cmd_t)
   *
   * @param nodeId Id of the node; -1: all.
   * @param groupId Group of the node; -1: all.
   * @param device Actuator, such as a light or a buzzer.
   * @param enable 1: on, 0: off.
   */
  public record Cmd(int nodeId, int groupId, long device, int enable) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0, 0, 0L, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("wsn.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      int nodeId = in.int32();
      int groupId = in.int32();
      long device = in.uint32();
      int enable = in.uint8();
      return new Cmd(nodeId, groupId, device, enable);
    }

    @Override
    public void write(Writer out) {
      out.int32(nodeId);
      out.int32(groupId);
      out.uint32(device);
      out.uint8(enable);
    }
  }

  /**
   * Sleep mode of nodes. (player_wsn_power_config_t)
   *
   * @param nodeId Id of the node; -1: all.
   * @param groupId Group of the node; -1: all.
   * @param value 0: asleep, 1: awake, 2: driver-specific.
   */
  public record PowerConfig(int nodeId, int groupId, int value) implements Struct {
    /** Every number 0, every list empty. */
    public PowerConfig() {
      this(0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerConfig decode(byte[] body) {
      return Reader.decode("wsn.PowerConfig", body, PowerConfig::read);
    }

    static PowerConfig read(Reader in) {
      int nodeId = in.int32();
      int groupId = in.int32();
      int value = in.uint8();
      return new PowerConfig(nodeId, groupId, value);
    }

    @Override
    public void write(Writer out) {
      out.int32(nodeId);
      out.int32(groupId);
      out.uint8(value);
    }
  }

  /**
   * Format of readings. (player_wsn_datatype_config_t)
   *
   * @param value 0: raw, 1: converted.
   */
  public record DatatypeConfig(int value) implements Struct {
    /** Every number 0, every list empty. */
    public DatatypeConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DatatypeConfig decode(byte[] body) {
      return Reader.decode("wsn.DatatypeConfig", body, DatatypeConfig::read);
    }

    static DatatypeConfig read(Reader in) {
      int value = in.uint8();
      return new DatatypeConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * Rate of reports. (player_wsn_datafreq_config_t)
   *
   * @param nodeId Id of the node; -1: all.
   * @param groupId Group of the node; -1: all.
   * @param frequency In Hz.
   */
  public record DatafreqConfig(int nodeId, int groupId, double frequency) implements Struct {
    /** Every number 0, every list empty. */
    public DatafreqConfig() {
      this(0, 0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DatafreqConfig decode(byte[] body) {
      return Reader.decode("wsn.DatafreqConfig", body, DatafreqConfig::read);
    }

    static DatafreqConfig read(Reader in) {
      int nodeId = in.int32();
      int groupId = in.int32();
      double frequency = in.float64();
      return new DatafreqConfig(nodeId, groupId, frequency);
    }

    @Override
    public void write(Writer out) {
      out.int32(nodeId);
      out.int32(groupId);
      out.float64(frequency);
    }
  }

  /** Readings of one node. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(57, Kind.DATA, 1, "wsn.data.state", Data::decode);

  /** Switches an actuator of a node. */
  public static final MessageType<Cmd> CMD_DEVSTATE =
      new MessageType<>(57, Kind.CMD, 1, "wsn.cmd.devstate", Cmd::decode);

  /** Puts nodes to sleep or wakes them. */
  public static final MessageType<PowerConfig> REQ_POWER =
      new MessageType<>(57, Kind.REQ, 1, "wsn.req.power", PowerConfig::decode);

  /** Selects between raw and converted readings. */
  public static final MessageType<DatatypeConfig> REQ_DATATYPE =
      new MessageType<>(57, Kind.REQ, 2, "wsn.req.datatype", DatatypeConfig::decode);

  /** Sets the reporting rate of nodes. */
  public static final MessageType<DatafreqConfig> REQ_DATAFREQ =
      new MessageType<>(57, Kind.REQ, 3, "wsn.req.datafreq", DatafreqConfig::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, CMD_DEVSTATE, REQ_POWER, REQ_DATATYPE, REQ_DATAFREQ);

  private WsnMessages() {}
}
