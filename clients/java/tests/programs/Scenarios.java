package programs;

import java.util.Map;
import java.util.function.Consumer;
import playhouse.client.Client;
import playhouse.client.Device;
import playhouse.client.Laser;
import playhouse.client.Mode;
import playhouse.client.Options;
import playhouse.client.Pose;
import playhouse.client.Position2d;
import playhouse.client.Ranger;
import playhouse.client.RequestRefusedException;
import playhouse.client.Rule;
import playhouse.client.Simulation;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.LaserMessages;
import playhouse.client.wire.MapMessages;
import playhouse.client.wire.RangerMessages;

/**
 * Repeats the programs behind the recorded sessions with this library: scenarios NAME HOST:PORT.
 * clients/python/tests/test_replay.py plays back the recorded answers and compares what the client sends;
 * clients/python/tests/scenarios.py is the Python counterpart.
 */
final class Scenarios {
  private static final Options PUSH = Options.DEFAULT.withMode(Mode.PUSH);
  private static final Map<String, Consumer<String>> ALL = Map.of(
      "05_playerprint_position2d", Scenarios::printPosition,
      "06_playerprint_defaults", Scenarios::printDefaults,
      "10_cxxtest_position2d", Scenarios::checkPosition,
      "11_cxxtest_laser", Scenarios::checkLaser,
      "12_cxxtest_ranger", Scenarios::checkRanger,
      "13_raw_map", Scenarios::queryMap,
      "14_raw_simulation", Scenarios::querySimulation,
      "15_raw_properties", Scenarios::queryProperties);

  public static void main(String[] arguments) {
    if (arguments.length != 2 || !ALL.containsKey(arguments[0])) {
      System.err.println("usage: scenarios NAME HOST:PORT");
      System.exit(1);
    }
    ALL.get(arguments[0]).accept(arguments[1]);
  }

  private static void printPosition(String address) {
    try (Client client = Client.connect(address); Position2d robot = client.position2d(0)) {
      client.setMode(Mode.PULL);
      client.setReplaceRule(Rule.ACCEPT);
      readRounds(client, 3);
    }
  }

  private static void printDefaults(String address) {
    try (Client client = Client.connect(address); Position2d robot = client.position2d(0)) {
      readRounds(client, 2);
    }
  }

  private static void checkPosition(String address) {
    try (Client client = Client.connect(address); Position2d robot = client.position2d(0)) {
      readRounds(client, 23);
      robot.setOdometry(new Pose(0.1, -0.2, Math.PI));
      readRounds(client, 10);
      robot.setOdometry(new Pose());
      robot.setMotorPower(true);
      robot.drive(0.1);
      robot.drive(-0.1);
      robot.drive(0, 0, 0.1);
      robot.drive(0, 0, -0.1);
      robot.drive(0, -25 * Math.PI / 180);
      robot.drive(0, 25 * Math.PI / 180);
      robot.drive(0, 45 * Math.PI / 180, 0.1);
      robot.drive(0, -45 * Math.PI / 180, -0.1);
      robot.stop();
      robot.setMotorPower(false);
      robot.setOdometry(new Pose());
    }
  }

  private static void checkLaser(String address) {
    try (Client client = Client.connect(address); Laser laser = client.laser(0)) {
      readRounds(client, 20);
      float quarter = (float) (Math.PI / 2);
      mustRefuse(() -> laser.setConfig(new LaserMessages.Config(-quarter, quarter, 100, 0, 1, 1, 10)));
    }
  }

  private static void checkRanger(String address) {
    try (Client client = Client.connect(address); Ranger ranger = client.ranger(1)) {
      readRounds(client, 60);
      ranger.request(RangerMessages.REQ_GET_GEOM);
      readRounds(client, 3);
    }
  }

  private static void queryMap(String address) {
    try (Client client = Client.connect(address, PUSH); Device device = client.device("map", 0)) {
      device.request(MapMessages.REQ_GET_INFO);
      device.request(MapMessages.REQ_GET_DATA, new MapMessages.Data(0, 0, 20, 10, 0, new byte[0]));
      device.request(MapMessages.REQ_GET_DATA, new MapMessages.Data(495, 0, 50, 3, 0, new byte[0]));
      mustRefuse(() -> device.request(MapMessages.REQ_GET_VECTOR));
    }
  }

  private static void querySimulation(String address) {
    try (Client client = Client.connect(address, PUSH); Simulation simulation = client.simulation(0)) {
      simulation.pose("r0");
      simulation.setPose("r0", new Pose(-6, -6, 0.5));
      mustRefuse(() -> simulation.pose("nosuch"));
      simulation.pose3d("r0");
    }
  }

  private static void queryProperties(String address) {
    try (Client client = Client.connect(address, PUSH)) {
      Device lights = client.device("dio", 0);
      Device stream = client.device("opaque", 1);
      lights.getInt("skip_lines");
      lights.setInt("skip_lines", 7);
      lights.getInt("skip_lines");
      lights.getDouble("max_diff_pixels");
      lights.setDouble("max_diff_pixels", 0.25);
      lights.getDouble("max_diff_pixels");
      lights.getInt("max_diff_pixels");
      mustRefuse(() -> lights.getInt("nope"));
      lights.hasCapability(CommonMessages.REQ_CAPABILITIES);
      stream.getString("ip");
      stream.setString("ip", "127.0.0.2");
      stream.getString("ip");
      mustRefuse(() -> stream.getBoolean("nobool"));
    }
  }

  private static void readRounds(Client client, int count) {
    for (int i = 0; i < count; ++i) {
      client.read();
    }
  }

  private static void mustRefuse(Runnable action) {
    try {
      action.run();
    } catch (RequestRefusedException error) {
      return;
    }
    throw new AssertionError("the server should have refused this");
  }

  private Scenarios() {}
}
