package playhouse.client;

import java.util.List;
import playhouse.client.wire.SonarMessages;

/** A ring of sonars. */
public final class Sonar extends Device {
  Sonar(Opening opening) {
    super(opening);
  }

  /** In m, one per sonar, in the order of poses(). Throws NoDataException. */
  public double[] ranges() {
    return Doubles.of(stamped(SonarMessages.DATA_RANGES).value().ranges());
  }

  /** Poses of the sonars on the robot. */
  public List<Pose3d> poses() {
    return answer(SonarMessages.REQ_GET_GEOM).poses().stream().map(Pose3d::of).toList();
  }

  public void setPower(boolean on) {
    request(SonarMessages.REQ_POWER, new SonarMessages.PowerConfig(on ? 1 : 0));
  }
}
