package examples;

import java.util.List;
import playhouse.client.Client;
import playhouse.client.Laser;
import playhouse.client.Position2d;
import playhouse.client.Scan;

/**
 * Wanders about by laser and runs into nothing.
 *
 * <pre>wander [HOST:PORT [INDEX [SECONDS]]]      robot and laser INDEX (0), for SECONDS (0: until Ctrl-C)</pre>
 */
final class Wander {
  private static final double SPEED = 0.4;  // m/s
  private static final double TURN = 0.8;  // rad/s
  private static final double FRONT = 0.5;  // rad to either side that the robot needs to pass
  private static final double NEAR = 0.6;  // m

  public static void main(String[] arguments) {
    Program.run(arguments, "wander [HOST:PORT [INDEX [SECONDS]]]", Wander::wander);
  }

  private static void wander(Client client, int index, Clock clock, List<Integer> more) {
    try (Position2d robot = client.position2d(index); Laser laser = client.laser(index)) {
      double turning = 0;
      for (Scan scan : laser.updates()) {
        if (clock.isUp()) {
          break;
        }
        double ahead = scan.nearest(-FRONT, FRONT);
        double left = scan.nearest(FRONT, 1.5);
        double right = scan.nearest(-1.5, -FRONT);
        if (ahead < NEAR) {
          turning = turning != 0 ? turning : left > right ? TURN : -TURN;  // latched until the way ahead is clear
          robot.drive(0, turning);
        } else {
          turning = 0;
          double sway = Math.min(left, right) < NEAR ? 0.5 * (left - right) : 0;
          robot.drive(Math.min(SPEED, ahead - NEAR + 0.1), Math.max(-TURN, Math.min(TURN, sway)));
        }
      }
    }
  }

  private Wander() {}
}
