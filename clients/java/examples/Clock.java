package examples;

/** How long a program may still run. */
final class Clock {
  private final double seconds;
  private final long start = System.nanoTime();
  private volatile boolean stopped;

  /** {@code seconds} 0: until a signal. */
  Clock(double seconds) {
    this.seconds = seconds > 0 ? seconds : Double.POSITIVE_INFINITY;
  }

  boolean isUp() {
    return stopped || (System.nanoTime() - start) * 1e-9 >= seconds;
  }

  void stop() {
    stopped = true;
  }
}
