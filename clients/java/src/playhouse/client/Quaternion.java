package playhouse.client;

/** An orientation: w is the real part. */
public record Quaternion(double w, double x, double y, double z) {}
