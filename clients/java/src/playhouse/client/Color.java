package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** Each from 0 to 255; alpha 255 is opaque. */
public record Color(int red, int green, int blue, int alpha) {
  /** An opaque color. */
  public Color(int red, int green, int blue) {
    this(red, green, blue, 255);
  }

  static Color of(CommonMessages.Color color) {
    return new Color(color.red(), color.green(), color.blue(), color.alpha());
  }

  CommonMessages.Color onWire() {
    return new CommonMessages.Color(alpha, red, green, blue);
  }
}
