// Generated from interfaces/031_simulation.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it. */
public final class SimulationMessages {
  /** The interface's code. */
  public static final int CODE = 31;

  /**
   * Not sent by any message. (player_simulation_data_t)
   *
   * @param data Without meaning.
   */
  public record Data(int data) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("simulation.Data", body, Data::read);
    }

    static Data read(Reader in) {
      int data = in.uint8();
      return new Data(data);
    }

    @Override
    public void write(Writer out) {
      out.uint8(data);
    }
  }

  /**
   * Not sent by any message. (player_simulation_cmd_t)
   *
   * @param cmd Without meaning.
   */
  public record Cmd(int cmd) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("simulation.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      int cmd = in.uint8();
      return new Cmd(cmd);
    }

    @Override
    public void write(Writer out) {
      out.uint8(cmd);
    }
  }

  /**
   * A model and its pose. (player_simulation_pose2d_req_t)
   *
   * @param name Of the model, NUL-terminated.
   * @param pose Pose of the model in its parent (the world for a top-level model); ignored in a request (in
   *     m, m, rad, frame X_PT).
   */
  public record Pose2dReq(byte[] name, CommonMessages.Pose2d pose) implements Struct {
    /** Every number 0, every list empty. */
    public Pose2dReq() {
      this(new byte[0], new CommonMessages.Pose2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pose2dReq decode(byte[] body) {
      return Reader.decode("simulation.Pose2dReq", body, Pose2dReq::read);
    }

    static Pose2dReq read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      CommonMessages.Pose2d pose = CommonMessages.Pose2d.read(in);
      return new Pose2dReq(name, pose);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      pose.write(out);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Pose2dReq that && Arrays.equals(name, that.name) && pose.equals(that.pose);
    }

    @Override
    public int hashCode() {
      return Objects.hash(pose, Arrays.hashCode(name));
    }
  }

  /**
   * A model, its pose and the time. (player_simulation_pose3d_req_t)
   *
   * @param name Of the model, NUL-terminated.
   * @param pose Pose of the model in its parent (the world for a top-level model); ignored in a request (in
   *     m, m, m, rad, rad, rad, frame X_PT).
   * @param simtime Simulated time of the pose, as counted by Stage; set in answers only (in us).
   */
  public record Pose3dReq(byte[] name, CommonMessages.Pose3d pose, double simtime) implements Struct {
    /** Every number 0, every list empty. */
    public Pose3dReq() {
      this(new byte[0], new CommonMessages.Pose3d(), 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pose3dReq decode(byte[] body) {
      return Reader.decode("simulation.Pose3dReq", body, Pose3dReq::read);
    }

    static Pose3dReq read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      double simtime = in.float64();
      return new Pose3dReq(name, pose, simtime);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      pose.write(out);
      out.float64(simtime);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Pose3dReq that && Arrays.equals(name, that.name) && pose.equals(that.pose)
          && Double.compare(simtime, that.simtime) == 0;
    }

    @Override
    public int hashCode() {
      return Objects.hash(pose, simtime, Arrays.hashCode(name));
    }
  }

  /**
   * A property of a model. (player_simulation_property_req_t)
   *
   * @param name Name of the model, NUL-terminated; empty for a property of the world.
   * @param prop Name of the property, NUL-terminated.
   * @param index Element of a list property: in a request the first one requested, in an answer the first of
   *     the next request, 0 at the end of the list.
   * @param value Bytes of the property, in a simulator-specific format; empty in a request.
   */
  public record PropertyReq(byte[] name, byte[] prop, long index, byte[] value) implements Struct {
    /** Every number 0, every list empty. */
    public PropertyReq() {
      this(new byte[0], new byte[0], 0L, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PropertyReq decode(byte[] body) {
      return Reader.decode("simulation.PropertyReq", body, PropertyReq::read);
    }

    static PropertyReq read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      long propCount = in.uint32();
      byte[] prop = in.bytes(in.length("prop", propCount, 1));
      long index = in.uint32();
      long valueCount = in.uint32();
      byte[] value = in.bytes(in.length("value", valueCount, 1));
      return new PropertyReq(name, prop, index, value);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      out.length("prop", prop.length, 33554392);
      out.length("prop", prop.length, 33554392);
      out.bytes(prop);
      out.uint32(index);
      out.length("value", value.length, 33554392);
      out.length("value", value.length, 33554392);
      out.bytes(value);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof PropertyReq that && Arrays.equals(name, that.name)
          && Arrays.equals(prop, that.prop) && index == that.index && Arrays.equals(value, that.value);
    }

    @Override
    public int hashCode() {
      return Objects.hash(index, Arrays.hashCode(name), Arrays.hashCode(prop), Arrays.hashCode(value));
    }
  }

  /** Requests the pose of a model by name. */
  public static final MessageType<Pose2dReq> REQ_GET_POSE2D =
      new MessageType<>(31, Kind.REQ, 1, "simulation.req.get_pose2d", Pose2dReq::decode);

  /** Moves a model by name. */
  public static final MessageType<Pose2dReq> REQ_SET_POSE2D =
      new MessageType<>(31, Kind.REQ, 2, "simulation.req.set_pose2d", Pose2dReq::decode);

  /** Requests the pose of a model by name, and the time. */
  public static final MessageType<Pose3dReq> REQ_GET_POSE3D =
      new MessageType<>(31, Kind.REQ, 3, "simulation.req.get_pose3d", Pose3dReq::decode);

  /** Moves a model by name. */
  public static final MessageType<Pose3dReq> REQ_SET_POSE3D =
      new MessageType<>(31, Kind.REQ, 4, "simulation.req.set_pose3d", Pose3dReq::decode);

  /**
   * Requests a property of a model by name; without a name, for "models", the list of all with their devices
   * (docs/drivers.md).
   */
  public static final MessageType<PropertyReq> REQ_GET_PROPERTY =
      new MessageType<>(31, Kind.REQ, 5, "simulation.req.get_property", PropertyReq::decode);

  /** Sets a property of a model by name. */
  public static final MessageType<PropertyReq> REQ_SET_PROPERTY =
      new MessageType<>(31, Kind.REQ, 6, "simulation.req.set_property", PropertyReq::decode);

  /** Pauses or resumes the simulated clock. */
  public static final MessageType<Nothing> CMD_PAUSE =
      new MessageType<>(31, Kind.CMD, 1, "simulation.cmd.pause", null);

  /** Resets the world to its start. */
  public static final MessageType<Nothing> CMD_RESET =
      new MessageType<>(31, Kind.CMD, 2, "simulation.cmd.reset", null);

  /** Saves the current world. */
  public static final MessageType<Nothing> CMD_SAVE =
      new MessageType<>(31, Kind.CMD, 3, "simulation.cmd.save", null);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GET_POSE2D, REQ_SET_POSE2D, REQ_GET_POSE3D, REQ_SET_POSE3D, REQ_GET_PROPERTY, REQ_SET_PROPERTY,
      CMD_PAUSE, CMD_RESET, CMD_SAVE);

  private SimulationMessages() {}
}
