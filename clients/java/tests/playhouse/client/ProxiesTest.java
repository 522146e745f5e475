package playhouse.client;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.zip.DeflaterOutputStream;
import org.junit.Test;
import playhouse.client.wire.ActarrayMessages;
import playhouse.client.wire.AioMessages;
import playhouse.client.wire.BumperMessages;
import playhouse.client.wire.CameraMessages;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.FiducialMessages;
import playhouse.client.wire.GpsMessages;
import playhouse.client.wire.ImuMessages;
import playhouse.client.wire.Kind;
import playhouse.client.wire.LaserMessages;
import playhouse.client.wire.LocalizeMessages;
import playhouse.client.wire.MapMessages;
import playhouse.client.wire.OpaqueMessages;
import playhouse.client.wire.PlannerMessages;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Pointcloud3dMessages;
import playhouse.client.wire.Position3dMessages;
import playhouse.client.wire.PowerMessages;
import playhouse.client.wire.PtzMessages;
import playhouse.client.wire.RangerMessages;
import playhouse.client.wire.SonarMessages;
import playhouse.client.wire.SpeechMessages;
import playhouse.client.wire.SpeechRecognitionMessages;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;
import playhouse.client.wire.WifiMessages;

/** What the proxies make of the data of their interfaces, and what they send. */
public final class ProxiesTest {
  private static final CommonMessages.Pose2d ZERO = new CommonMessages.Pose2d();

