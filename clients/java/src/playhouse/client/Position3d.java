package playhouse.client;

import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Position3dMessages;

/** A mobile base in space. Closing it while it moves stops it first. */
public final class Position3d extends Mobile<State3d> {
  Position3d(Opening opening) {
    super(opening);
  }

  /** The newest data. Throws NoDataException. */
  public State3d state() {
    Stamped<Position3dMessages.Data> data = stamped(Position3dMessages.DATA_STATE);
    return new State3d(
        Pose3d.of(data.value().pos()), Pose3d.of(data.value().vel()), data.value().stall() != 0, data.time());
  }

  /** Moves straight ahead, in m/s, until the next command. */
  public void drive(double vx) {
    drive(vx, 0);
  }

  /** Forward in m/s, turning in rad/s, until the next command. */
  public void drive(double vx, double va) {
    drive(vx, va, 0, 0);
  }

  /** Forward, to the left and upwards in m/s, turning in rad/s, until the next command. */
  public void drive(double vx, double va, double vy, double vz) {
    insistOnFinite("vx", vx);
    insistOnFinite("va", va);
    insistOnFinite("vy", vy);
    insistOnFinite("vz", vz);
    setMoving(vx != 0 || vy != 0 || vz != 0 || va != 0);
    command(Position3dMessages.CMD_SET_VEL,
        new Position3dMessages.CmdVel(new CommonMessages.Pose3d(vx, vy, vz, 0, 0, va), 1));
  }

  @Override
  public void stop() {
    drive(0);
  }

  /** Moves to a pose in the frame of state(), by the driver's position control. */
  public void goTo(Pose3d pose) {
    insistOnFinite(pose);
    setMoving(true);
    command(Position3dMessages.CMD_SET_POS,
        new Position3dMessages.CmdPos(pose.onWire(), new CommonMessages.Pose3d(), 1));
  }

  public void setMotorPower(boolean on) {
    request(Position3dMessages.REQ_MOTOR_POWER, new Position3dMessages.PowerConfig(on ? 1 : 0));
  }

  /** Sets the pose estimate, that of state(). */
  public void setOdometry(Pose3d pose) {
    insistOnFinite(pose);
    request(Position3dMessages.REQ_SET_ODOM, new Position3dMessages.SetOdomReq(pose.onWire()));
  }

  /** Sets the pose estimate to zero. */
  public void resetOdometry() {
    request(Position3dMessages.REQ_RESET_ODOM);
  }

  public Geometry geometry() {
    Position3dMessages.Geom geom = answer(Position3dMessages.REQ_GET_GEOM);
    return Geometry.of(geom.pose(), geom.size());
  }

  @Override
  State3d newest() {
    return state();
  }
}
