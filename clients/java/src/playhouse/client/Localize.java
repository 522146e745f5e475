package playhouse.client;

import java.util.List;
import playhouse.client.wire.LocalizeMessages;

/** Localization of a robot on a map. */
public final class Localize extends Updating<List<Hypothesis>> {
  Localize(Opening opening) {
    super(opening);
  }

  /** Where the robot may be, the most likely first. Throws NoDataException. */
  public List<Hypothesis> hypotheses() {
    return stamped(LocalizeMessages.DATA_HYPOTHS).value().hypoths().stream()
        .map(one -> new Hypothesis(Pose.of(one.mean()), Covariance.of(one.cov()), one.alpha())).toList();
  }

  /** The pose on the map of the most likely hypothesis. Throws NoDataException also if there is none. */
  public Pose pose() {
    List<Hypothesis> hypotheses = hypotheses();
    if (hypotheses.isEmpty()) {
      throw new NoDataException(session().peer() + ": " + name() + " has no hypothesis");
    }
    return hypotheses.get(0).pose();
  }

  /**
   * Sets the estimate of the pose on the map; the robot does not move. Throws RequestRefusedException if the
   * driver takes none of this covariance.
   */
  public void setPose(Pose pose, Covariance covariance) {
    insistOnFinite(pose);
    insistOnFinite("xx", covariance.xx());
    insistOnFinite("yy", covariance.yy());
    insistOnFinite("aa", covariance.aa());
    insistOnFinite("xy", covariance.xy());
    insistOnFinite("ya", covariance.ya());
    insistOnFinite("xa", covariance.xa());
    request(LocalizeMessages.REQ_SET_POSE, new LocalizeMessages.SetPose(pose.onWire(), covariance.onWire()));
  }

  /** All particles of the filter; none before its first step. */
  public List<Particle> particles() {
    return answer(LocalizeMessages.REQ_GET_PARTICLES).particles().stream()
        .map(one -> new Particle(Pose.of(one.pose()), one.alpha())).toList();
  }

  @Override
  List<Hypothesis> newest() {
    return hypotheses();
  }
}
