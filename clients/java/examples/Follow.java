package examples;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import playhouse.client.Client;
import playhouse.client.Fiducial;
import playhouse.client.Marker;
import playhouse.client.Position2d;

/**
 * Follows a marker and keeps a metre away from it.
 *
 * <pre>follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]</pre>
 *
 * Robot INDEX (0), for SECONDS (0: until Ctrl-C), after the marker of number MARKER (the nearest of any
 * number), seen by the fiducial finder FINDER (INDEX).
 */
final class Follow {
  private static final double DISTANCE = 1.0;  // m
  private static final double SPEED = 0.5;  // m/s
  private static final double TURN = 1.0;  // rad/s

  public static void main(String[] arguments) {
    Program.run(arguments, "follow [HOST:PORT [INDEX [SECONDS [MARKER [FINDER]]]]]", Follow::follow);
  }

  private static void follow(Client client, int index, Clock clock, List<Integer> more) {
    int finderIndex = more.size() > 1 ? more.get(1) : index;
    try (Position2d robot = client.position2d(index); Fiducial finder = client.fiducial(finderIndex)) {
      boolean lostToTheLeft = true;
      for (List<Marker> markers : finder.updates()) {
        if (clock.isUp()) {
          break;
        }
        Optional<Marker> marker = choose(markers, more);
        if (marker.isEmpty()) {
          // Marker lost: search, turning first to the side where it was last seen.
          robot.drive(0, lostToTheLeft ? TURN / 2 : -TURN / 2);
          continue;
        }
        double bearing = marker.get().bearing();
        lostToTheLeft = bearing > 0;
        double speed = Math.max(-SPEED, Math.min(SPEED, marker.get().distance() - DISTANCE));
        robot.drive(Math.abs(bearing) < 1 ? speed : 0, Math.max(-TURN, Math.min(TURN, 2 * bearing)));
      }
    }
  }

  /** The nearest marker of the wanted number, the first of {@code wanted}, if there is one. */
  private static Optional<Marker> choose(List<Marker> markers, List<Integer> wanted) {
    return markers.stream().filter(marker -> wanted.isEmpty() || marker.id() == wanted.get(0))
        .min(Comparator.comparingDouble(Marker::distance));
  }

  private Follow() {}
}
