package playhouse.client;

/**
 * A fix of a satellite receiver.
 *
 * @param latitude In degrees.
 * @param longitude In degrees.
 * @param altitude In m above the ellipsoid (WGS84).
 * @param easting Of UTM, in m.
 * @param northing Of UTM, in m.
 * @param speed In m/s.
 * @param course In rad, clockwise from north.
 * @param quality 0 without a fix, and then the rest is invalid.
 * @param satellites Number in view.
 * @param horizontalError Expected, in m.
 * @param verticalError Expected, in m.
 * @param time The server's, in s.
 */
public record Fix(
    double latitude, double longitude, double altitude, double easting, double northing, double speed, double course,
    long quality, long satellites, double horizontalError, double verticalError, double time) {}
