package playhouse.client;

/** Covariance of a pose in the plane, of x, y (m) and a (rad): xx, yy and aa are variances. */
public record Covariance(double xx, double yy, double aa, double xy, double ya, double xa) {
  /** All zero: the pose is certain. */
  public Covariance() {
    this(0, 0, 0, 0, 0, 0);
  }

  /** That of independent errors with these standard deviations, in m, m and rad. */
  public static Covariance ofDeviations(double x, double y, double a) {
    return new Covariance(x * x, y * y, a * a, 0, 0, 0);
  }

  static Covariance of(double[] six) {
    return new Covariance(six[0], six[1], six[2], six[3], six[4], six[5]);
  }

  double[] onWire() {
    return new double[] {xx, yy, aa, xy, ya, xa};
  }
}
