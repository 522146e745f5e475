// Generated from interfaces/054_limb.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface limb, code 54. An arm controlled by the pose of its end effector. */
public final class LimbMessages {
  /** The interface's code. */
  public static final int CODE = 54;

  // Values of Data.state.
  public static final int STATE_IDLE = 1;
  public static final int STATE_BRAKED = 2;
  public static final int STATE_MOVING = 3;
  public static final int STATE_OOR = 4;
  public static final int STATE_COLL = 5;

  /**
   * Pose of the end effector. (player_limb_data_t)
   *
   * @param position In m, frame p_BE.
   * @param approach Approach direction, a unit vector (frame n_B).
   * @param orientation Unit vector across the end effector (frame n_B).
   * @param state Idle, braked, moving, out of reach or in contact.
   */
  public record Data(
      CommonMessages.Point3d position, CommonMessages.Point3d approach, CommonMessages.Point3d orientation,
      int state)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new CommonMessages.Point3d(), new CommonMessages.Point3d(), new CommonMessages.Point3d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("limb.Data", body, Data::read);
    }

    static Data read(Reader in) {
      CommonMessages.Point3d position = CommonMessages.Point3d.read(in);
      CommonMessages.Point3d approach = CommonMessages.Point3d.read(in);
      CommonMessages.Point3d orientation = CommonMessages.Point3d.read(in);
      int state = in.uint8();
      return new Data(position, approach, orientation, state);
    }

    @Override
    public void write(Writer out) {
      position.write(out);
      approach.write(out);
      orientation.write(out);
      out.uint8(state);
    }
  }

  /**
   * Commanded pose of the end effector. (player_limb_setpose_cmd_t)
   *
   * @param position In m, frame p_BE.
   * @param approach Commanded approach direction, a unit vector (frame n_B).
   * @param orientation Unit vector across the end effector (frame n_B).
   */
  public record SetposeCmd(
      CommonMessages.Point3d position, CommonMessages.Point3d approach, CommonMessages.Point3d orientation)
      implements Struct {
    /** Every number 0, every list empty. */
    public SetposeCmd() {
      this(new CommonMessages.Point3d(), new CommonMessages.Point3d(), new CommonMessages.Point3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetposeCmd decode(byte[] body) {
      return Reader.decode("limb.SetposeCmd", body, SetposeCmd::read);
    }

    static SetposeCmd read(Reader in) {
      CommonMessages.Point3d position = CommonMessages.Point3d.read(in);
      CommonMessages.Point3d approach = CommonMessages.Point3d.read(in);
      CommonMessages.Point3d orientation = CommonMessages.Point3d.read(in);
      return new SetposeCmd(position, approach, orientation);
    }

    @Override
    public void write(Writer out) {
      position.write(out);
      approach.write(out);
      orientation.write(out);
    }
  }

  /**
   * Commanded position of the end effector. (player_limb_setposition_cmd_t)
   *
   * @param position In m, frame p_BE.
   */
  public record SetpositionCmd(CommonMessages.Point3d position) implements Struct {
    /** Every number 0, every list empty. */
    public SetpositionCmd() {
      this(new CommonMessages.Point3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetpositionCmd decode(byte[] body) {
      return Reader.decode("limb.SetpositionCmd", body, SetpositionCmd::read);
    }

    static SetpositionCmd read(Reader in) {
      CommonMessages.Point3d position = CommonMessages.Point3d.read(in);
      return new SetpositionCmd(position);
    }

    @Override
    public void write(Writer out) {
      position.write(out);
    }
  }

  /**
   * A straight motion of the end effector. (player_limb_vecmove_cmd_t)
   *
   * @param direction Unit vector of the motion (frame n_B).
   * @param length Distance (in m).
   */
  public record VecmoveCmd(CommonMessages.Point3d direction, float length) implements Struct {
    /** Every number 0, every list empty. */
    public VecmoveCmd() {
      this(new CommonMessages.Point3d(), 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static VecmoveCmd decode(byte[] body) {
      return Reader.decode("limb.VecmoveCmd", body, VecmoveCmd::read);
    }

    static VecmoveCmd read(Reader in) {
      CommonMessages.Point3d direction = CommonMessages.Point3d.read(in);
      float length = in.float32();
      return new VecmoveCmd(direction, length);
    }

    @Override
    public void write(Writer out) {
      direction.write(out);
      out.float32(length);
    }
  }

  /**
   * The motors' switch. (player_limb_power_req_t)
   *
   * @param value 1: on, 0: off.
   */
  public record PowerReq(int value) implements Struct {
    /** Every number 0, every list empty. */
    public PowerReq() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerReq decode(byte[] body) {
      return Reader.decode("limb.PowerReq", body, PowerReq::read);
    }

    static PowerReq read(Reader in) {
      int value = in.uint8();
      return new PowerReq(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * The brakes' switch. (player_limb_brakes_req_t)
   *
   * @param value 1: braked, 0: released.
   */
  public record BrakesReq(int value) implements Struct {
    /** Every number 0, every list empty. */
    public BrakesReq() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static BrakesReq decode(byte[] body) {
      return Reader.decode("limb.BrakesReq", body, BrakesReq::read);
    }

    static BrakesReq read(Reader in) {
      int value = in.uint8();
      return new BrakesReq(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * Pose of the arm's base. (player_limb_geom_req_t)
   *
   * @param basePos Of the arm's base on the robot (in m, frame p_RB).
   */
  public record GeomReq(@WireName("basePos") CommonMessages.Point3d basePos) implements Struct {
    /** Every number 0, every list empty. */
    public GeomReq() {
      this(new CommonMessages.Point3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static GeomReq decode(byte[] body) {
      return Reader.decode("limb.GeomReq", body, GeomReq::read);
    }

    static GeomReq read(Reader in) {
      CommonMessages.Point3d basePos = CommonMessages.Point3d.read(in);
      return new GeomReq(basePos);
    }

    @Override
    public void write(Writer out) {
      basePos.write(out);
    }
  }

  /**
   * Speed of the end effector. (player_limb_speed_req_t)
   *
   * @param speed Maximum speed of the end effector (in m/s).
   */
  public record SpeedReq(float speed) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedReq() {
      this(0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedReq decode(byte[] body) {
      return Reader.decode("limb.SpeedReq", body, SpeedReq::read);
    }

    static SpeedReq read(Reader in) {
      float speed = in.float32();
      return new SpeedReq(speed);
    }

    @Override
    public void write(Writer out) {
      out.float32(speed);
    }
  }

  /** Pose of the end effector. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(54, Kind.DATA, 1, "limb.data.state", Data::decode);

  /** Moves the arm to its home position. */
  public static final MessageType<Nothing> CMD_HOME =
      new MessageType<>(54, Kind.CMD, 1, "limb.cmd.home", null);

  /** Stops the arm at its current position. */
  public static final MessageType<Nothing> CMD_STOP =
      new MessageType<>(54, Kind.CMD, 2, "limb.cmd.stop", null);

  /** Moves the end effector to a pose. */
  public static final MessageType<SetposeCmd> CMD_SETPOSE =
      new MessageType<>(54, Kind.CMD, 3, "limb.cmd.setpose", SetposeCmd::decode);

  /** Moves the end effector to a position, in any orientation. */
  public static final MessageType<SetpositionCmd> CMD_SETPOSITION =
      new MessageType<>(54, Kind.CMD, 4, "limb.cmd.setposition", SetpositionCmd::decode);

  /** Moves the end effector along a line from its current position. */
  public static final MessageType<VecmoveCmd> CMD_VECMOVE =
      new MessageType<>(54, Kind.CMD, 5, "limb.cmd.vecmove", VecmoveCmd::decode);

  /** Switches the motors on or off. */
  public static final MessageType<PowerReq> REQ_POWER =
      new MessageType<>(54, Kind.REQ, 1, "limb.req.power", PowerReq::decode);

  /** Sets or releases the brakes. */
  public static final MessageType<BrakesReq> REQ_BRAKES =
      new MessageType<>(54, Kind.REQ, 2, "limb.req.brakes", BrakesReq::decode);

  /** Requests the pose of the arm's base on the robot. */
  public static final MessageType<GeomReq> REQ_GEOM =
      new MessageType<>(54, Kind.REQ, 3, "limb.req.geom", GeomReq::decode);

  /** Sets the speed of the end effector. */
  public static final MessageType<SpeedReq> REQ_SPEED =
      new MessageType<>(54, Kind.REQ, 4, "limb.req.speed", SpeedReq::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, CMD_HOME, CMD_STOP, CMD_SETPOSE, CMD_SETPOSITION, CMD_VECMOVE, REQ_POWER, REQ_BRAKES,
      REQ_GEOM, REQ_SPEED);

  private LimbMessages() {}
}
