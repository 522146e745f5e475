package playhouse.client;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.Kind;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.RangerMessages;

/** A server whose bodies have no sense: every use of its devices gives a value or an error of this library. */
public final class HostileTest {
  private static final List<Integer> CODES =
      Catalogue.interfaceNames().stream().sorted().map(name -> Catalogue.interfaceCode(name).orElseThrow()).toList();

  private int values;
  private int errors;

  @Test
  public void bodiesWithoutSenseAreValuesOrErrorsOfThisLibrary() throws Throwable {
    for (int seed = 0; seed < 100; ++seed) {
      Random random = new Random(seed);
      Mode mode = Mode.values()[seed % 2];
      try (FakeServer server = FakeServer.serving((peer, message) -> answer(peer, message, random));
          Client client = Client.connect(server.address(), new Options(mode, Options.FOREVER))) {
        useAll(client);
      }
    }
    assertTrue(values + " values, " + errors + " errors", values > 1000 && errors > 1000);
  }

  private static void answer(Peer peer, Message message, Random random) throws IOException {
    if (!message.header().is(Kind.REQ)) {
      return;
    }
    for (int count = random.nextInt(30); count > 0; --count) {
      int code = CODES.get(random.nextInt(CODES.size()));
      peer.say(code, 0, Kind.DATA.code(), 1 + random.nextInt(5), words(random));
    }
    boolean opensRanger = message.header().interfaceCode() == RangerMessages.CODE;  // which insists on what it requests
    Kind kind = opensRanger || random.nextInt(5) == 0 ? Kind.NACK : Kind.ACK;
    peer.answer(message, kind, words(random), message.header().sequence());
    if (message.header().subtype() == PlayerMessages.REQ_DATA.subtype()) {
      peer.say(PlayerMessages.CODE, 0, Kind.SYNCH.code(), 1 + random.nextInt(2), words(random));
    }
  }

  private void useAll(Client client) throws Throwable {
    Position2d base = client.position2d(0);
    Position3d flyer = client.position3d(0);
    Laser laser = client.laser(0);
    Ranger ranger = client.ranger(0);
    Sonar sonar = client.sonar(0);
    Fiducial finder = client.fiducial(0);
    Bumper bumper = client.bumper(0);
    Aio aio = client.aio(0);
    Camera camera = client.camera(0);
    Ptz mount = client.ptz(0);
    Opaque radio = client.opaque(0);
    Imu imu = client.imu(0);
    Gps gps = client.gps(0);
    PointCloud3d cloud = client.pointCloud3d(0);
    SpeechRecognition ears = client.speechRecognition(0);
    Localize place = client.localize(0);
    Planner planner = client.planner(0);
    GridMap map = client.map(0);
    Simulation simulation = client.simulation(0);
    List<ThrowingRunnable> uses = List.of(base::geometry, base::state, flyer::geometry, flyer::state, laser::config,
        laser::geometry, laser::scan, () -> laser.scan().points(), ranger::scan, () -> ranger.scan().nearest(),
        sonar::poses, sonar::ranges, finder::fieldOfView, finder::geometry, finder::markers, bumper::faces,
        bumper::pressed, aio::voltages, camera::image, () -> camera.image().pixel(1, 1),
        () -> camera.image().modelId(0, 0), mount::geometry, mount::view, radio::takeMessages, imu::pose, imu::velocity,
        imu::inertia, imu::attitude, imu::quaternion, gps::fix, cloud::points, ears::takeTexts, place::hypotheses,
        place::pose, place::particles, planner::state, planner::hasArrived, planner::path, map::grid, map::cells,
        () -> map.grid().cellOf(1, 1), () -> simulation.pose("r0"), () -> simulation.pose3d("r0"),
        () -> simulation.step(1), client::devices, client::models, client::robots, client::lostCount,
        () -> base.getString("key"), () -> base.getBoolean("key"), () -> base.getDouble("key"));
    for (int round = 0; round < 3; ++round) {
      use(() -> client.read(client.mode() == Mode.PULL ? Options.FOREVER : Duration.ZERO));
      for (ThrowingRunnable each : uses) {
        use(each);
      }
    }
  }

  private void use(ThrowingRunnable action) throws Throwable {
    try {
      action.run();
      ++values;
    } catch (PlayerException error) {
      ++errors;
    }
  }

  private static byte[] words(Random random) {
    ByteBuffer out = ByteBuffer.allocate(4 * random.nextInt(40));
    while (out.hasRemaining()) {
      int choice = random.nextInt(5);
      out.putInt(choice < 4 ? choice : random.nextInt());
    }
    return out.array();
  }
}
