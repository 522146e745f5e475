package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** Extents in m along x (length), y (width) and z (height). */
public record Size(double x, double y, double z) {
  static Size of(CommonMessages.Bbox3d size) {
    return new Size(size.sl(), size.sw(), size.sh());
  }
}
