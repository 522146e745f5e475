package playhouse.client;

/**
 * The data of a base.
 *
 * @param pose In the frame of the estimate: with odometry that of the start pose, or as set by setOdometry(); with
 *     localization by gps the world.
 * @param velocity In the robot's frame.
 * @param stalled Whether the robot is blocked.
 * @param time The server's, in s.
 */
public record State(Pose pose, Velocity velocity, boolean stalled, double time) {}
