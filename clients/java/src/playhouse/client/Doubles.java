package playhouse.client;

/** Numbers of 32 bits as such of 64. */
final class Doubles {
  static double[] of(float[] values) {
    double[] out = new double[values.length];
    for (int i = 0; i < values.length; ++i) {
      out[i] = values[i];
    }
    return out;
  }

  private Doubles() {}
}
