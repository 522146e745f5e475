package playhouse.client;

/**
 * A hypothesis about where the robot is.
 *
 * @param pose The mean, on the map.
 * @param covariance Of that pose.
 * @param weight The weights of all hypotheses sum to 1.
 */
public record Hypothesis(Pose pose, Covariance covariance, double weight) {}
