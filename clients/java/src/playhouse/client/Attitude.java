package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** Roll, pitch and yaw in rad. */
public record Attitude(double roll, double pitch, double yaw) {
  static Attitude of(CommonMessages.Orientation3d turns) {
    return new Attitude(turns.proll(), turns.ppitch(), turns.pyaw());
  }

  CommonMessages.Pose3d onWire() {
    return new CommonMessages.Pose3d(0, 0, 0, roll, pitch, yaw);
  }
}
