package playhouse.client;

import java.util.List;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.RangerMessages;

/** A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration. */
public final class Ranger extends Updating<Scan> {
  private RangerMessages.Config config = new RangerMessages.Config();
  private RangerMessages.Geom geom = new RangerMessages.Geom();

  Ranger(Opening opening) {
    super(opening);
  }

  @Override
  void prepare() {
    config = answer(RangerMessages.REQ_GET_CONFIG);
    geom = answer(RangerMessages.REQ_GET_GEOM);
  }

  /** The configuration in effect; all zero if the driver tells none. */
  public RangerMessages.Config config() {
    return config;
  }

  /** Poses and sizes of the device and of its elements; all zero if the driver tells none. */
  public RangerMessages.Geom geom() {
    return geom;
  }

  /** In m, in the order of measurement. Throws NoDataException. */
  public double[] ranges() {
    return stamped(RangerMessages.DATA_RANGE).value().ranges();
  }

  /** One per range, in the device's unit. Throws NoDataException also for a device without intensities. */
  public double[] intensities() {
    return stamped(RangerMessages.DATA_INTNS).value().intensities();
  }

  /**
   * Ranges with directions: those of the elements if there is one per range, else spread over the field of
   * view. Throws NoDataException.
   */
  public Scan scan() {
    Stamped<RangerMessages.DataRange> data = stamped(RangerMessages.DATA_RANGE);
    double[] ranges = data.value().ranges();
    List<CommonMessages.Pose3d> poses = geom.elementPoses();
    double[] angles = poses.size() == ranges.length && ranges.length > 1
        ? poses.stream().mapToDouble(CommonMessages.Pose3d::pyaw).toArray()
        : Scan.spread(config.minAngle(), config.maxAngle(), ranges.length);
    return new Scan(ranges, angles, config.maxRange(), data.time());
  }

  public Geometry geometry() {
    return Geometry.of(geom.pose(), geom.size());
  }

  public void setPower(boolean on) {
    request(RangerMessages.REQ_POWER, new RangerMessages.PowerConfig(on ? 1 : 0));
  }

  /** Enables or disables intensities. */
  public void setIntensities(boolean on) {
    request(RangerMessages.REQ_INTNS, new RangerMessages.IntnsConfig(on ? 1 : 0));
  }

  /** Requests another configuration; config() then has the values in effect. */
  public void setConfig(RangerMessages.Config wanted) {
    request(RangerMessages.REQ_SET_CONFIG, wanted);
    config = answer(RangerMessages.REQ_GET_CONFIG);
  }

  @Override
  Scan newest() {
    return scan();
  }
}
