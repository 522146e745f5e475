// Generated from interfaces/030_position3d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface position3d, code 30. A robot that moves in 3D. */
public final class Position3dMessages {
  /** The interface's code. */
  public static final int CODE = 30;

  /**
   * Odometry. (player_position3d_data_t)
   *
   * @param pos Pose from odometry (in m, m, m, rad, rad, rad, frame X_OR).
   * @param vel Velocity along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
   * @param stall 1 if the robot is blocked by an obstacle.
   */
  public record Data(CommonMessages.Pose3d pos, CommonMessages.Pose3d vel, int stall) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Pose3d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("position3d.Data", body, Data::read);
    }

    static Data read(Reader in) {
      CommonMessages.Pose3d pos = CommonMessages.Pose3d.read(in);
      CommonMessages.Pose3d vel = CommonMessages.Pose3d.read(in);
      int stall = in.uint8();
      return new Data(pos, vel, stall);
    }

    @Override
    public void write(Writer out) {
      pos.write(out);
      vel.write(out);
      out.uint8(stall);
    }
  }

  /**
   * Commanded pose, and the velocity on the way. (player_position3d_cmd_pos_t)
   *
   * @param pos Goal (in m, m, m, rad, rad, rad, frame X_OG).
   * @param vel Velocity on the way; zero: chosen by the driver (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame
   *     v_OR_R).
   * @param state 1: motors on, 0: off.
   */
  public record CmdPos(CommonMessages.Pose3d pos, CommonMessages.Pose3d vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdPos() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Pose3d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPos decode(byte[] body) {
      return Reader.decode("position3d.CmdPos", body, CmdPos::read);
    }

    static CmdPos read(Reader in) {
      CommonMessages.Pose3d pos = CommonMessages.Pose3d.read(in);
      CommonMessages.Pose3d vel = CommonMessages.Pose3d.read(in);
      int state = in.uint8();
      return new CmdPos(pos, vel, state);
    }

    @Override
    public void write(Writer out) {
      pos.write(out);
      vel.write(out);
      out.uint8(state);
    }
  }

  /**
   * Commanded velocity. (player_position3d_cmd_vel_t)
   *
   * @param vel Along and about x, y and z (in m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_OR_R).
   * @param state 1: motors on, 0: off.
   */
  public record CmdVel(CommonMessages.Pose3d vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdVel() {
      this(new CommonMessages.Pose3d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdVel decode(byte[] body) {
      return Reader.decode("position3d.CmdVel", body, CmdVel::read);
    }

    static CmdVel read(Reader in) {
      CommonMessages.Pose3d vel = CommonMessages.Pose3d.read(in);
      int state = in.uint8();
      return new CmdVel(vel, state);
    }

    @Override
    public void write(Writer out) {
      vel.write(out);
      out.uint8(state);
    }
  }

  /**
   * The robot's size and centre of rotation. (player_position3d_geom_t)
   *
   * @param pose Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad,
   *     frame X_RS).
   * @param size Bounding box of the robot (in m, m, m).
   */
  public record Geom(CommonMessages.Pose3d pose, CommonMessages.Bbox3d size) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("position3d.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d size = CommonMessages.Bbox3d.read(in);
      return new Geom(pose, size);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      size.write(out);
    }
  }

  /**
   * The motors' switch. (player_position3d_power_config_t)
   *
   * @param state 1: on, 0: off.
   */
  public record PowerConfig(int state) implements Struct {
    /** Every number 0, every list empty. */
    public PowerConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerConfig decode(byte[] body) {
      return Reader.decode("position3d.PowerConfig", body, PowerConfig::read);
    }

    static PowerConfig read(Reader in) {
      int state = in.uint8();
      return new PowerConfig(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /**
   * A control mode. (player_position3d_position_mode_req_t)
   *
   * @param value 0: velocity, 1: position.
   */
  public record PositionModeReq(long value) implements Struct {
    /** Every number 0, every list empty. */
    public PositionModeReq() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PositionModeReq decode(byte[] body) {
      return Reader.decode("position3d.PositionModeReq", body, PositionModeReq::read);
    }

    static PositionModeReq read(Reader in) {
      long value = in.uint32();
      return new PositionModeReq(value);
    }

    @Override
    public void write(Writer out) {
      out.uint32(value);
    }
  }

  /**
   * A velocity controller. (player_position3d_velocity_mode_config_t)
   *
   * @param value Driver-specific.
   */
  public record VelocityModeConfig(long value) implements Struct {
    /** Every number 0, every list empty. */
    public VelocityModeConfig() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static VelocityModeConfig decode(byte[] body) {
      return Reader.decode("position3d.VelocityModeConfig", body, VelocityModeConfig::read);
    }

    static VelocityModeConfig read(Reader in) {
      long value = in.uint32();
      return new VelocityModeConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint32(value);
    }
  }

  /**
   * A new odometric pose. (player_position3d_set_odom_req_t)
   *
   * @param pos New odometric pose (in m, m, m, rad, rad, rad, frame X_OR).
   */
  public record SetOdomReq(CommonMessages.Pose3d pos) implements Struct {
    /** Every number 0, every list empty. */
    public SetOdomReq() {
      this(new CommonMessages.Pose3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetOdomReq decode(byte[] body) {
      return Reader.decode("position3d.SetOdomReq", body, SetOdomReq::read);
    }

    static SetOdomReq read(Reader in) {
      CommonMessages.Pose3d pos = CommonMessages.Pose3d.read(in);
      return new SetOdomReq(pos);
    }

    @Override
    public void write(Writer out) {
      pos.write(out);
    }
  }

  /**
   * Gains of velocity control. (player_position3d_speed_pid_req_t)
   *
   * @param kp Proportional.
   * @param ki Integral.
   * @param kd Derivative.
   */
  public record SpeedPidReq(float kp, float ki, float kd) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedPidReq() {
      this(0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedPidReq decode(byte[] body) {
      return Reader.decode("position3d.SpeedPidReq", body, SpeedPidReq::read);
    }

    static SpeedPidReq read(Reader in) {
      float kp = in.float32();
      float ki = in.float32();
      float kd = in.float32();
      return new SpeedPidReq(kp, ki, kd);
    }

    @Override
    public void write(Writer out) {
      out.float32(kp);
      out.float32(ki);
      out.float32(kd);
    }
  }

  /**
   * Gains of position control. (player_position3d_position_pid_req_t)
   *
   * @param kp Proportional.
   * @param ki Integral.
   * @param kd Derivative.
   */
  public record PositionPidReq(float kp, float ki, float kd) implements Struct {
    /** Every number 0, every list empty. */
    public PositionPidReq() {
      this(0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PositionPidReq decode(byte[] body) {
      return Reader.decode("position3d.PositionPidReq", body, PositionPidReq::read);
    }

    static PositionPidReq read(Reader in) {
      float kp = in.float32();
      float ki = in.float32();
      float kd = in.float32();
      return new PositionPidReq(kp, ki, kd);
    }

    @Override
    public void write(Writer out) {
      out.float32(kp);
      out.float32(ki);
      out.float32(kd);
    }
  }

  /**
   * Limits of position control. (player_position3d_speed_prof_req_t)
   *
   * @param speed Maximum turn rate (in rad/s).
   * @param acc Maximum angular acceleration (in rad/s^2).
   */
  public record SpeedProfReq(float speed, float acc) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedProfReq() {
      this(0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedProfReq decode(byte[] body) {
      return Reader.decode("position3d.SpeedProfReq", body, SpeedProfReq::read);
    }

    static SpeedProfReq read(Reader in) {
      float speed = in.float32();
      float acc = in.float32();
      return new SpeedProfReq(speed, acc);
    }

    @Override
    public void write(Writer out) {
      out.float32(speed);
      out.float32(acc);
    }
  }

  /** Odometry. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(30, Kind.DATA, 1, "position3d.data.state", Data::decode);

  /** The robot's size, sent on change. */
  public static final MessageType<Geom> DATA_GEOMETRY =
      new MessageType<>(30, Kind.DATA, 2, "position3d.data.geometry", Geom::decode);

  /** Commanded velocity. */
  public static final MessageType<CmdVel> CMD_SET_VEL =
      new MessageType<>(30, Kind.CMD, 1, "position3d.cmd.set_vel", CmdVel::decode);

  /** Commanded pose in the odometry frame. */
  public static final MessageType<CmdPos> CMD_SET_POS =
      new MessageType<>(30, Kind.CMD, 2, "position3d.cmd.set_pos", CmdPos::decode);

  /** Requests the robot's size and centre of rotation. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(30, Kind.REQ, 1, "position3d.req.get_geom", Geom::decode);

  /** Switches the motors on or off. */
  public static final MessageType<PowerConfig> REQ_MOTOR_POWER =
      new MessageType<>(30, Kind.REQ, 2, "position3d.req.motor_power", PowerConfig::decode);

  /** Selects the driver's velocity controller. */
  public static final MessageType<VelocityModeConfig> REQ_VELOCITY_MODE =
      new MessageType<>(30, Kind.REQ, 3, "position3d.req.velocity_mode", VelocityModeConfig::decode);

  /** Selects between velocity and position control. */
  public static final MessageType<PositionModeReq> REQ_POSITION_MODE =
      new MessageType<>(30, Kind.REQ, 4, "position3d.req.position_mode", PositionModeReq::decode);

  /** Sets the odometric pose to zero. */
  public static final MessageType<Nothing> REQ_RESET_ODOM =
      new MessageType<>(30, Kind.REQ, 5, "position3d.req.reset_odom", null);

  /** Sets the odometric pose. */
  public static final MessageType<SetOdomReq> REQ_SET_ODOM =
      new MessageType<>(30, Kind.REQ, 6, "position3d.req.set_odom", SetOdomReq::decode);

  /** Sets the gains of velocity control. */
  public static final MessageType<SpeedPidReq> REQ_SPEED_PID =
      new MessageType<>(30, Kind.REQ, 7, "position3d.req.speed_pid", SpeedPidReq::decode);

  /** Sets the gains of position control. */
  public static final MessageType<PositionPidReq> REQ_POSITION_PID =
      new MessageType<>(30, Kind.REQ, 8, "position3d.req.position_pid", PositionPidReq::decode);

  /** Sets the turn rate and angular acceleration limits of position control. */
  public static final MessageType<SpeedProfReq> REQ_SPEED_PROF =
      new MessageType<>(30, Kind.REQ, 9, "position3d.req.speed_prof", SpeedProfReq::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, DATA_GEOMETRY, CMD_SET_VEL, CMD_SET_POS, REQ_GET_GEOM, REQ_MOTOR_POWER, REQ_VELOCITY_MODE,
      REQ_POSITION_MODE, REQ_RESET_ODOM, REQ_SET_ODOM, REQ_SPEED_PID, REQ_POSITION_PID, REQ_SPEED_PROF);

  private Position3dMessages() {}
}
