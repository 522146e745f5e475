package playhouse.client;

import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Position2dMessages;

/** A mobile base. Closing it while it moves stops it first. */
public final class Position2d extends Mobile<State> {
  Position2d(Opening opening) {
    super(opening);
  }

  /** The newest data. Throws NoDataException. */
  public State state() {
    Stamped<Position2dMessages.Data> data = stamped(Position2dMessages.DATA_STATE);
    CommonMessages.Pose2d velocity = data.value().vel();
    return new State(Pose.of(data.value().pos()), new Velocity(velocity.px(), velocity.py(), velocity.pa()),
        data.value().stall() != 0, data.time());
  }

  /** The robot's pose estimate: that of state(). */
  public Pose pose() {
    return state().pose();
  }

  public Velocity velocity() {
    return state().velocity();
  }

  /** Whether the robot is blocked. */
  public boolean isStalled() {
    return state().stalled();
  }

  /** Drives straight ahead, in m/s, until the next command. */
  public void drive(double vx) {
    drive(vx, 0);
  }

  /** Forward in m/s, turning in rad/s, until the next command. */
  public void drive(double vx, double va) {
    drive(vx, va, 0);
  }

  /** Forward and to the left in m/s, turning in rad/s, until the next command. */
  public void drive(double vx, double va, double vy) {
    insistOnFinite("vx", vx);
    insistOnFinite("va", va);
    insistOnFinite("vy", vy);
    setMoving(vx != 0 || vy != 0 || va != 0);
    command(Position2dMessages.CMD_VEL, new Position2dMessages.CmdVel(new CommonMessages.Pose2d(vx, vy, va), 1));
  }

  @Override
  public void stop() {
    drive(0);
  }

  /** For a base with car steering: speed in m/s, and steering angle in rad, positive to the left. */
  public void driveCar(double speed, double steering) {
    insistOnFinite("speed", speed);
    insistOnFinite("steering", steering);
    setMoving(speed != 0);
    command(Position2dMessages.CMD_CAR, new Position2dMessages.CmdCar(speed, steering));
  }

  /**
   * Drives to a pose in the frame of state(), by the driver's position control, at a speed of the driver's
   * choice.
   */
  public void goTo(Pose pose) {
    goTo(pose, 0);
  }

  /** The same at a speed in m/s; 0: the driver's choice. */
  public void goTo(Pose pose, double speed) {
    insistOnFinite(pose);
    insistOnFinite("speed", speed);
    setMoving(true);
    command(Position2dMessages.CMD_POS,
        new Position2dMessages.CmdPos(pose.onWire(), new CommonMessages.Pose2d(speed, 0, 0), 1));
  }

  public void setMotorPower(boolean on) {
    request(Position2dMessages.REQ_MOTOR_POWER, new Position2dMessages.PowerConfig(on ? 1 : 0));
  }

  /** Sets the pose estimate; the robot does not move. */
  public void setOdometry(Pose pose) {
    insistOnFinite(pose);
    request(Position2dMessages.REQ_SET_ODOM, new Position2dMessages.SetOdomReq(pose.onWire()));
  }

  /** Sets the pose estimate to zero. */
  public void resetOdometry() {
    request(Position2dMessages.REQ_RESET_ODOM);
  }

  public Geometry geometry() {
    Position2dMessages.Geom geom = answer(Position2dMessages.REQ_GET_GEOM);
    return Geometry.of(geom.pose(), geom.size());
  }

  @Override
  State newest() {
    return state();
  }
}
