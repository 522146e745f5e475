package playhouse.client;

/**
 * Measurements of an inertial unit along and about its own axes.
 *
 * @param acceleration Specific force in m/s^2, (0, 0, 9.81) when level and at rest.
 * @param turnRate In rad/s.
 * @param field Magnetic field, in a unit of the server.
 */
public record Inertia(Vector3 acceleration, Vector3 turnRate, Vector3 field) {}
