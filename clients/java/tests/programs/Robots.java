package programs;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import playhouse.client.Camera;
import playhouse.client.Cell;
import playhouse.client.Client;
import playhouse.client.Covariance;
import playhouse.client.Device;
import playhouse.client.Gps;
import playhouse.client.Grid;
import playhouse.client.GridMap;
import playhouse.client.Image;
import playhouse.client.Imu;
import playhouse.client.InvalidValueException;
import playhouse.client.Localize;
import playhouse.client.NoDataException;
import playhouse.client.Opaque;
import playhouse.client.Options;
import playhouse.client.Path;
import playhouse.client.Planner;
import playhouse.client.PlayerException;
import playhouse.client.PointCloud3d;
import playhouse.client.Pose;
import playhouse.client.Pose3d;
import playhouse.client.Position2d;
import playhouse.client.Position3d;
import playhouse.client.Ptz;
import playhouse.client.RequestRefusedException;
import playhouse.client.Robot;
import playhouse.client.Simulation;
import playhouse.client.Speech;
import playhouse.client.SpeechRecognition;
import playhouse.client.View;
import playhouse.client.wire.ImuMessages;
import playhouse.client.wire.WifiMessages;

/**
 * Uses radio, camera, speech, IMU and drivers on a map of the real server through this library: robots
 * radio|camera|voice|inertia|course HOST:PORT, with worlds/radio.world, camera.world, radio.world,
 * outdoor.world or navigate.cfg respectively. Prints what fails and exits with 1. Run by
 * clients/python/tests/test_server.py.
 */
final class Robots {
  private static final Map<String, Consumer<String>> USES = Map.of(
      "radio", Robots::useRadios, "camera", Robots::useCameras, "voice", Robots::useVoices,
      "inertia", Robots::useInertia, "course", Robots::useDriversOnAMap, "guest", Robots::useToken);

  public static void main(String[] arguments) {
    try {
      mustBe(arguments.length == 2 && USES.containsKey(arguments[0]),
          "this is called as: robots radio|camera|voice|inertia|course|guest HOST:PORT");
      USES.get(arguments[0]).accept(arguments[1]);
    } catch (AssertionError | PlayerException error) {
      System.err.println(error.getMessage());
      System.exit(1);
    }
  }

  private static void useRadios(String address) {
    try (Client client = Client.connect(address); Client other = Client.connect(address)) {
      Opaque radio = client.robot("r0").opaque();
      Opaque receiver = other.robot("r1").opaque();
      List<String> sent = List.of("to all", "\0to one", "");
      radio.send(sent.get(0).getBytes(StandardCharsets.UTF_8));
      radio.sendTo(nearest(client), sent.get(1).getBytes(StandardCharsets.UTF_8));
      radio.sendTo("", new byte[0]);
      List<String> heard = new ArrayList<>();
      while (heard.size() < sent.size()) {
        other.read();
        receiver.takeMessages().forEach(message -> heard.add(new String(message, StandardCharsets.UTF_8)));
      }
      mustBe(heard.equals(sent), "messages come whole and in order");
      mustBe(radio.takeMessages().isEmpty(), "nobody hears itself");
      mustRefuse(() -> radio.sendTo("10.0.9.9", new byte[1]), "an address that no radio has");
      mustRefuse(() -> radio.sendTo("", new byte[2305]), "a message that is too long");
    }
  }

  /** Network address of the radio with the best link to this one. */
  private static String nearest(Client client) {
    try (Device air = client.device("wifi", 0)) {
      air.nextData();
      WifiMessages.Data data = air.latest(WifiMessages.DATA_STATE).orElseThrow();
      mustBe(!data.links().isEmpty(), "a radio hears another one");
      mustBe(data.links().get(0).level() < 0 && data.links().get(0).noise() == -100, "levels are in dBm");
      return new String(data.links().get(0).ip(), StandardCharsets.UTF_8);
    }
  }

