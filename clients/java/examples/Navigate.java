package examples;

import java.util.List;
import java.util.Locale;
import playhouse.client.Client;
import playhouse.client.Planner;
import playhouse.client.PlannerState;
import playhouse.client.Pose;

/**
 * Sends a robot to two places on the map of worlds/navigate.cfg, one after the other.
 *
 * <pre>navigate [HOST:PORT [INDEX [SECONDS]]]      planner INDEX (0), for at most SECONDS (0: until it is done)</pre>
 */
final class Navigate {
  private static final List<Pose> PLACES = List.of(new Pose(6, 4, 1.5), new Pose(-5.8, 5, 3));  // m, m, rad

  public static void main(String[] arguments) {
    Program.run(arguments, "navigate [HOST:PORT [INDEX [SECONDS]]]", Navigate::navigate);
  }

  private static void navigate(Client client, int index, Clock clock, List<Integer> more) {
    try (Planner planner = client.planner(index)) {
      for (Pose place : PLACES) {
        planner.goTo(place);
        for (PlannerState state : planner.updates()) {
          if (clock.isUp()) {
            return;
          }
          if (planner.hasArrived()) {
            System.out.printf(Locale.ROOT, "arrived at (%.2f, %.2f) m%n", state.pose().x(), state.pose().y());
            break;
          }
        }
      }
    }
  }

  private Navigate() {}
}
