package playhouse.client;

import java.util.List;
import playhouse.client.wire.FiducialMessages;

/** A fiducial finder. */
public final class Fiducial extends Updating<List<Marker>> {
  Fiducial(Opening opening) {
    super(opening);
  }

  /** Markers in view. Throws NoDataException. */
  public List<Marker> markers() {
    return stamped(FiducialMessages.DATA_SCAN).value().fiducials().stream()
        .map(item -> new Marker(item.id(), Pose3d.of(item.pose()))).toList();
  }

  public FiducialMessages.Fov fieldOfView() {
    return answer(FiducialMessages.REQ_GET_FOV);
  }

  /** Ranges in m, the full field of view in rad. */
  public void setFieldOfView(double minRange, double maxRange, double viewAngle) {
    request(FiducialMessages.REQ_SET_FOV, new FiducialMessages.Fov(
        narrowed("min_range", minRange), narrowed("max_range", maxRange), narrowed("view_angle", viewAngle)));
  }

  public Geometry geometry() {
    FiducialMessages.Geom geom = answer(FiducialMessages.REQ_GET_GEOM);
    return Geometry.of(geom.pose(), geom.size());
  }

  @Override
  List<Marker> newest() {
    return markers();
  }
}
