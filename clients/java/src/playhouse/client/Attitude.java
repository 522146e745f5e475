package playhouse.client;

/** Roll, pitch and yaw in rad. */
public record Attitude(double roll, double pitch, double yaw) {}
