package playhouse.client;

import java.time.Duration;

/** The end of a wait, on the clock of System.nanoTime(). */
record Deadline(long nanos) {
  private static final Duration LONGEST = Duration.ofDays(10_000);  // longer waits are as good as endless

  /** Checks a time-out: 0 or more. */
  static Duration checked(Duration timeout) {
    if (timeout.isNegative()) {
      throw new InvalidValueException("invalid time-out of " + Words.seconds(timeout) + " s: 0 or more is valid");
    }
    return timeout;
  }

  static Deadline after(Duration timeout) {
    Duration bounded = timeout.compareTo(LONGEST) < 0 ? timeout : LONGEST;
    return new Deadline(System.nanoTime() + bounded.toNanos());
  }

  /** The time until then; zero if it has passed. */
  Duration left() {
    return Duration.ofNanos(Math.max(0, nanos - System.nanoTime()));
  }

  boolean isPast() {
    return nanos - System.nanoTime() <= 0;
  }
}
