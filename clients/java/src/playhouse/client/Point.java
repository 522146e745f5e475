package playhouse.client;

/** A point in the plane, in m. */
public record Point(double x, double y) {}