  private static void useCameras(String address) {
    try (Client client = Client.connect(address)) {
      Robot robot = client.robot("r0");
      Camera color = robot.cameras().get(0);
      Camera depth = robot.cameras().get(1);
      Ptz mount = robot.ptz();
      color.nextData();
      depth.nextData();
      Image distances = depth.image();
      mustBe(color.image().width() == 160 && color.image().height() == 120 && !color.image().isJpeg(),
          "the picture is 160 x 120 and raw");
      mustBe(color.image().pixel(159, 119).length == 3, "a pixel in colors has three values");
      mustBe(distances.pixel(40, 59)[0] > 50, "the floor before the robot is more than 5 cm away");
      mustThrow(InvalidValueException.class, () -> distances.pixel(160, 0), "there is no pixel beside the picture");
      mustBe(mount.geometry().pose().x() == 0.12, "the camera is 12 cm before the robot's middle");
      mount.nextData();
      View before = mount.view();
      mount.look(before.pan() + 0.25, before.tilt());
      readUntil(client, () -> Math.abs(mount.view().pan() - before.pan() - 0.25) <= 0.001);
      mount.setVelocityControl(true);
      mount.turn(-0.5, 0);
      readUntil(client, () -> mount.view().pan() <= before.pan());
      mustBe(mount.view().panSpeed() < 0, "it turns to the right");
      mount.turn(0, 0);
    }
  }

  private static void useVoices(String address) {
    try (Client client = Client.connect(address); Client other = Client.connect(address)) {
      Speech voice = client.robot("r0").speech();
      SpeechRecognition ears = other.robot("r1").speechRecognition();
      other.robot("r1").speech().say("my own voice");
      List<String> heard = new ArrayList<>();
      for (String words : List.of("marco", "sch\u00f6n")) {
        voice.say(words);
        while (!heard.contains(words)) {
          other.read();
          heard.addAll(ears.takeTexts());
        }
      }
      mustBe(heard.equals(List.of("marco", "sch\u00f6n")), "a robot hears others in order and not itself");
    }
  }

  private static void useInertia(String address) {
    try (Client client = Client.connect(address)) {
      Robot robot = client.robot("r0");
      Position3d base = robot.position3d();
      Imu unit = robot.imu();
      Gps receiver = robot.gps();
      PointCloud3d lidar = robot.pointCloud3d();
      mustThrow(NoDataException.class, unit::inertia, "there are no data before the first");
      mustThrow(NoDataException.class, unit::attitude, "there are no data before the first");
      unit.send(ImuMessages.DATA_EULER);
      readUntil(client, () -> base.hasData() && unit.latest(ImuMessages.DATA_EULER).isPresent() && receiver.hasData()
          && lidar.hasData() && !lidar.points().isEmpty());
      mustBe(Math.abs(unit.inertia().acceleration().z() - 9.81) < 1, "it feels gravity");
      mustBe(Math.abs(unit.attitude().roll()) < 0.2, "it is level");
      mustThrow(NoDataException.class, unit::velocity, "of what is not sent there are no data");
      mustThrow(NoDataException.class, unit::quaternion, "of what is not sent there are no data");
      mustBe(Math.abs(receiver.fix().latitude() - 50.7747) < 0.001 && receiver.fix().quality() > 0, "it is in Aachen");
      mustBe(lidar.points().get(0).color().alpha() == 255, "points are opaque");
      base.setOdometry(new Pose3d(5, 6, 0, 0, 0, 0));
      readUntil(client, () -> Math.abs(base.state().pose().x() - 5) <= 1);
      mustThrow(InvalidValueException.class, () -> base.drive(Double.POSITIVE_INFINITY),
          "a number that is not finite is an error");
      base.drive(0.2);
      readUntil(client, () -> base.state().velocity().x() >= 0.1);
      unit.send(ImuMessages.DATA_FULLSTATE);
      readUntil(client, () -> unit.latest(ImuMessages.DATA_FULLSTATE).isPresent());
      mustBe(Double.isFinite(unit.velocity().x()), "the whole state has a velocity");
      unit.resetOrientation(false);
      base.close();
    }
  }

