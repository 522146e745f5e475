package playhouse.client;

import playhouse.client.wire.CommonMessages;

/** Three numbers, along or about the axes x, y and z. */
public record Vector3(double x, double y, double z) {
  static Vector3 of(CommonMessages.Point3d point) {
    return new Vector3(point.px(), point.py(), point.pz());
  }
}
