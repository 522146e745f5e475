package playhouse.client;

import java.time.Duration;
import java.time.temporal.ChronoUnit;

/**
 * How a client connects.
 *
 * @param mode The delivery of data.
 * @param timeout Longest wait: for the connection, for the answer to every request, and of every read() without a
 *     time-out of its own. {@link #FOREVER} is endless.
 */
public record Options(Mode mode, Duration timeout) {
  public static final Duration FOREVER = ChronoUnit.FOREVER.getDuration();

  /** Pull mode, and five seconds. */
  public static final Options DEFAULT = new Options(Mode.PULL, Duration.ofSeconds(5));

  public Options withMode(Mode other) {
    return new Options(other, timeout);
  }

  public Options withTimeout(Duration other) {
    return new Options(mode, other);
  }
}
