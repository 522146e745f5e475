package examples;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import playhouse.client.Access;
import playhouse.client.Client;
import playhouse.client.Opaque;
import playhouse.client.Position2d;
import playhouse.client.State;

/**
 * Tells the other robots by radio where it is, twice a second, and prints what it hears of them.
 *
 * <pre>talk [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0) with radio INDEX, for SECONDS (0: until Ctrl-C)</pre>
 *
 * Start it once for each robot that is to talk: it only looks at the robot, and whoever drives it goes on.
 */
final class Talk {
  private static final double PERIOD = 0.5;  // s, simulated

  public static void main(String[] arguments) {
    Program.run(arguments, "talk [HOST:PORT [INDEX [SECONDS]]]", Talk::talk);
  }

  private static void talk(Client client, int index, Clock clock, List<Integer> more) {
    try (Position2d robot = client.position2d(index, Access.READ); Opaque radio = client.opaque(index)) {
      double nextTime = 0;
      for (State state : robot.updates()) {
        if (clock.isUp()) {
          break;
        }
        for (byte[] message : radio.takeMessages()) {
          System.out.printf(
              Locale.ROOT, "%.1f s: %s%n", state.time(), new String(message, StandardCharsets.UTF_8));
        }
        if (state.time() >= nextTime) {
          String text = String.format(
              Locale.ROOT, "robot %d is at %.2f %.2f", index, state.pose().x(), state.pose().y());
          radio.send(text.getBytes(StandardCharsets.UTF_8));
          nextTime = state.time() + PERIOD;
        }
      }
    }
  }

  private Talk() {}
}
