package playhouse.client;

import playhouse.client.wire.LaserMessages;

/** A laser scanner; its data include the directions of the beams. */
public final class Laser extends Updating<Scan> {
  Laser(Opening opening) {
    super(opening);
  }

  /** The newest scan. Throws NoDataException. */
  public Scan scan() {
    Stamped<LaserMessages.Data> stamped = stamped(LaserMessages.DATA_SCAN);
    LaserMessages.Data data = stamped.value();
    double[] ranges = Doubles.of(data.ranges());
    double[] angles = Scan.spread(data.minAngle(), data.maxAngle(), ranges.length);
    return new Scan(ranges, angles, data.maxRange(), stamped.time());
  }

  /** In m, from minAngle to maxAngle. Throws NoDataException. */
  public double[] ranges() {
    return scan().ranges();
  }

  /** One per range, in the device's unit; empty if it measures none. Throws NoDataException. */
  public byte[] intensities() {
    return stamped(LaserMessages.DATA_SCAN).value().intensity();
  }

  public LaserMessages.Config config() {
    return answer(LaserMessages.REQ_GET_CONFIG);
  }

  public void setConfig(LaserMessages.Config config) {
    request(LaserMessages.REQ_SET_CONFIG, config);
  }

  public Geometry geometry() {
    LaserMessages.Geom geom = answer(LaserMessages.REQ_GET_GEOM);
    return Geometry.of(geom.pose(), geom.size());
  }

  @Override
  Scan newest() {
    return scan();
  }
}
