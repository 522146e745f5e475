package playhouse.client;

/**
 * State of a camera mount.
 *
 * @param pan To the left, in rad.
 * @param tilt Upwards, in rad.
 * @param zoom Horizontal field of view, in rad.
 * @param panSpeed In rad/s.
 * @param tiltSpeed In rad/s.
 */
public record View(double pan, double tilt, double zoom, double panSpeed, double tiltSpeed) {}
