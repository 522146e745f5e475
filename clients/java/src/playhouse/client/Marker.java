package playhouse.client;

/** A marker in view: its id, and its pose in the sensor's frame. */
public record Marker(int id, Pose3d pose) {
  static Marker of(int id, Pose3d pose) {
    return new Marker(id, pose);
  }

  /** In m. */
  public double distance() {
    return Math.hypot(pose.x(), pose.y());
  }

  /** In rad, counter-clockwise from the sensor's x axis. */
  public double bearing() {
    return Math.atan2(pose.y(), pose.x());
  }
}
