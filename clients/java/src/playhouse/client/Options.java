package playhouse.client;

import java.time.Duration;
import java.time.temporal.ChronoUnit;

/**
 * How a client connects.
 *
 * @param mode The delivery of data.
 * @param timeout Longest wait: for the connection, for the answer to every request, and of every read() without a
 *     time-out of its own. {@link #FOREVER} is endless.
 * @param token A guest's, for a run with --guests; empty: none.
 */
public record Options(Mode mode, Duration timeout, String token) {
  public static final Duration FOREVER = ChronoUnit.FOREVER.getDuration();

  /** Pull mode, and five seconds. */
  public static final Options DEFAULT = new Options(Mode.PULL, Duration.ofSeconds(5));

  /** Without a token. */
  public Options(Mode mode, Duration timeout) {
    this(mode, timeout, "");
  }

  public Options withMode(Mode other) {
    return new Options(other, timeout, token);
  }

  public Options withTimeout(Duration other) {
    return new Options(mode, other, token);
  }

  public Options withToken(String other) {
    return new Options(mode, timeout, other);
  }
}
