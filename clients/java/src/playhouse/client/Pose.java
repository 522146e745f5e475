package playhouse.client;

import playhouse.client.wire.CommonMessages;

/**
 * A pose in the plane. The frame is documented where a pose is returned.
 *
 * @param x In m.
 * @param y In m.
 * @param a Heading in rad, counter-clockwise, 0 along the frame's x, in (-pi, pi] as servers report it.
 */
public record Pose(double x, double y, double a) {
  /** The origin of the frame. */
  public Pose() {
    this(0, 0, 0);
  }

  static Pose of(CommonMessages.Pose2d pose) {
    return new Pose(pose.px(), pose.py(), pose.pa());
  }

  CommonMessages.Pose2d onWire() {
    return new CommonMessages.Pose2d(x, y, a);
  }
}
