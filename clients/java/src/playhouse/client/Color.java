package playhouse.client;

/** Each from 0 to 255; alpha 255 is opaque. */
public record Color(int red, int green, int blue, int alpha) {}
