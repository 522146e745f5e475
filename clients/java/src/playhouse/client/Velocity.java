package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** x and y in m/s, a in rad/s, in the robot's frame. */
public record Velocity(double x, double y, double a) {
  static Velocity of(CommonMessages.Pose2d velocity) {
    return new Velocity(velocity.px(), velocity.py(), velocity.pa());
  }
}
