// Generated from interfaces/052_position1d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface position1d, code 52. A single prismatic or revolute actuator. */
public final class Position1dMessages {
  /** The interface's code. */
  public static final int CODE = 52;

  // Bits of Data.status, by number.
  public static final int STATUS_LIMIT_MIN = 0;
  public static final int STATUS_LIMIT_CEN = 1;
  public static final int STATUS_LIMIT_MAX = 2;
  public static final int STATUS_OC = 3;
  public static final int STATUS_TRAJ_COMPLETE = 4;
  public static final int STATUS_ENABLED = 5;

  /**
   * Position of the actuator. (player_position1d_data_t)
   *
   * @param pos From its zero (in m or rad).
   * @param vel In m/s or rad/s.
   * @param stall 1 if it is blocked by an obstacle.
   * @param status Limits, current, motion and power, one bit each.
   */
  public record Data(float pos, float vel, int stall, int status) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0f, 0f, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("position1d.Data", body, Data::read);
    }

    static Data read(Reader in) {
      float pos = in.float32();
      float vel = in.float32();
      int stall = in.uint8();
      int status = in.uint8();
      return new Data(pos, vel, stall, status);
    }

    @Override
    public void write(Writer out) {
      out.float32(pos);
      out.float32(vel);
      out.uint8(stall);
      out.uint8(status);
    }
  }

  /**
   * Commanded velocity. (player_position1d_cmd_vel_t)
   *
   * @param vel In m/s or rad/s.
   * @param state 1: motor on, 0: off.
   */
  public record CmdVel(float vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdVel() {
      this(0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdVel decode(byte[] body) {
      return Reader.decode("position1d.CmdVel", body, CmdVel::read);
    }

    static CmdVel read(Reader in) {
      float vel = in.float32();
      int state = in.uint8();
      return new CmdVel(vel, state);
    }

    @Override
    public void write(Writer out) {
      out.float32(vel);
      out.uint8(state);
    }
  }

  /**
   * Commanded position. (player_position1d_cmd_pos_t)
   *
   * @param pos From its zero (in m or rad).
   * @param vel Velocity on the way; zero: chosen by the driver (in m/s or rad/s).
   * @param state 1: motor on, 0: off.
   */
  public record CmdPos(float pos, float vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdPos() {
      this(0f, 0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPos decode(byte[] body) {
      return Reader.decode("position1d.CmdPos", body, CmdPos::read);
    }

    static CmdPos read(Reader in) {
      float pos = in.float32();
      float vel = in.float32();
      int state = in.uint8();
      return new CmdPos(pos, vel, state);
    }

    @Override
    public void write(Writer out) {
      out.float32(pos);
      out.float32(vel);
      out.uint8(state);
    }
  }

  /**
   * Size and pose. (player_position1d_geom_t)
   *
   * @param pose Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param size Bounding box of the actuator (in m, m, m).
   */
  public record Geom(CommonMessages.Pose3d pose, CommonMessages.Bbox3d size) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("position1d.Geom", body, Geom::read);
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
   * The motor's switch. (player_position1d_power_config_t)
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
      return Reader.decode("position1d.PowerConfig", body, PowerConfig::read);
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
   * A velocity controller. (player_position1d_velocity_mode_config_t)
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
      return Reader.decode("position1d.VelocityModeConfig", body, VelocityModeConfig::read);
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
   * Request to set the current position to zero. (player_position1d_reset_odom_config_t)
   *
   * @param value Without meaning.
   */
  public record ResetOdomConfig(long value) implements Struct {
    /** Every number 0, every list empty. */
    public ResetOdomConfig() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ResetOdomConfig decode(byte[] body) {
      return Reader.decode("position1d.ResetOdomConfig", body, ResetOdomConfig::read);
    }

    static ResetOdomConfig read(Reader in) {
      long value = in.uint32();
      return new ResetOdomConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint32(value);
    }
  }

  /**
   * A control mode. (player_position1d_position_mode_req_t)
   *
   * @param state 0: velocity, 1: position.
   */
  public record PositionModeReq(long state) implements Struct {
    /** Every number 0, every list empty. */
    public PositionModeReq() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PositionModeReq decode(byte[] body) {
      return Reader.decode("position1d.PositionModeReq", body, PositionModeReq::read);
    }

    static PositionModeReq read(Reader in) {
      long state = in.uint32();
      return new PositionModeReq(state);
    }

    @Override
    public void write(Writer out) {
      out.uint32(state);
    }
  }

  /**
   * New value of the current position. (player_position1d_set_odom_req_t)
   *
   * @param pos New value of the current position (in m or rad).
   */
  public record SetOdomReq(float pos) implements Struct {
    /** Every number 0, every list empty. */
    public SetOdomReq() {
      this(0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetOdomReq decode(byte[] body) {
      return Reader.decode("position1d.SetOdomReq", body, SetOdomReq::read);
    }

    static SetOdomReq read(Reader in) {
      float pos = in.float32();
      return new SetOdomReq(pos);
    }

    @Override
    public void write(Writer out) {
      out.float32(pos);
    }
  }

  /**
   * Gains of velocity control. (player_position1d_speed_pid_req_t)
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
      return Reader.decode("position1d.SpeedPidReq", body, SpeedPidReq::read);
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
   * Gains of position control. (player_position1d_position_pid_req_t)
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
      return Reader.decode("position1d.PositionPidReq", body, PositionPidReq::read);
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
   * Limits of position control. (player_position1d_speed_prof_req_t)
   *
   * @param speed Maximum speed (in m/s or rad/s).
   * @param acc Maximum acceleration (in m/s^2 or rad/s^2).
   */
  public record SpeedProfReq(float speed, float acc) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedProfReq() {
      this(0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedProfReq decode(byte[] body) {
      return Reader.decode("position1d.SpeedProfReq", body, SpeedProfReq::read);
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

  /** Requests size and pose. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(52, Kind.REQ, 1, "position1d.req.get_geom", Geom::decode);

  /** Switches the motor on or off. */
  public static final MessageType<PowerConfig> REQ_MOTOR_POWER =
      new MessageType<>(52, Kind.REQ, 2, "position1d.req.motor_power", PowerConfig::decode);

  /** Selects the driver's velocity controller. */
  public static final MessageType<VelocityModeConfig> REQ_VELOCITY_MODE =
      new MessageType<>(52, Kind.REQ, 3, "position1d.req.velocity_mode", VelocityModeConfig::decode);

  /** Selects between velocity and position control. */
  public static final MessageType<PositionModeReq> REQ_POSITION_MODE =
      new MessageType<>(52, Kind.REQ, 4, "position1d.req.position_mode", PositionModeReq::decode);

  /** Sets the reference of the position. */
  public static final MessageType<SetOdomReq> REQ_SET_ODOM =
      new MessageType<>(52, Kind.REQ, 5, "position1d.req.set_odom", SetOdomReq::decode);

  /** Sets the current position to zero. */
  public static final MessageType<ResetOdomConfig> REQ_RESET_ODOM =
      new MessageType<>(52, Kind.REQ, 6, "position1d.req.reset_odom", ResetOdomConfig::decode);

  /** Sets the gains of velocity control. */
  public static final MessageType<SpeedPidReq> REQ_SPEED_PID =
      new MessageType<>(52, Kind.REQ, 7, "position1d.req.speed_pid", SpeedPidReq::decode);

  /** Sets the gains of position control. */
  public static final MessageType<PositionPidReq> REQ_POSITION_PID =
      new MessageType<>(52, Kind.REQ, 8, "position1d.req.position_pid", PositionPidReq::decode);

  /** Sets the speed and acceleration limits of position control. */
  public static final MessageType<SpeedProfReq> REQ_SPEED_PROF =
      new MessageType<>(52, Kind.REQ, 9, "position1d.req.speed_prof", SpeedProfReq::decode);

  /** Position of the actuator. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(52, Kind.DATA, 1, "position1d.data.state", Data::decode);

  /** Size and pose, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(52, Kind.DATA, 2, "position1d.data.geom", Geom::decode);

  /** Commanded velocity. */
  public static final MessageType<CmdVel> CMD_VEL =
      new MessageType<>(52, Kind.CMD, 1, "position1d.cmd.vel", CmdVel::decode);

  /** Commanded position. */
  public static final MessageType<CmdPos> CMD_POS =
      new MessageType<>(52, Kind.CMD, 2, "position1d.cmd.pos", CmdPos::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GET_GEOM, REQ_MOTOR_POWER, REQ_VELOCITY_MODE, REQ_POSITION_MODE, REQ_SET_ODOM, REQ_RESET_ODOM,
      REQ_SPEED_PID, REQ_POSITION_PID, REQ_SPEED_PROF, DATA_STATE, DATA_GEOM, CMD_VEL, CMD_POS);

  private Position1dMessages() {}
}
