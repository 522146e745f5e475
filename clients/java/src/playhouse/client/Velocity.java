package playhouse.client;

/** x and y in m/s, a in rad/s, in the robot's frame. */
public record Velocity(double x, double y, double a) {}
