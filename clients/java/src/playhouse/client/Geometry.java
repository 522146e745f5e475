package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** Pose of a device on its robot (for a base: its own centre), and its size. */
public record Geometry(Pose3d pose, Size size) {
  static Geometry of(CommonMessages.Pose3d pose, CommonMessages.Bbox3d size) {
    return new Geometry(Pose3d.of(pose), Size.of(size));
  }
}