  private static void useDriversOnAMap(String address) {
    try (Client client = Client.connect(address); Simulation simulation = client.simulation(0)) {
      Pose start = simulation.pose("r0");
      Pose goal = new Pose(6, 4, 1.5);
      checkMap(client.map(0), start);
      Localize place = client.robot("r0").localize();
      Planner planner = client.robot("r0").planner();
      place.setPose(start, Covariance.ofDeviations(0.2, 0.2, 0.1));
      planner.goTo(goal);
      readUntil(client, () -> planner.hasData() && planner.state().pose().x() >= start.x() + 0.5);
      planner.stop();
      Path path = planner.path();
      mustBe(distance(path.waypoints().get(path.waypoints().size() - 1), goal) == 0
          && path.length() > distance(start, goal), "a path leads to the goal");
      mustBe(planner.state().valid() && !planner.hasArrived(), "it is on its way");
      mustBe(distance(place.pose(), simulation.pose("r0")) < 0.3, "it knows where it is");
      mustBe(place.particles().size() >= 100, "there are particles");
      mustRefuse(() -> place.setPose(start, new Covariance(-1, 0, 0, 0, 0, 0)), "an invalid covariance");
      planner.resume();
      readUntil(client, planner::hasArrived);
      mustBe(distance(simulation.pose("r0"), goal) < 0.6, "it is at the goal");
      mustBe(planner.whyRefused().isEmpty(), "it was not refused");
      planner.goTo(new Pose(999, 0, 0));
      readUntil(client, () -> !planner.whyRefused().isEmpty());
      mustBe(planner.whyRefused().equals("no path to (999, 0): the goal is off the map"), "it says why");
    }
  }

  private static void checkMap(GridMap plan, Pose start) {
    Grid grid = plan.grid();
    byte[][] cells = plan.cells();
    mustBe(Math.abs(grid.cellSize() - 0.1) < 1e-6, "cells have sides of 0.1 m");
    mustBe(cells.length == grid.height() && Arrays.stream(cells).allMatch(row -> row.length == grid.width()),
        "the map is whole");
    Optional<Cell> cell = grid.cellOf(start.x(), start.y());
    mustBe(cell.map(at -> cells[at.row()][at.column()] == -1).orElse(false), "a robot stands where nothing else is");
    Optional<Cell> rock = grid.cellOf(-7.9, -7.9);
    mustBe(rock.map(at -> cells[at.row()][at.column()] == 1).orElse(false), "there is rock around the cave");
  }

  private static double distance(Pose a, Pose b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  private static void readUntil(Client client, BooleanSupplier condition) {
    while (!condition.getAsBoolean()) {
      client.read();
    }
  }

  private static void mustBe(boolean fact, String what) {
    if (!fact) {
      throw new AssertionError("it is not true that " + what);
    }
  }

  private static void mustRefuse(Runnable action, String what) {
    mustThrow(RequestRefusedException.class, action, "the server refuses " + what);
  }

  private static void mustThrow(Class<? extends PlayerException> error, Runnable action, String what) {
    try {
      action.run();
    } catch (PlayerException thrown) {
      mustBe(error.isInstance(thrown), what);
      return;
    }
    mustBe(false, what);
  }

  private Robots() {}

  private static void useToken(String address) {
    try (Client client = Client.connect(address, Options.DEFAULT.withToken("no-such-token"))) {
      mustBe(false, "a wrong token is refused");
    } catch (RequestRefusedException error) {
      mustBe(error.getMessage().contains("the token is refused"), "a refused token is named");
    }
    try (Client client = Client.connect(address, Options.DEFAULT.withToken("driver-token-1"));
        Position2d robot = client.position2d(0)) {
      robot.drive(0.3);
      readUntil(client, () -> robot.hasData() && robot.velocity().x() > 0.2);
    }
  }
}
