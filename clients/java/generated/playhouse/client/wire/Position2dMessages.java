// Generated from interfaces/004_position2d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control. */
public final class Position2dMessages {
  /** The interface's code. */
  public static final int CODE = 4;

  /**
   * Odometry. (player_position2d_data_t)
   *
   * @param pos Pose from odometry (in m, m, rad, frame X_OR).
   * @param vel Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R).
   * @param stall 1 if the robot is blocked by an obstacle.
   */
  public record Data(CommonMessages.Pose2d pos, CommonMessages.Pose2d vel, int stall) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new CommonMessages.Pose2d(), new CommonMessages.Pose2d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("position2d.Data", body, Data::read);
    }

    static Data read(Reader in) {
      CommonMessages.Pose2d pos = CommonMessages.Pose2d.read(in);
      CommonMessages.Pose2d vel = CommonMessages.Pose2d.read(in);
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
   * Commanded velocity. (player_position2d_cmd_vel_t)
   *
   * @param vel Forward, to the left, turning left; for a simulated car the last part is its steering angle in
   *     rad (in m/s, m/s, rad/s, frame v_OR_R).
   * @param state 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
   */
  public record CmdVel(CommonMessages.Pose2d vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdVel() {
      this(new CommonMessages.Pose2d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdVel decode(byte[] body) {
      return Reader.decode("position2d.CmdVel", body, CmdVel::read);
    }

    static CmdVel read(Reader in) {
      CommonMessages.Pose2d vel = CommonMessages.Pose2d.read(in);
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
   * Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t)
   *
   * @param pos Goal (in m, m, rad, frame X_OG).
   * @param vel Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s,
   *     rad/s, frame v_OR_R).
   * @param state 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
   */
  public record CmdPos(CommonMessages.Pose2d pos, CommonMessages.Pose2d vel, int state) implements Struct {
    /** Every number 0, every list empty. */
    public CmdPos() {
      this(new CommonMessages.Pose2d(), new CommonMessages.Pose2d(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPos decode(byte[] body) {
      return Reader.decode("position2d.CmdPos", body, CmdPos::read);
    }

    static CmdPos read(Reader in) {
      CommonMessages.Pose2d pos = CommonMessages.Pose2d.read(in);
      CommonMessages.Pose2d vel = CommonMessages.Pose2d.read(in);
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
   * Commanded motion of a car. (player_position2d_cmd_car_t)
   *
   * @param velocity Forward (in m/s).
   * @param angle Steering angle of the front wheels, positive to the left; a simulated robot without them
   *     uses it as turn rate in rad/s (in rad).
   */
  public record CmdCar(double velocity, double angle) implements Struct {
    /** Every number 0, every list empty. */
    public CmdCar() {
      this(0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdCar decode(byte[] body) {
      return Reader.decode("position2d.CmdCar", body, CmdCar::read);
    }

    static CmdCar read(Reader in) {
      double velocity = in.float64();
      double angle = in.float64();
      return new CmdCar(velocity, angle);
    }

    @Override
    public void write(Writer out) {
      out.float64(velocity);
      out.float64(angle);
    }
  }

  /**
   * Commanded speed and heading. (player_position2d_cmd_vel_head_t)
   *
   * @param velocity Forward (in m/s).
   * @param angle Heading in the odometry frame (in rad).
   */
  public record CmdVelHead(double velocity, double angle) implements Struct {
    /** Every number 0, every list empty. */
    public CmdVelHead() {
      this(0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdVelHead decode(byte[] body) {
      return Reader.decode("position2d.CmdVelHead", body, CmdVelHead::read);
    }

    static CmdVelHead read(Reader in) {
      double velocity = in.float64();
      double angle = in.float64();
      return new CmdVelHead(velocity, angle);
    }

    @Override
    public void write(Writer out) {
      out.float64(velocity);
      out.float64(angle);
    }
  }

  /**
   * The robot's size and centre of rotation. (player_position2d_geom_t)
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
      return Reader.decode("position2d.Geom", body, Geom::read);
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
   * The motors' switch. (player_position2d_power_config_t)
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
      return Reader.decode("position2d.PowerConfig", body, PowerConfig::read);
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
   * A velocity controller. (player_position2d_velocity_mode_config_t)
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
      return Reader.decode("position2d.VelocityModeConfig", body, VelocityModeConfig::read);
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
   * A control mode. (player_position2d_position_mode_req_t)
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
      return Reader.decode("position2d.PositionModeReq", body, PositionModeReq::read);
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
   * A new odometric pose. (player_position2d_set_odom_req_t)
   *
   * @param pose New odometric pose (in m, m, rad, frame X_OR).
   */
  public record SetOdomReq(CommonMessages.Pose2d pose) implements Struct {
    /** Every number 0, every list empty. */
    public SetOdomReq() {
      this(new CommonMessages.Pose2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetOdomReq decode(byte[] body) {
      return Reader.decode("position2d.SetOdomReq", body, SetOdomReq::read);
    }

    static SetOdomReq read(Reader in) {
      CommonMessages.Pose2d pose = CommonMessages.Pose2d.read(in);
      return new SetOdomReq(pose);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
    }
  }

  /**
   * Gains of velocity control. (player_position2d_speed_pid_req_t)
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
      return Reader.decode("position2d.SpeedPidReq", body, SpeedPidReq::read);
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
   * Gains of position control. (player_position2d_position_pid_req_t)
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
      return Reader.decode("position2d.PositionPidReq", body, PositionPidReq::read);
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
   * Limits of position control. (player_position2d_speed_prof_req_t)
   *
   * @param speed Maximum speed (in m/s).
   * @param acc Maximum acceleration (in m/s^2).
   */
  public record SpeedProfReq(float speed, float acc) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedProfReq() {
      this(0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedProfReq decode(byte[] body) {
      return Reader.decode("position2d.SpeedProfReq", body, SpeedProfReq::read);
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

  /** Requests the robot's size and centre of rotation. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(4, Kind.REQ, 1, "position2d.req.get_geom", Geom::decode);

  /** Switches the motors on or off. */
  public static final MessageType<PowerConfig> REQ_MOTOR_POWER =
      new MessageType<>(4, Kind.REQ, 2, "position2d.req.motor_power", PowerConfig::decode);

  /** Selects the driver's velocity controller. */
  public static final MessageType<VelocityModeConfig> REQ_VELOCITY_MODE =
      new MessageType<>(4, Kind.REQ, 3, "position2d.req.velocity_mode", VelocityModeConfig::decode);

  /** Selects between velocity and position control. */
  public static final MessageType<PositionModeReq> REQ_POSITION_MODE =
      new MessageType<>(4, Kind.REQ, 4, "position2d.req.position_mode", PositionModeReq::decode);

  /** Sets the odometric pose. */
  public static final MessageType<SetOdomReq> REQ_SET_ODOM =
      new MessageType<>(4, Kind.REQ, 5, "position2d.req.set_odom", SetOdomReq::decode);

  /** Sets the odometric pose to zero. */
  public static final MessageType<Nothing> REQ_RESET_ODOM =
      new MessageType<>(4, Kind.REQ, 6, "position2d.req.reset_odom", null);

  /** Sets the gains of velocity control. */
  public static final MessageType<SpeedPidReq> REQ_SPEED_PID =
      new MessageType<>(4, Kind.REQ, 7, "position2d.req.speed_pid", SpeedPidReq::decode);

  /** Sets the gains of position control. */
  public static final MessageType<PositionPidReq> REQ_POSITION_PID =
      new MessageType<>(4, Kind.REQ, 8, "position2d.req.position_pid", PositionPidReq::decode);

  /** Sets the speed and acceleration limits of position control. */
  public static final MessageType<SpeedProfReq> REQ_SPEED_PROF =
      new MessageType<>(4, Kind.REQ, 9, "position2d.req.speed_prof", SpeedProfReq::decode);

  /** Odometry. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(4, Kind.DATA, 1, "position2d.data.state", Data::decode);

  /** The robot's size, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(4, Kind.DATA, 2, "position2d.data.geom", Geom::decode);

  /** Commanded velocity. */
  public static final MessageType<CmdVel> CMD_VEL =
      new MessageType<>(4, Kind.CMD, 1, "position2d.cmd.vel", CmdVel::decode);

  /** Commanded pose in the odometry frame. */
  public static final MessageType<CmdPos> CMD_POS =
      new MessageType<>(4, Kind.CMD, 2, "position2d.cmd.pos", CmdPos::decode);

  /** Commanded speed and steering angle of a car. */
  public static final MessageType<CmdCar> CMD_CAR =
      new MessageType<>(4, Kind.CMD, 3, "position2d.cmd.car", CmdCar::decode);

  /** Commanded speed and heading. */
  public static final MessageType<CmdVelHead> CMD_VEL_HEAD =
      new MessageType<>(4, Kind.CMD, 4, "position2d.cmd.vel_head", CmdVelHead::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GET_GEOM, REQ_MOTOR_POWER, REQ_VELOCITY_MODE, REQ_POSITION_MODE, REQ_SET_ODOM, REQ_RESET_ODOM,
      REQ_SPEED_PID, REQ_POSITION_PID, REQ_SPEED_PROF, DATA_STATE, DATA_GEOM, CMD_VEL, CMD_POS, CMD_CAR,
      CMD_VEL_HEAD);

  private Position2dMessages() {}
}
