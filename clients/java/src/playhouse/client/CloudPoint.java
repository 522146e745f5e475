package playhouse.client;

/** A point of a cloud, in m in the sensor's frame, and its color. */
public record CloudPoint(double x, double y, double z, Color color) {}
