// Generated from interfaces/053_actarray.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm. */
public final class ActarrayMessages {
  /** The interface's code. */
  public static final int CODE = 53;

  // Values of Actuator.state.
  public static final int ACTSTATE_IDLE = 1;
  public static final int ACTSTATE_MOVING = 2;
  public static final int ACTSTATE_BRAKED = 4;
  public static final int ACTSTATE_STALLED = 8;

  // Values of Actuatorgeom.type.
  public static final int TYPE_LINEAR = 1;
  public static final int TYPE_ROTARY = 2;

  /**
   * State of one joint. (player_actarray_actuator_t)
   *
   * @param position In m or rad.
   * @param speed In m/s or rad/s.
   * @param acceleration In m/s^2 or rad/s^2.
   * @param current Of its motor; -1 if unknown (in A).
   * @param state Idle, moving, braked or stalled.
   */
  public record Actuator(
      float position, float speed, float acceleration, float current, int state)
      implements Struct {
    /** Every number 0, every list empty. */
    public Actuator() {
      this(0f, 0f, 0f, 0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Actuator decode(byte[] body) {
      return Reader.decode("actarray.Actuator", body, Actuator::read);
    }

    static Actuator read(Reader in) {
      float position = in.float32();
      float speed = in.float32();
      float acceleration = in.float32();
      float current = in.float32();
      int state = in.uint8();
      return new Actuator(position, speed, acceleration, current, state);
    }

    @Override
    public void write(Writer out) {
      out.float32(position);
      out.float32(speed);
      out.float32(acceleration);
      out.float32(current);
      out.uint8(state);
    }
  }

  /**
   * State of each joint. (player_actarray_data_t)
   *
   * @param actuators Actuators.
   * @param motorState 1: motors on, 0: off.
   */
  public record Data(List<Actuator> actuators, int motorState) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(List.of(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("actarray.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long actuatorsCount = in.uint32();
      List<Actuator> actuators = in.structs(in.length("actuators", actuatorsCount, 20), Actuator::read);
      int motorState = in.uint8();
      return new Data(actuators, motorState);
    }

    @Override
    public void write(Writer out) {
      out.length("actuators", actuators.size(), 1677719);
      out.length("actuators", actuators.size(), 1677719);
      out.structs(actuators);
      out.uint8(motorState);
    }
  }

  /**
   * Description of a joint. (player_actarray_actuatorgeom_t)
   *
   * @param type Prismatic or revolute.
   * @param length To the next joint (in m).
   * @param orientation Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad,
   *     frame R_BJ).
   * @param axis Unit vector of the axis of translation or rotation (frame n_J).
   * @param min Lowest position (in m or rad).
   * @param centre Centre position (in m or rad).
   * @param max Highest position (in m or rad).
   * @param home Position after CMD HOME (in m or rad).
   * @param configSpeed Speed in position control (in m/s or rad/s).
   * @param hasbrakes 1 if it has brakes.
   */
  public record Actuatorgeom(
      int type, float length, CommonMessages.Orientation3d orientation, CommonMessages.Point3d axis, float
      min, float centre, float max, float home, float configSpeed, int hasbrakes)
      implements Struct {
    /** Every number 0, every list empty. */
    public Actuatorgeom() {
      this(0, 0f, new CommonMessages.Orientation3d(), new CommonMessages.Point3d(), 0f, 0f, 0f, 0f, 0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Actuatorgeom decode(byte[] body) {
      return Reader.decode("actarray.Actuatorgeom", body, Actuatorgeom::read);
    }

    static Actuatorgeom read(Reader in) {
      int type = in.uint8();
      float length = in.float32();
      CommonMessages.Orientation3d orientation = CommonMessages.Orientation3d.read(in);
      CommonMessages.Point3d axis = CommonMessages.Point3d.read(in);
      float min = in.float32();
      float centre = in.float32();
      float max = in.float32();
      float home = in.float32();
      float configSpeed = in.float32();
      int hasbrakes = in.uint8();
      return new Actuatorgeom(type, length, orientation, axis, min, centre, max, home, configSpeed,
          hasbrakes);
    }

    @Override
    public void write(Writer out) {
      out.uint8(type);
      out.float32(length);
      orientation.write(out);
      axis.write(out);
      out.float32(min);
      out.float32(centre);
      out.float32(max);
      out.float32(home);
      out.float32(configSpeed);
      out.uint8(hasbrakes);
    }
  }

  /**
   * Joints and base pose of the chain. (player_actarray_geom_t)
   *
   * @param actuators Actuators.
   * @param basePos Position of the base of the chain on the robot (in m, frame p_RB).
   * @param baseOrientation Orientation of the base of the chain on the robot (in rad, frame R_RB).
   */
  public record Geom(
      List<Actuatorgeom> actuators, CommonMessages.Point3d basePos, CommonMessages.Orientation3d
      baseOrientation)
      implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(List.of(), new CommonMessages.Point3d(), new CommonMessages.Orientation3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("actarray.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      long actuatorsCount = in.uint32();
      List<Actuatorgeom> actuators = in.structs(in.length("actuators", actuatorsCount, 80),
          Actuatorgeom::read);
      CommonMessages.Point3d basePos = CommonMessages.Point3d.read(in);
      CommonMessages.Orientation3d baseOrientation = CommonMessages.Orientation3d.read(in);
      return new Geom(actuators, basePos, baseOrientation);
    }

    @Override
    public void write(Writer out) {
      out.length("actuators", actuators.size(), 419429);
      out.length("actuators", actuators.size(), 419429);
      out.structs(actuators);
      basePos.write(out);
      baseOrientation.write(out);
    }
  }

  /**
   * Commanded position of one joint. (player_actarray_position_cmd_t)
   *
   * @param joint Index of the joint, from 0.
   * @param position In m or rad.
   */
  public record PositionCmd(int joint, float position) implements Struct {
    /** Every number 0, every list empty. */
    public PositionCmd() {
      this(0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PositionCmd decode(byte[] body) {
      return Reader.decode("actarray.PositionCmd", body, PositionCmd::read);
    }

    static PositionCmd read(Reader in) {
      int joint = in.int32();
      float position = in.float32();
      return new PositionCmd(joint, position);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
      out.float32(position);
    }
  }

  /**
   * Commanded positions of all joints. (player_actarray_multi_position_cmd_t)
   *
   * @param positions In m or rad.
   */
  public record MultiPositionCmd(float[] positions) implements Struct {
    /** Every number 0, every list empty. */
    public MultiPositionCmd() {
      this(new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MultiPositionCmd decode(byte[] body) {
      return Reader.decode("actarray.MultiPositionCmd", body, MultiPositionCmd::read);
    }

    static MultiPositionCmd read(Reader in) {
      long positionsCount = in.uint32();
      float[] positions = in.float32s(in.length("positions", positionsCount, 4));
      return new MultiPositionCmd(positions);
    }

    @Override
    public void write(Writer out) {
      out.length("positions", positions.length, 8388598);
      out.length("positions", positions.length, 8388598);
      out.float32s(positions);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof MultiPositionCmd that && Arrays.equals(positions, that.positions);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(positions);
    }
  }

  /**
   * Commanded speed of one joint. (player_actarray_speed_cmd_t)
   *
   * @param joint Index of the joint, from 0.
   * @param speed In m/s or rad/s.
   */
  public record SpeedCmd(int joint, float speed) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedCmd() {
      this(0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedCmd decode(byte[] body) {
      return Reader.decode("actarray.SpeedCmd", body, SpeedCmd::read);
    }

    static SpeedCmd read(Reader in) {
      int joint = in.int32();
      float speed = in.float32();
      return new SpeedCmd(joint, speed);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
      out.float32(speed);
    }
  }

  /**
   * Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t)
   *
   * @param speeds In m/s or rad/s.
   */
  public record MultiSpeedCmd(float[] speeds) implements Struct {
    /** Every number 0, every list empty. */
    public MultiSpeedCmd() {
      this(new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MultiSpeedCmd decode(byte[] body) {
      return Reader.decode("actarray.MultiSpeedCmd", body, MultiSpeedCmd::read);
    }

    static MultiSpeedCmd read(Reader in) {
      long speedsCount = in.uint32();
      float[] speeds = in.float32s(in.length("speeds", speedsCount, 4));
      return new MultiSpeedCmd(speeds);
    }

    @Override
    public void write(Writer out) {
      out.length("speeds", speeds.length, 8388598);
      out.length("speeds", speeds.length, 8388598);
      out.float32s(speeds);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof MultiSpeedCmd that && Arrays.equals(speeds, that.speeds);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(speeds);
    }
  }

  /**
   * A joint to move to its home position. (player_actarray_home_cmd_t)
   *
   * @param joint Index of the joint; -1: all.
   */
  public record HomeCmd(int joint) implements Struct {
    /** Every number 0, every list empty. */
    public HomeCmd() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static HomeCmd decode(byte[] body) {
      return Reader.decode("actarray.HomeCmd", body, HomeCmd::read);
    }

    static HomeCmd read(Reader in) {
      int joint = in.int32();
      return new HomeCmd(joint);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
    }
  }

  /**
   * Commanded current of one joint. (player_actarray_current_cmd_t)
   *
   * @param joint Index of the joint, from 0.
   * @param current In A.
   */
  public record CurrentCmd(int joint, float current) implements Struct {
    /** Every number 0, every list empty. */
    public CurrentCmd() {
      this(0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CurrentCmd decode(byte[] body) {
      return Reader.decode("actarray.CurrentCmd", body, CurrentCmd::read);
    }

    static CurrentCmd read(Reader in) {
      int joint = in.int32();
      float current = in.float32();
      return new CurrentCmd(joint, current);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
      out.float32(current);
    }
  }

  /**
   * Commanded currents of all joints. (player_actarray_multi_current_cmd_t)
   *
   * @param currents In A.
   */
  public record MultiCurrentCmd(float[] currents) implements Struct {
    /** Every number 0, every list empty. */
    public MultiCurrentCmd() {
      this(new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MultiCurrentCmd decode(byte[] body) {
      return Reader.decode("actarray.MultiCurrentCmd", body, MultiCurrentCmd::read);
    }

    static MultiCurrentCmd read(Reader in) {
      long currentsCount = in.uint32();
      float[] currents = in.float32s(in.length("currents", currentsCount, 4));
      return new MultiCurrentCmd(currents);
    }

    @Override
    public void write(Writer out) {
      out.length("currents", currents.length, 8388598);
      out.length("currents", currents.length, 8388598);
      out.float32s(currents);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof MultiCurrentCmd that && Arrays.equals(currents, that.currents);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(currents);
    }
  }

  /**
   * The motors' switch. (player_actarray_power_config_t)
   *
   * @param value 1: on, 0: off.
   */
  public record PowerConfig(int value) implements Struct {
    /** Every number 0, every list empty. */
    public PowerConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerConfig decode(byte[] body) {
      return Reader.decode("actarray.PowerConfig", body, PowerConfig::read);
    }

    static PowerConfig read(Reader in) {
      int value = in.uint8();
      return new PowerConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * The brakes' switch. (player_actarray_brakes_config_t)
   *
   * @param value 1: braked, 0: released.
   */
  public record BrakesConfig(int value) implements Struct {
    /** Every number 0, every list empty. */
    public BrakesConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static BrakesConfig decode(byte[] body) {
      return Reader.decode("actarray.BrakesConfig", body, BrakesConfig::read);
    }

    static BrakesConfig read(Reader in) {
      int value = in.uint8();
      return new BrakesConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * Speed of one joint. (player_actarray_speed_config_t)
   *
   * @param joint Index of the joint; -1: all.
   * @param speed In m/s or rad/s.
   */
  public record SpeedConfig(int joint, float speed) implements Struct {
    /** Every number 0, every list empty. */
    public SpeedConfig() {
      this(0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SpeedConfig decode(byte[] body) {
      return Reader.decode("actarray.SpeedConfig", body, SpeedConfig::read);
    }

    static SpeedConfig read(Reader in) {
      int joint = in.int32();
      float speed = in.float32();
      return new SpeedConfig(joint, speed);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
      out.float32(speed);
    }
  }

  /**
   * Acceleration of one joint. (player_actarray_accel_config_t)
   *
   * @param joint Index of the joint; -1: all.
   * @param accel In m/s^2 or rad/s^2.
   */
  public record AccelConfig(int joint, float accel) implements Struct {
    /** Every number 0, every list empty. */
    public AccelConfig() {
      this(0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static AccelConfig decode(byte[] body) {
      return Reader.decode("actarray.AccelConfig", body, AccelConfig::read);
    }

    static AccelConfig read(Reader in) {
      int joint = in.int32();
      float accel = in.float32();
      return new AccelConfig(joint, accel);
    }

    @Override
    public void write(Writer out) {
      out.int32(joint);
      out.float32(accel);
    }
  }

  /** Switches the motors on or off. */
  public static final MessageType<PowerConfig> REQ_POWER =
      new MessageType<>(53, Kind.REQ, 1, "actarray.req.power", PowerConfig::decode);

  /** Sets or releases the brakes. */
  public static final MessageType<BrakesConfig> REQ_BRAKES =
      new MessageType<>(53, Kind.REQ, 2, "actarray.req.brakes", BrakesConfig::decode);

  /** Requests the joints and the base pose of the chain. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(53, Kind.REQ, 3, "actarray.req.get_geom", Geom::decode);

  /** Sets a joint's speed in position control. */
  public static final MessageType<SpeedConfig> REQ_SPEED =
      new MessageType<>(53, Kind.REQ, 4, "actarray.req.speed", SpeedConfig::decode);

  /** Sets a joint's acceleration in position control. */
  public static final MessageType<AccelConfig> REQ_ACCEL =
      new MessageType<>(53, Kind.REQ, 5, "actarray.req.accel", AccelConfig::decode);

  /** Commanded position of one joint. */
  public static final MessageType<PositionCmd> CMD_POS =
      new MessageType<>(53, Kind.CMD, 1, "actarray.cmd.pos", PositionCmd::decode);

  /** Commanded positions of all joints. */
  public static final MessageType<MultiPositionCmd> CMD_MULTI_POS =
      new MessageType<>(53, Kind.CMD, 2, "actarray.cmd.multi_pos", MultiPositionCmd::decode);

  /** Commanded speed of one joint. */
  public static final MessageType<SpeedCmd> CMD_SPEED =
      new MessageType<>(53, Kind.CMD, 3, "actarray.cmd.speed", SpeedCmd::decode);

  /** Commanded speeds of all joints. */
  public static final MessageType<MultiSpeedCmd> CMD_MULTI_SPEED =
      new MessageType<>(53, Kind.CMD, 4, "actarray.cmd.multi_speed", MultiSpeedCmd::decode);

  /** Moves one joint, or all, to the home position. */
  public static final MessageType<HomeCmd> CMD_HOME =
      new MessageType<>(53, Kind.CMD, 5, "actarray.cmd.home", HomeCmd::decode);

  /** Commanded current of one joint. */
  public static final MessageType<CurrentCmd> CMD_CURRENT =
      new MessageType<>(53, Kind.CMD, 6, "actarray.cmd.current", CurrentCmd::decode);

  /** Commanded currents of all joints. */
  public static final MessageType<MultiCurrentCmd> CMD_MULTI_CURRENT =
      new MessageType<>(53, Kind.CMD, 7, "actarray.cmd.multi_current", MultiCurrentCmd::decode);

  /** State of each joint. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(53, Kind.DATA, 1, "actarray.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_POWER, REQ_BRAKES, REQ_GET_GEOM, REQ_SPEED, REQ_ACCEL, CMD_POS, CMD_MULTI_POS, CMD_SPEED,
      CMD_MULTI_SPEED, CMD_HOME, CMD_CURRENT, CMD_MULTI_CURRENT, DATA_STATE);

  private ActarrayMessages() {}
}
