package playhouse.client;

import java.util.List;
import playhouse.client.wire.Pointcloud3dMessages;

/** A 3D point cloud, such as that of a lidar with several rings. */
public final class PointCloud3d extends Updating<List<CloudPoint>> {
  PointCloud3d(Opening opening) {
    super(opening);
  }

  /** The newest points. Throws NoDataException. */
  public List<CloudPoint> points() {
    return stamped(Pointcloud3dMessages.DATA_STATE).value().points().stream().map(PointCloud3d::pointOf).toList();
  }

  @Override
  List<CloudPoint> newest() {
    return points();
  }

  private static CloudPoint pointOf(Pointcloud3dMessages.Element one) {
    Color color = new Color(one.color().red(), one.color().green(), one.color().blue(), one.color().alpha());
    return new CloudPoint(one.point().px(), one.point().py(), one.point().pz(), color);
  }
}
