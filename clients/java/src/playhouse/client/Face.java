package playhouse.client;

/**
 * The face of a bumper switch.
 *
 * @param pose Of its centre on the robot; yaw: outward direction.
 * @param length In m.
 * @param radius Of curvature, in m; 0 if it is straight.
 */
public record Face(Pose3d pose, double length, double radius) {}
