package playhouse.client;

import playhouse.client.wire.PtzMessages;

/** A pan-tilt-zoom mount of a camera. */
public final class Ptz extends Updating<View> {
  Ptz(Opening opening) {
    super(opening);
  }

  /** The current direction and field of view. Throws NoDataException. */
  public View view() {
    PtzMessages.Data data = stamped(PtzMessages.DATA_STATE).value();
    return new View(data.pan(), data.tilt(), data.zoom(), data.panspeed(), data.tiltspeed());
  }

  /** Turns to these angles in rad, in position control, and keeps the field of view. */
  public void look(double pan, double tilt) {
    look(pan, tilt, 0);
  }

  /** Turns to these angles in rad, in position control; a zoom of 0 keeps the field of view. */
  public void look(double pan, double tilt, double zoom) {
    command(PtzMessages.CMD_STATE,
        new PtzMessages.Cmd(narrowed("pan", pan), narrowed("tilt", tilt), narrowed("zoom", zoom), 0, 0));
  }

  /** Turns at these speeds in rad/s; requires setVelocityControl(true). */
  public void turn(double panSpeed, double tiltSpeed) {
    command(PtzMessages.CMD_STATE,
        new PtzMessages.Cmd(0, 0, 0, narrowed("pan_speed", panSpeed), narrowed("tilt_speed", tiltSpeed)));
  }

  /** Selects velocity control, or position control. */
  public void setVelocityControl(boolean on) {
    int mode = on ? PtzMessages.VELOCITY_CONTROL : PtzMessages.POSITION_CONTROL;
    request(PtzMessages.REQ_CONTROL_MODE, new PtzMessages.ReqControlMode(mode));
  }

  public Geometry geometry() {
    PtzMessages.Geom geom = answer(PtzMessages.REQ_GEOM);
    return Geometry.of(geom.pos(), geom.size());
  }

  @Override
  View newest() {
    return view();
  }
}
