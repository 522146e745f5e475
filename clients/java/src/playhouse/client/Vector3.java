package playhouse.client;

/** Three numbers, along or about the axes x, y and z. */
public record Vector3(double x, double y, double z) {}
