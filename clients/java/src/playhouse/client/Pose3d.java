package playhouse.client;

import playhouse.client.wire.CommonMessages;

/**
 * A pose in space: rotations about z by yaw, then about the new y by pitch, then about the new x by roll. The
 * frame is documented where a pose is returned.
 *
 * @param x In m.
 * @param y In m.
 * @param z In m.
 * @param roll In rad.
 * @param pitch In rad.
 * @param yaw In rad.
 */
public record Pose3d(double x, double y, double z, double roll, double pitch, double yaw) {
  /** The origin of the frame. */
  public Pose3d() {
    this(0, 0, 0, 0, 0, 0);
  }

  static Pose3d of(CommonMessages.Pose3d pose) {
    return new Pose3d(pose.px(), pose.py(), pose.pz(), pose.proll(), pose.ppitch(), pose.pyaw());
  }

  static Pose3d of(CommonMessages.Point3d point, CommonMessages.Orientation3d turns) {
    return new Pose3d(point.px(), point.py(), point.pz(), turns.proll(), turns.ppitch(), turns.pyaw());
  }

  CommonMessages.Pose3d onWire() {
    return new CommonMessages.Pose3d(x, y, z, roll, pitch, yaw);
  }
}