  @Test
  public void aLaserSpreadsItsBeamsAndTellsTheTime() {
    LaserMessages.Data data = new LaserMessages.Data(-1, 1, 1, 8, new float[] {1, 2, 3}, new byte[] {7, 8, 9}, 0);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(LaserMessages.DATA_SCAN, data, 8.5);
      peer.synch();
    }); Client client = Client.connect(server.address()); Laser scanner = client.laser(0)) {
      Scan scan = scanner.updates().iterator().next();
      assertEquals(new Scan(new double[] {1, 2, 3}, new double[] {-1, 0, 1}, 8, 8.5), scan);
      assertArrayEquals(new byte[] {7, 8, 9}, scanner.intensities());
      assertEquals(1, scan.nearest(), 0);
      assertEquals(2, scan.nearest(-0.5, 0.5), 0);
      assertEquals(8, scan.nearest(2, 3), 0);
      assertEquals(new Point(2, 0), scan.points().get(1));
    }
  }

  @Test
  public void aRangerHasTheDirectionsOfItsElements() {
    CommonMessages.Pose3d left = new CommonMessages.Pose3d(0, 0, 0, 0, 0, 1.5);
    RangerMessages.Geom geom = new RangerMessages.Geom(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d(),
        List.of(left, new CommonMessages.Pose3d()), List.of());
    RangerMessages.Config config = new RangerMessages.Config(-1, 1, 0.5, 0, 5, 0.1, 10);
    ArrayDeque<double[]> told = new ArrayDeque<>(List.of(new double[] {1, 2}, new double[] {1, 2, 3}));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() == RangerMessages.CODE) {
        boolean asksConfig = message.header().subtype() == RangerMessages.REQ_GET_CONFIG.subtype();
        peer.answer(message, asksConfig ? config : geom);
        return;
      }
      peer.answer(message);
      peer.data(RangerMessages.DATA_RANGE, new RangerMessages.DataRange(told.remove()));
      peer.synch();
    }); Client client = Client.connect(server.address()); Ranger ranger = client.ranger(0)) {
      client.read();
      assertEquals(new Scan(new double[] {1, 2}, new double[] {1.5, 0}, 5, 1), ranger.scan());
      client.read();
      assertEquals(new Scan(new double[] {1, 2, 3}, new double[] {-1, 0, 1}, 5, 1), ranger.scan());
      assertEquals(geom, ranger.geom());
      assertEquals(config, ranger.config());
    }
  }

  @Test
  public void aCameraTellsItsPixels() {
    ArrayDeque<CameraMessages.Data> pictures = new ArrayDeque<>(List.of(
        picture(2, 1, CameraMessages.FORMAT_RGB888, CameraMessages.COMPRESS_RAW, 1, 2, 3, 4, 5, 6),
        picture(1, 2, CameraMessages.FORMAT_MONO16, CameraMessages.COMPRESS_RAW, 0x34, 0x12, 0, 0),
        picture(2, 1, CameraMessages.FORMAT_RGB888, CameraMessages.COMPRESS_JPEG, 0xFF, 0xD8),
        picture(2, 1, CameraMessages.FORMAT_RGB888, CameraMessages.COMPRESS_RAW, 1, 2, 3, 4, 5),
        picture(2, 1, CameraMessages.FORMAT_RGB888, CameraMessages.COMPRESS_RAW, 0, 0, 0, 0, 0, 1),
        picture(0xFFFFFFFFL, 0xFFFFFFFFL, CameraMessages.FORMAT_MONO8, CameraMessages.COMPRESS_RAW, 200)));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(CameraMessages.DATA_STATE, pictures.remove(), 2.5);
      peer.synch();
    }); Client client = Client.connect(server.address()); Camera eye = client.camera(0)) {
      Image colors = eye.updates().iterator().next();
      assertArrayEquals(new int[] {1, 2, 3}, colors.pixel(0, 0));
      assertArrayEquals(new int[] {4, 5, 6}, colors.pixel(1, 0));
      assertEquals(2.5, colors.time(), 0);
      assertEquals(OptionalLong.of(0x040505), colors.modelId(1, 0));
      Expect.error(InvalidValueException.class, "2, 0 is outside the 2 x 1 picture", () -> colors.pixel(2, 0));
      client.read();
      assertArrayEquals(new int[] {0x1234}, eye.image().pixel(0, 0));
      assertArrayEquals(new int[] {0}, eye.image().pixel(0, 1));
      Expect.error(InvalidValueException.class, "RGB888 alone", () -> eye.image().modelId(0, 0));
      client.read();
      assertTrue(eye.image().isJpeg());
      Expect.error(InvalidValueException.class, "raw MONO8, MONO16 and RGB888 alone", () -> eye.image().pixel(0, 0));
      client.read();
      assertArrayEquals(new int[] {1, 2, 3}, eye.image().pixel(0, 0));
      Expect.error(InvalidValueException.class, "fewer bytes than pixels: 5", () -> eye.image().pixel(1, 0));
      client.read();
      assertEquals("no model", OptionalLong.empty(), eye.image().modelId(0, 0));
      assertEquals("the first model", OptionalLong.of(0), eye.image().modelId(1, 0));
      client.read();
      assertArrayEquals(new int[] {200}, eye.image().pixel(0, 0));
      Expect.error(
          InvalidValueException.class, "fewer bytes than pixels: 1", () -> eye.image().pixel(1 << 30, 1 << 30));
    }
  }

  @Test
  public void aMountLooksAndTurns() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().is(Kind.REQ)) {
        peer.answer(message);
        peer.data(PtzMessages.DATA_STATE, new PtzMessages.Data(0.5f, 0.25f, 1, 0, 0, 0));
        peer.synch();
      }
    }); Client client = Client.connect(server.address()); Ptz mount = client.ptz(0)) {
      assertEquals(new View(0.5, 0.25, 1, 0, 0), mount.updates().iterator().next());
      mount.look(0.5, 0.25);
      mount.turn(-0.5, 0);
      mount.setVelocityControl(true);
      Expect.error(InvalidValueException.class, "ptz:0: tilt is nan", () -> mount.look(0, Double.NaN));
      Expect.error(WireException.class, "float too large to pack", () -> mount.look(1e300, 0));
      mount.close();
      List<Message> sent = server.peer().received().stream().filter(each -> each.header().is(Kind.CMD)).toList();
      assertEquals(new PtzMessages.Cmd(0.5f, 0.25f, 0, 0, 0), PtzMessages.Cmd.decode(sent.get(0).body()));
      assertEquals(new PtzMessages.Cmd(0, 0, 0, -0.5f, 0), PtzMessages.Cmd.decode(sent.get(1).body()));
    }
  }

  @Test
  public void aBumperTellsWhichSwitchesArePressedAndWhereTheyAre() {
    BumperMessages.Define front =
        new BumperMessages.Define(new CommonMessages.Pose3d(0.25, 0, 0.1, 0, 0, 0.5), 0.5f, 0);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message, new BumperMessages.Geom(List.of(front)));
      peer.data(BumperMessages.DATA_STATE, new BumperMessages.Data(new byte[] {0, 1, -1}));
      peer.synch();
    }); Client client = Client.connect(server.address()); Bumper skirt = client.bumper(0)) {
      assertEquals(List.of(false, true, true), skirt.updates().iterator().next());
      assertEquals(List.of(new Face(new Pose3d(0.25, 0, 0.1, 0, 0, 0.5), 0.5, 0)), skirt.faces());
    }
  }

  @Test
  public void sonarsAndMarkersHavePlaces() {
    FiducialMessages.Item item = new FiducialMessages.Item(
        7, new CommonMessages.Pose3d(3, 4, 0, 0, 0, 0), new CommonMessages.Pose3d());
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() == SonarMessages.CODE) {
        peer.answer(message, new SonarMessages.Geom(List.of(new CommonMessages.Pose3d(0.5, 0, 0, 0, 0, 1))));
        return;
      }
      peer.answer(message);
      peer.data(SonarMessages.DATA_RANGES, new SonarMessages.Data(new float[] {2.5f}));
      peer.data(FiducialMessages.DATA_SCAN, new FiducialMessages.Data(List.of(item)));
      peer.synch();
    }); Client client = Client.connect(server.address()); Sonar ring = client.sonar(0);
        Fiducial finder = client.fiducial(0)) {
      Marker marker = finder.updates().iterator().next().get(0);
      assertEquals(7, marker.id());
      assertEquals(5, marker.distance(), 0);
      assertEquals(Math.atan2(4, 3), marker.bearing(), 0);
      assertArrayEquals(new double[] {2.5}, ring.ranges(), 0);
      assertEquals(List.of(new Pose3d(0.5, 0, 0, 0, 0, 1)), ring.poses());
    }
  }

  @Test
  public void anInertialUnitTellsWhatItFeelsAndHowItStands() {
    ImuMessages.DataCalib felt = new ImuMessages.DataCalib(0.5f, 0.25f, 9.75f, 0, 0, 1.5f, 0, 0.5f, -0.5f);
    CommonMessages.Pose3d at = new CommonMessages.Pose3d(1, 2, 3, 0, 0, 0.5);
    CommonMessages.Pose3d fast = new CommonMessages.Pose3d(0.25, 0, 0, 0, 0, 0);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(ImuMessages.DATA_STATE, new ImuMessages.DataState(), 1);
      peer.data(ImuMessages.DATA_EULER,
          new ImuMessages.DataEuler(felt, new CommonMessages.Orientation3d(0.5, 0.25, 0.125)), 2);
      peer.data(ImuMessages.DATA_QUAT, new ImuMessages.DataQuat(felt, 1, 0, 0, 0), 3);
      peer.data(ImuMessages.DATA_FULLSTATE, new ImuMessages.DataFullstate(at, fast, new CommonMessages.Pose3d()), 4);
      peer.synch();
    }); Client client = Client.connect(server.address()); Imu unit = client.imu(0)) {
      Expect.error(NoDataException.class, "imu:0 has sent no data yet", unit::inertia);
      unit.send(ImuMessages.DATA_EULER);
      unit.nextData();
      assertEquals(new Inertia(new Vector3(0.5, 0.25, 9.75), new Vector3(0, 0, 1.5), new Vector3(0, 0.5, -0.5)),
          unit.inertia());
      assertEquals(new Attitude(0.5, 0.25, 0.125), unit.attitude());
      assertEquals(new Quaternion(1, 0, 0, 0), unit.quaternion());
      assertEquals("the newer of two kinds of data", new Pose3d(1, 2, 3, 0, 0, 0.5), unit.pose());
      assertEquals(0.25, unit.velocity().x(), 0);
      unit.resetOrientation(false);
      Expect.error(InvalidValueException.class, "yaw is nan", () -> unit.resetAttitude(new Attitude(0, 0, Double.NaN)));
      List<byte[]> sent = requestsTo(server, ImuMessages.CODE);
      assertArrayEquals("euler", new byte[] {0, 0, 0, 4}, sent.get(0));
      assertArrayEquals("the heading", new byte[4], sent.get(1));
      assertEquals(2, sent.size());
    }
  }

  @Test
  public void dataOfAnotherKindAreNamed() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(ImuMessages.DATA_STATE, new ImuMessages.DataState());
      peer.synch();
    }); Client client = Client.connect(server.address()); Imu unit = client.imu(0)) {
      unit.nextData();
      Expect.error(NoDataException.class, "imu:0 sends imu[.]data[.]state, not imu[.]data[.]calib;"
          + " send[(]ImuMessages[.]DATA_CALIB[)] selects it$", unit::inertia);
    }
  }

  @Test
  public void aReceiverTellsDegreesAndMetresAndACloudPoints() {
    GpsMessages.Data fixed = new GpsMessages.Data(
        1, 0, 507747000, -60839000, 220500, 0.5, 1.5, 294000, 5628000, 1, 8, 10, 15, 2, 3);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(GpsMessages.DATA_STATE, fixed);
      peer.data(Pointcloud3dMessages.DATA_STATE, new Pointcloud3dMessages.Data(List.of(new Pointcloud3dMessages.Element(
          new CommonMessages.Point3d(1, 2, 3), new CommonMessages.Color(255, 200, 0, 0)))));
      peer.answer(message);
      peer.synch();
    }); Client client = Client.connect(server.address()); Gps receiver = client.gps(0);
        PointCloud3d cloud = client.pointCloud3d(0)) {
      Fix fix = receiver.updates().iterator().next();
      assertEquals(50.7747, fix.latitude(), 1e-9);
      assertEquals(-6.0839, fix.longitude(), 1e-9);
      assertEquals(220.5, fix.altitude(), 1e-9);
      assertEquals(List.of(1L, 8L), List.of(fix.quality(), fix.satellites()));
      assertEquals(2, fix.horizontalError(), 0);
      assertEquals(List.of(new CloudPoint(1, 2, 3, new Color(200, 0, 0, 255))), cloud.points());
    }
  }

  @Test
  public void aBaseInSpaceIsStoppedAsItIsClosed() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().is(Kind.REQ)) {
        peer.answer(message);
        peer.data(Position3dMessages.DATA_STATE, new Position3dMessages.Data(
            new CommonMessages.Pose3d(1, 2, 3, 0.5, 0.25, 0.125), new CommonMessages.Pose3d(), 1));
        peer.synch();
      }
    }); Client client = Client.connect(server.address()); Position3d base = client.position3d(0)) {
      State3d state = base.updates().iterator().next();
      assertEquals(new Pose3d(1, 2, 3, 0.5, 0.25, 0.125), state.pose());
      assertTrue(state.stalled());
      Expect.error(InvalidValueException.class, "position3d:0: vz is inf, not a finite number",
          () -> base.drive(0.1, 0, 0, Double.POSITIVE_INFINITY));
      base.drive(0.5, 0.25);
      base.close();
      List<CommonMessages.Pose3d> sent = server.peer().received().stream().filter(each -> each.header().is(Kind.CMD))
          .map(each -> Position3dMessages.CmdVel.decode(each.body()).vel()).toList();
      assertEquals(List.of(new CommonMessages.Pose3d(0.5, 0, 0, 0, 0, 0.25), new CommonMessages.Pose3d()), sent);
    }
  }

  @Test
  public void analogInputsAreVoltagesAndOutputsAreSetOneByOne() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().is(Kind.REQ)) {
        peer.answer(message);
        peer.data(AioMessages.DATA_STATE, new AioMessages.Data(new float[] {0.5f, -3}));
        peer.synch();
      }
    }); Client client = Client.connect(server.address()); Aio box = client.aio(0)) {
      assertArrayEquals(new double[] {0.5, -3}, box.updates().iterator().next(), 0);
      box.set(1, 2.5);
      Expect.error(InvalidValueException.class, "voltage is nan, not a finite number", () -> box.set(1, Double.NaN));
      box.close();
      List<Message> sent = server.peer().received().stream().filter(each -> each.header().is(Kind.CMD)).toList();
      assertEquals(List.of(new AioMessages.Cmd(1, 2.5f)),
          sent.stream().map(each -> AioMessages.Cmd.decode(each.body())).toList());
    }
  }

  @Test
  public void messagesAndTextsAreKeptUntilTheyAreTaken() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().is(Kind.CMD)) {
        return;
      }
      peer.answer(message);
      if (message.header().interfaceCode() != PlayerMessages.CODE) {
        return;
      }
      for (String text : List.of("one", "two", "three")) {
        peer.data(OpaqueMessages.DATA_STATE, new OpaqueMessages.Data(text.getBytes(StandardCharsets.UTF_8)));
        peer.data(SpeechRecognitionMessages.DATA_STRING, new SpeechRecognitionMessages.Data(Text.field(text)));
      }
      peer.synch();
    }); Client client = Client.connect(server.address()); Opaque radio = client.opaque(0);
        SpeechRecognition ears = client.speechRecognition(0); Speech voice = client.speech(0)) {
      assertArrayEquals(new byte[] {'o', 'n', 'e'}, radio.updates().iterator().next());
      assertEquals(2, radio.takeMessages().size());
      assertTrue(radio.takeMessages().isEmpty());
      assertEquals(List.of("one", "two", "three"), ears.takeTexts());
      voice.say("sch\u00f6n");
      radio.sendTo("10.0.0.1", new byte[] {5});
      byte[] sent = OpaqueMessages.Data.decode(requestsTo(server, OpaqueMessages.CODE).get(0)).data();
      assertArrayEquals("10.0.0.1\0\5".getBytes(StandardCharsets.UTF_8), sent);
      Message said = server.peer().received().stream()
          .filter(each -> each.header().interfaceCode() == SpeechMessages.CODE).findFirst().orElseThrow();
      assertEquals("sch\u00f6n", Text.of(SpeechMessages.Cmd.decode(said.body()).string()));
    }
  }

  @Test
  public void aLocalizationTellsWhereTheRobotMayBeAndIsTold() {
    double[] spread = {0.25, 0.5, 0.125, 0.5, 0.25, 0.75};
    List<LocalizeMessages.Hypoth> two = List.of(
        new LocalizeMessages.Hypoth(new CommonMessages.Pose2d(1, 2, 0.5), spread, 0.75),
        new LocalizeMessages.Hypoth(ZERO, new double[6], 0.25));
    ArrayDeque<List<LocalizeMessages.Hypoth>> told = new ArrayDeque<>(List.of(two, List.of()));
    LocalizeMessages.Particle few = new LocalizeMessages.Particle(new CommonMessages.Pose2d(3, 4, 1), 0.5);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() != LocalizeMessages.CODE) {
        peer.answer(message);
        peer.data(LocalizeMessages.DATA_HYPOTHS, new LocalizeMessages.Data(0, 1, told.remove()));
        peer.synch();
      } else if (message.header().subtype() == LocalizeMessages.REQ_GET_PARTICLES.subtype()) {
        peer.answer(message, new LocalizeMessages.GetParticles(ZERO, 0, List.of(few)));
      } else if (LocalizeMessages.SetPose.decode(message.body()).cov()[0] < 0) {
        peer.refuse(message);
      } else {
        peer.answer(message);
      }
    }); Client client = Client.connect(server.address()); Localize place = client.localize(0)) {
      Expect.error(NoDataException.class, "localize:0 has sent no data yet", place::pose);
      Hypothesis first = new Hypothesis(new Pose(1, 2, 0.5), new Covariance(0.25, 0.5, 0.125, 0.5, 0.25, 0.75), 0.75);
      Hypothesis second = new Hypothesis(new Pose(), new Covariance(), 0.25);
      assertEquals(List.of(first, second), place.updates().iterator().next());
      assertEquals(new Pose(1, 2, 0.5), place.pose());
      client.read();
      Expect.error(NoDataException.class, "localize:0 has no hypothesis", place::pose);
      place.setPose(new Pose(1, 2, 0.5), Covariance.ofDeviations(0.5, 2, 3));
      Expect.error(RequestRefusedException.class, "localize.req.set_pose of localize:0 was refused",
          () -> place.setPose(new Pose(), new Covariance(-1, 0, 0, 0, 0, 0)));
      Expect.error(InvalidValueException.class, "localize:0: y is nan, not a finite number",
          () -> place.setPose(new Pose(0, Double.NaN, 0), new Covariance()));
      Expect.error(InvalidValueException.class, "localize:0: xa is inf, not a finite number",
          () -> place.setPose(new Pose(), new Covariance(0, 0, 0, 0, 0, Double.POSITIVE_INFINITY)));
      assertEquals(List.of(new Particle(new Pose(3, 4, 1), 0.5)), place.particles());
      List<byte[]> sent = requestsTo(server, LocalizeMessages.CODE);
      double[] variances = {0.25, 4, 9, 0, 0, 0};
      assertEquals(new LocalizeMessages.SetPose(new CommonMessages.Pose2d(1, 2, 0.5), variances),
          LocalizeMessages.SetPose.decode(sent.get(0)));
      assertEquals(3, sent.size());
    }
  }

  @Test
  public void aPlannerGoesToAGoalAndTellsWhenTheRobotIsThere() {
    CommonMessages.Pose2d goal = new CommonMessages.Pose2d(6, 4, 1.5);
    CommonMessages.Pose2d way = new CommonMessages.Pose2d(2, 1, 0);
    ArrayDeque<PlannerMessages.Data> told = new ArrayDeque<>(List.of(
        new PlannerMessages.Data(1, 1, ZERO, ZERO, ZERO, -1, 2),  // of a goal before
        new PlannerMessages.Data(1, 0, new CommonMessages.Pose2d(0.5, 0, 0), goal, way, 1, 3),
        new PlannerMessages.Data(1, 1, goal, goal, ZERO, -1, 3)));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().is(Kind.CMD)) {
        return;
      }
      if (message.header().interfaceCode() == PlannerMessages.CODE) {
        boolean asksPath = message.header().subtype() == PlannerMessages.REQ_GET_WAYPOINTS.subtype();
        peer.answer(message,
            asksPath ? new PlannerMessages.WaypointsReq(7.5, List.of(way, goal)).encode() : new byte[0]);
        return;
      }
      peer.answer(message);
      peer.data(PlannerMessages.DATA_STATE, told.remove(), 2.5);
      peer.synch();
    }); Client client = Client.connect(server.address()); Planner guide = client.planner(0)) {
      Expect.error(NoDataException.class, "planner:0 has sent no data yet", guide::state);
      assertFalse(guide.hasArrived());
      guide.goTo(new Pose(6, 4, 1.5 + 4 * Math.PI));
      List<PlannerState> states = new ArrayList<>();
      for (PlannerState state : guide.updates()) {
        states.add(state);
        if (guide.hasArrived()) {
          break;
        }
      }
      assertEquals(3, states.size());
      assertEquals(new PlannerState(
          true, false, new Pose(0.5, 0, 0), new Pose(6, 4, 1.5), new Pose(2, 1, 0), 1, 3, 2.5), states.get(1));
      guide.stop();
      guide.resume();
      assertEquals(new Path(List.of(new Pose(2, 1, 0), new Pose(6, 4, 1.5)), 7.5), guide.path());
      guide.goTo(new Pose(6, 4, 0));
      assertFalse("another heading", guide.hasArrived());
      Expect.error(InvalidValueException.class, "planner:0: y is inf, not a finite number",
          () -> guide.goTo(new Pose(0, Double.POSITIVE_INFINITY, 0)));
      List<byte[]> sent = requestsTo(server, PlannerMessages.CODE);
      assertArrayEquals("stop", new byte[] {0, 0, 0, 0}, sent.get(0));
      assertArrayEquals("resume", new byte[] {0, 0, 0, 1}, sent.get(1));
    }
  }

  @Test
  public void aMapComesWholeInTiles() {
    int width = 600;
    int height = 514;
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().subtype() == MapMessages.REQ_GET_INFO.subtype()) {
        peer.answer(message, new MapMessages.Info(0.5f, width, height, new CommonMessages.Pose2d(-1, 2, 0)));
        return;
      }
      MapMessages.Data tile = MapMessages.Data.decode(message.body());
      byte[] values = new byte[(int) (tile.width() * tile.height())];
      for (int i = 0; i < values.length; ++i) {
        values[i] = mapValue((int) (tile.col() + i % tile.width()), (int) (tile.row() + i / tile.width()));
      }
      byte[] data = tile.row() == 0 ? compressed(values) : values;  // and others as a server without zlib
      peer.answer(message, new MapMessages.Data(tile.col(), tile.row(), tile.width(), tile.height(), 100, data));
    }); Client client = Client.connect(server.address(), Expect.PUSH); GridMap plan = client.map(0)) {
      assertEquals(new Grid(0.5, width, height, new Pose(-1, 2, 0)), plan.grid());
      byte[][] cells = plan.cells();
      assertEquals(height, cells.length);
      for (int row = 0; row < height; ++row) {
        byte[] wanted = new byte[width];
        for (int column = 0; column < width; ++column) {
          wanted[column] = (byte) (mapValue(column, row) > 50 ? 1 : mapValue(column, row) < -50 ? -1 : 0);
        }
        assertArrayEquals(wanted, cells[row]);
      }
      List<List<Long>> tiles = server.peer().received().stream()
          .filter(each -> each.header().interfaceCode() == MapMessages.CODE && each.header().subtype() == 2)
          .map(each -> MapMessages.Data.decode(each.body()))
          .map(each -> List.of(each.col(), each.row(), each.width(), each.height())).toList();
      assertEquals(List.of(List.of(0L, 0L, 512L, 512L), List.of(512L, 0L, 88L, 512L), List.of(0L, 512L, 512L, 2L),
          List.of(512L, 512L, 88L, 2L)), tiles);
    }
  }

  @Test
  public void mapsThatMakeNoSenseAreAnError() {
    CommonMessages.Pose2d endless = new CommonMessages.Pose2d(Double.POSITIVE_INFINITY, 0, 0);
    ArrayDeque<MapMessages.Info> infos = new ArrayDeque<>(List.of(
        new MapMessages.Info(0, 2, 2, ZERO), new MapMessages.Info(Float.NaN, 2, 2, ZERO),
        new MapMessages.Info(0.5f, 2, 2, endless), new MapMessages.Info(0.5f, 1 << 14, (1 << 12) + 1, ZERO),
        new MapMessages.Info(0.5f, 2, 2, ZERO), new MapMessages.Info(0.5f, 2, 2, ZERO),
        new MapMessages.Info(0.5f, 0, 1L << 31, ZERO)));
    ArrayDeque<byte[]> tiles = new ArrayDeque<>(List.of(compressed(new byte[3]), compressed(new byte[1 << 20])));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      boolean asksInfo = message.header().subtype() == MapMessages.REQ_GET_INFO.subtype();
      Struct answer = asksInfo ? infos.remove() : new MapMessages.Data(0, 0, 2, 2, 1, tiles.remove());
      peer.answer(message, answer);
    }); Client client = Client.connect(server.address(), Expect.PUSH); GridMap plan = client.map(0)) {
      String damaged = "a tile of 2 x 2 cells is damaged";
      for (String fault : List.of("cells of 0.0 m from", "cells of nan m from", "\\(inf, 0.0, 0.0\\) on",
          "16384 x 4097 cells are over the limit of 67108864", damaged, damaged)) {
        Expect.error(WireException.class, "^map:0: .*" + fault, plan::cells);
      }
      assertEquals(0, plan.cells().length);
    }
  }

  @Test
  public void aPointOfTheWorldIsInACellOrBeyondTheMap() {
    Grid grid = new Grid(0.5, 4, 2, new Pose(10, 20, Math.PI / 2));  // columns go along y, rows against x
    assertEquals(Optional.of(new Cell(0, 0)), grid.cellOf(9.9, 20.1));
    assertEquals(Optional.of(new Cell(3, 1)), grid.cellOf(9.4, 21.9));
    double[][] beyond = {{10.1, 20.1}, {9.9, 19.9}, {9.9, 22.1}, {8.9, 20.1}, {Double.NaN, 20.1},
        {9.9, Double.POSITIVE_INFINITY}};
    Arrays.stream(beyond).forEach(point -> assertEquals(Optional.empty(), grid.cellOf(point[0], point[1])));
  }

  @Test
  public void aChainOfJointsTellsItsStateAndIsMoved() {
    ActarrayMessages.Data data = new ActarrayMessages.Data(List.of(
        new ActarrayMessages.Actuator(0.5f, 0.25f, 2, -1, ActarrayMessages.ACTSTATE_MOVING),
        new ActarrayMessages.Actuator(1, 0, 0, 3, ActarrayMessages.ACTSTATE_BRAKED)), 1);
    ActarrayMessages.Geom geom = new ActarrayMessages.Geom(
        List.of(new ActarrayMessages.Actuatorgeom(ActarrayMessages.TYPE_ROTARY, 2, new CommonMessages.Orientation3d(),
            new CommonMessages.Point3d(0, 0, 1), -1, 0, 1, 0.5f, 4, 1)),
        new CommonMessages.Point3d(1, 2, 3), new CommonMessages.Orientation3d(0.5, 0.25, 0.125));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      boolean asksGeometry = message.header().interfaceCode() == ActarrayMessages.CODE && message.header().is(Kind.REQ);
      if (asksGeometry) {
        peer.answer(message, geom);
        return;
      }
      peer.answer(message);
      peer.data(ActarrayMessages.DATA_STATE, data, 2);
      peer.synch();
    }); Client client = Client.connect(server.address()); ActArray arm = client.actArray(0)) {
      ActArrayState state = arm.updates().iterator().next();
      assertEquals(new Joint(0.5, 0.25, 2, OptionalDouble.empty(), true, false, false), state.joints().get(0));
      assertEquals(new Joint(1, 0, 0, OptionalDouble.of(3), false, true, false), state.joints().get(1));
      assertTrue(state.motorsOn());
      ActArrayGeometry geometry = arm.geometry();
      assertEquals(new Pose3d(1, 2, 3, 0.5, 0.25, 0.125), geometry.pose());
      assertEquals(new JointGeometry(true, 2, new Attitude(0, 0, 0), new Vector3(0, 0, 1), -1, 0, 1, 0.5, 4, true),
          geometry.joints().get(0));
      Expect.error(InvalidValueException.class, "joint is -1, not a whole number from 0 to 2147483647$", () -> arm.moveTo(-1, 1));
      Expect.error(InvalidValueException.class, "position is nan, not a finite number$",
          () -> arm.moveAllTo(new double[] {0, Double.NaN}));
    }
  }

  @Test
  public void aBatteryTellsWhatItKnowsAndARadioItsLevelsInTheirUnit() {
    int valid = PowerMessages.MASK_VOLTS | PowerMessages.MASK_CHARGING;
    WifiMessages.Link link = new WifiMessages.Link(Text.field("a"), new byte[0], new byte[0], 0, 0, 1, 0, -40, -90);
    WifiMessages.Data radioData = new WifiMessages.Data(List.of(link), 0, 0, 0, WifiMessages.QUAL_REL, 0, -1, 0, new byte[32]);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(PowerMessages.DATA_STATE, new PowerMessages.Data(valid, 12.5f, 0, 0, 0, 7), 1);
      peer.data(WifiMessages.DATA_STATE, radioData, 1);
      peer.synch();
    }); Client client = Client.connect(server.address()); Power battery = client.power(0); Wifi radio = client.wifi(0)) {
      client.read();
      OptionalDouble unknown = OptionalDouble.empty();
      assertEquals(new PowerState(OptionalDouble.of(12.5), unknown, unknown, unknown, Optional.of(Charging.YES), 1), battery.state());
      assertEquals("a", radio.links().get(0).mac());
      assertEquals((1L << 32) - 40, radio.links().get(0).level());
    }
  }

  private static CameraMessages.Data picture(long width, long height, int format, int compression, int... bytes) {
    byte[] data = new byte[bytes.length];
    for (int i = 0; i < bytes.length; ++i) {
      data[i] = (byte) bytes[i];
    }
    return new CameraMessages.Data(width, height, 24, format, 1, compression, data);
  }

  private static byte mapValue(int column, int row) {
    return (byte) ((column + 3 * row) % 201 - 100);
  }

  private static byte[] compressed(byte[] data) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (OutputStream in = new DeflaterOutputStream(out)) {
      in.write(data);
    } catch (IOException error) {
      throw new AssertionError(error);
    }
    return out.toByteArray();
  }

  /** Bodies of the requests that the server has received for an interface. */
  private static List<byte[]> requestsTo(FakeServer server, int interfaceCode) {
    return server.peer().received().stream()
        .filter(each -> each.header().interfaceCode() == interfaceCode && each.header().is(Kind.REQ))
        .map(Message::body).toList();
  }
}
