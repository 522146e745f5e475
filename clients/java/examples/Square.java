package examples;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Locale;
import playhouse.client.Client;
import playhouse.client.Point;
import playhouse.client.Pose;
import playhouse.client.Position2d;
import playhouse.client.State;

/**
 * Drives once around a square of 1.5 m, by odometry: forward, left, and back to where it began.
 *
 * <pre>square [HOST:PORT [INDEX [SECONDS]]]      robot INDEX (0), for at most SECONDS (0: until it is done)</pre>
 */
final class Square {
  private static final double SIDE = 1.5;  // m
  private static final double REACHED = 0.03;  // m
  private static final double ALIGNED = 0.02;  // rad
  private static final double SPEED = 0.4;  // m/s
  private static final double TURN = 1.0;  // rad/s

  public static void main(String[] arguments) {
    Program.run(arguments, "square [HOST:PORT [INDEX [SECONDS]]]", Square::square);
  }

  private static void square(Client client, int index, Clock clock, List<Integer> more) {
    try (Position2d robot = client.position2d(index)) {
      robot.nextData();
      Pose start = robot.pose();
      goRound(robot, start, clock);
      for (State state : robot.updates()) {
        double aside = normalized(start.a() - state.pose().a());
        if (clock.isUp() || Math.abs(aside) < ALIGNED) {
          break;
        }
        robot.drive(0, turn(aside));
      }
    }
  }

  private static void goRound(Position2d robot, Pose start, Clock clock) {
    ArrayDeque<Point> corners = new ArrayDeque<>(
        List.of(new Point(SIDE, 0), new Point(SIDE, SIDE), new Point(0, SIDE), new Point(0, 0)));
    for (State state : robot.updates()) {
      if (clock.isUp() || corners.isEmpty()) {
        break;
      }
      Pose here = seenFrom(start, state.pose());
      double ahead = corners.element().x() - here.x();
      double left = corners.element().y() - here.y();
      double distance = Math.hypot(ahead, left);
      if (distance < REACHED) {
        corners.remove();
        System.out.printf(Locale.ROOT, "corner %d at (%.2f, %.2f) m%n", 4 - corners.size(), here.x(), here.y());
        robot.stop();
        continue;
      }
      double aside = normalized(Math.atan2(left, ahead) - here.a());
      robot.drive(Math.abs(aside) > 0.15 ? 0 : Math.min(SPEED, Math.max(0.05, distance)), turn(aside));
    }
  }

  private static double turn(double aside) {
    return Math.max(-TURN, Math.min(TURN, 2 * aside));
  }

  /** The same place in the frame of {@code origin}. */
  private static Pose seenFrom(Pose origin, Pose pose) {
    double dx = pose.x() - origin.x();
    double dy = pose.y() - origin.y();
    double c = Math.cos(origin.a());
    double s = Math.sin(origin.a());
    return new Pose(c * dx + s * dy, c * dy - s * dx, normalized(pose.a() - origin.a()));
  }

  private static double normalized(double angle) {
    return Math.atan2(Math.sin(angle), Math.cos(angle));
  }

  private Square() {}
}
