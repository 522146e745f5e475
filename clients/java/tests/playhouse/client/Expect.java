package playhouse.client;

import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.time.Duration;
import java.util.regex.Pattern;
import org.junit.function.ThrowingRunnable;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Position2dMessages;

/** What the tests of this library share. */
final class Expect {
  static final Options PUSH = Options.DEFAULT.withMode(Mode.PUSH);

  /** The action throws this error, and its text has the pattern in it. */
  static <E extends PlayerException> E error(Class<E> type, String pattern, ThrowingRunnable action) {
    E error = assertThrows(type, action);
    assertTrue(error.getMessage(), Pattern.compile(pattern).matcher(error.getMessage()).find());
    return error;
  }

  static Duration millis(long number) {
    return Duration.ofMillis(number);
  }

  /** Data of a base at this x. */
  static Position2dMessages.Data state(double x) {
    return new Position2dMessages.Data(new CommonMessages.Pose2d(x, 0, 0), new CommonMessages.Pose2d(), 0);
  }

  private Expect() {}
}
