package playhouse.client;

/**
 * The data of a base that moves in space.
 *
 * @param pose In the frame of the estimate.
 * @param velocity In m/s and rad/s, along and about the base's own axes.
 * @param stalled Whether the base is blocked.
 * @param time The server's, in s.
 */
public record State3d(Pose3d pose, Pose3d velocity, boolean stalled, double time) {}
