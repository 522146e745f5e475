package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Kind;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Position2dMessages;
import playhouse.client.wire.SimulationMessages;
import playhouse.client.wire.Text;

/** Requests: answers, refusals, time-outs, interruptions, and what is never sent. */
public final class AskingTest {
  private static final Position2dMessages.Geom GEOM = new Position2dMessages.Geom();
  private static final CommonMessages.IntpropReq QUESTION = new CommonMessages.IntpropReq(Text.field("x"), 0);

  @Test
  public void aRefusalIsAnErrorAndTheConnectionStays() {
    ArrayDeque<Kind> answers = new ArrayDeque<>(List.of(Kind.NACK, Kind.ACK));
    try (FakeServer server = FakeServer.serving(
        (peer, message) -> peer.answer(message, answers.remove(), GEOM.encode(), message.header().sequence()));
        Client client = Client.connect(server.address()); Position2d robot = client.position2d(0)) {
      RequestRefusedException error =
          Expect.error(RequestRefusedException.class, "position2d.req.get_geom", robot::geometry);
      assertEquals(GEOM, Position2dMessages.Geom.decode(error.body()));
      robot.geometry();
    }
  }

  @Test
  public void aLateAnswerIsNotTakenForAnothers() {
    for (boolean numbers : new boolean[] {true, false}) {  // a server that returns the numbers of requests, and another
      List<Message> held = new ArrayList<>();
      try (FakeServer server = FakeServer.serving((peer, message) -> {
        held.add(message);
        for (int i = 0; held.size() == 2 && i < 2; ++i) {
          Message request = held.get(i);
          byte[] body = new CommonMessages.IntpropReq(Text.field("x"), i + 1).encode();
          peer.answer(request, Kind.ACK, body, numbers ? request.header().sequence() : 0);
        }
      }); Client client = Client.connect(server.address()); Device device = client.device("dio", 0)) {
        Expect.error(RequestTimeoutException.class, "no answer to universal.req.get_intprop of dio:0 in 0.02 s$",
            () -> device.request(CommonMessages.REQ_GET_INTPROP, QUESTION, Expect.millis(20)));
        assertEquals(2, device.getInt("x"));
        assertEquals(1, client.skippedCount());
      }
    }
  }

  @Test
  public void anAnswerThatDoesNotDecodeNamesTheFault() {
    try (FakeServer server = FakeServer.serving((peer, message) -> peer.answer(message, new byte[4]));
        Client client = Client.connect(server.address()); Position2d robot = client.position2d(0)) {
      Expect.error(WireException.class, "^position2d.Geom: byte 0: 8 bytes expected, 4 are left$", robot::geometry);
    }
  }

  @Test
  public void aServerThatGoesIsNoticed() {
    try (FakeServer server = FakeServer.serving((peer, message) -> peer.leave());
        Client client = Client.connect(server.address()); Position2d robot = client.position2d(0)) {
      assertThrows(ConnectionLostException.class, robot::geometry);
      assertFalse(client.isConnected());
      assertThrows(ConnectionLostException.class, () -> robot.drive(1));
    }
  }

  @Test
  public void errorsNameTheDeviceAndWhatWasAskedOfIt() {
    try (FakeServer server = FakeServer.serving(Peer::refuse);
        Client client = Client.connect(server.address(), Expect.PUSH)) {
      String peer = "^" + server.address() + ": ";
      Expect.error(RequestRefusedException.class, peer + "position2d.req.get_geom of position2d:3 was refused$",
          () -> client.position2d(3).geometry());
      Device lights = client.device("dio", 0);
      Expect.error(
          RequestRefusedException.class, peer + "dio:0 has no int property \"lamp\"$", () -> lights.getInt("lamp"));
      Expect.error(RequestRefusedException.class, "has no bool property", () -> lights.getBoolean("lamp"));
      Expect.error(RequestRefusedException.class, "has no double property", () -> lights.getDouble("lamp"));
      Expect.error(RequestRefusedException.class, "has no string property", () -> lights.getString("lamp"));
      Expect.error(
          RequestRefusedException.class, peer + "dio:0 refuses 7 as \"lamp\"$", () -> lights.setInt("lamp", 7));
      Expect.error(RequestRefusedException.class, "refuses true as", () -> lights.setBoolean("lamp", true));
      Expect.error(RequestRefusedException.class, "refuses 0.5 as", () -> lights.setDouble("lamp", 0.5));
      Expect.error(RequestRefusedException.class, "refuses 'on' as", () -> lights.setString("lamp", "on"));
      assertFalse(lights.hasCapability(CommonMessages.REQ_CAPABILITIES));
      Expect.error(RequestRefusedException.class, "simulation.req.get_pose2d of model \"nosuch\" was refused$",
          () -> client.simulation(0).pose("nosuch"));
      Expect.error(RequestRefusedException.class, "join was refused: the server does not do that$",
          () -> client.simulation(0).join("me"));
    }
  }

  @Test
  public void aSimulatorTellsWhyItRefuses() {
    ArrayDeque<String> reasons = new ArrayDeque<>(List.of("no room", "the run has ended"));
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      byte[] body = new SimulationMessages.PropertyReq(
          Text.field(""), Text.field(""), 0, Text.field(reasons.remove())).encode();
      peer.answer(message, Kind.NACK, body, message.header().sequence());
    }); Client client = Client.connect(server.address(), Expect.PUSH); Simulation simulator = client.simulation(0)) {
      Expect.error(RequestRefusedException.class, ": spawn was refused: no room$",
          () -> simulator.spawn("r0", new Pose(1, 2, 0.5), "r1"));
      Expect.error(RunEndedException.class, ": the run has ended$", () -> simulator.step(3));
      assertTrue(client.isConnected());
      List<SimulationMessages.PropertyReq> sent = server.peer().received().stream()
          .filter(each -> each.header().interfaceCode() == SimulationMessages.CODE)
          .map(each -> SimulationMessages.PropertyReq.decode(each.body())).toList();
      assertEquals("spawn r0", Text.of(sent.get(0).prop()) + " " + Text.of(sent.get(0).name()));
      assertEquals("a pose and a name", 3 * 8 + 3, sent.get(0).value().length);
      assertEquals("1 in little-endian order", 0x3F, sent.get(0).value()[7]);
      assertEquals("step", Text.of(sent.get(1).prop()));
      assertEquals(List.of(3, 4), List.of((int) sent.get(1).value()[0], sent.get(1).value().length));
    }
  }

  @Test
  public void valuesThatMeanNothingAreNotSent() {
    double nan = Double.NaN;
    double inf = Double.POSITIVE_INFINITY;
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      throw new AssertionError("this was sent: " + message);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      Simulation simulator = client.simulation(0);
      Fiducial finder = client.fiducial(0);
      List<ThrowingRunnable> acts = List.of(() -> robot.drive(nan), () -> robot.drive(0, inf),
          () -> robot.drive(0, 0, -inf), () -> robot.driveCar(0.1, nan), () -> robot.goTo(new Pose(nan, 0, 0)),
          () -> robot.goTo(new Pose(), inf), () -> robot.setOdometry(new Pose(0, 0, nan)),
          () -> simulator.setPose("r0", new Pose(0, nan, 0)),
          () -> simulator.setPose3d("r0", new Pose3d(0, 0, 0, 0, 0, nan)),
          () -> simulator.spawn("r0", new Pose(inf, 0, 0)), () -> finder.setFieldOfView(0, inf, 1));
      for (ThrowingRunnable act : acts) {
        Expect.error(InvalidValueException.class, "is (-?inf|nan), not a finite number$", act);
      }
      Expect.error(InvalidValueException.class, "^position2d:0: vx is nan", () -> robot.drive(nan));
      for (int ticks : new int[] {0, -1, (1 << 20) + 1}) {
        String fault = "^simulation:0: ticks is " + ticks + ", not a whole number from 1 to 1048576$";
        Expect.error(InvalidValueException.class, fault, () -> simulator.step(ticks));
      }
      for (int index : new int[] {-1, 65536}) {
        Expect.error(InvalidValueException.class, "^there is no position2d:" + index + ": indices are 0 to 65535$",
            () -> client.position2d(index));
      }
      Expect.error(InvalidValueException.class, "^invalid time-out of -1.5 s: 0 or more is valid$",
          () -> client.read(Duration.ofMillis(-1500)));
      Expect.error(WireException.class, "has a NUL in it", () -> simulator.pose("r0\0"));
    }
  }

  @Test
  public void aClosedDeviceSaysSo() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      throw new AssertionError("this was sent: " + message);
    })) {
      Client client = Client.connect(server.address());
      Position2d robot = client.position2d(0);
      Position2d other = client.position2d(1);
      robot.close();
      client.close();
      for (Position2d closed : List.of(robot, other)) {
        assertFalse(closed.isOpen());
        List<ThrowingRunnable> acts = List.of(() -> closed.drive(0.1), closed::geometry, closed::nextData);
        for (ThrowingRunnable act : acts) {
          Expect.error(DeviceClosedException.class, closed.name() + " is closed$", act);
        }
        closed.close();
      }
      Expect.error(ConnectionLostException.class, "the connection is closed$", client::read);
      Expect.error(ConnectionLostException.class, "the connection is closed$", () -> client.position2d(0));
      client.close();
    }
  }

  @Test
  public void aDeviceThatIsNotThereCannotBeOpened() {
    FakeServer.Script refuse = peer -> {
      for (Message message = peer.receive(); message != null; message = peer.receive()) {
        if (message.header().subtype() == PlayerMessages.REQ_DEV.subtype()) {
          peer.refuse(message);
        } else {
          peer.answer(message);
        }
      }
    };
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), refuse);
        Client client = Client.connect(server.address())) {
      Expect.error(RequestRefusedException.class, "there is no position2d:3 to open$", () -> client.position2d(3));
      Expect.error(InvalidValueException.class, "^there is no interface \"lazer\" \\(did you mean \"laser\"\\?\\)$",
          () -> client.device("lazer", 0));
      Expect.error(InvalidValueException.class, "^there is no interface \"xyzzy\"$", () -> client.device("xyzzy", 0));
    }
  }

  @Test
  public void aDriverThatRefusesToStartIsAnError() {
    byte[] refusal = new PlayerMessages.DeviceReq(
        new CommonMessages.Devaddr(0, 0, 4, 0), PlayerMessages.ERROR_MODE, new byte[0]).encode();
    FakeServer.Script refuse = peer -> {
      for (Message message = peer.receive(); message != null; message = peer.receive()) {
        peer.answer(message, message.header().subtype() == PlayerMessages.REQ_DEV.subtype() ? refusal : new byte[0]);
      }
    };
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), refuse);
        Client client = Client.connect(server.address())) {
      Expect.error(RequestRefusedException.class, "cannot open position2d:0$", () -> client.position2d(0));
    }
  }

  @Test
  public void anInterruptedWaitLeavesTheConnectionUsable() throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (asked.getCount() > 0) {
        asked.countDown();  // and no answer
      } else if (message.header().is(Kind.REQ)) {
        peer.answer(message, GEOM);
      }
    }); Client client = Client.connect(server.address(), Options.DEFAULT.withTimeout(Options.FOREVER))) {
      Position2d robot = client.position2d(0);
      AtomicReference<String> seen = new AtomicReference<>();
      Thread waiting = new Thread(() -> {
        PlayerException error = assertThrows(PlayerException.class, robot::geometry);
        seen.set(error.getClass().getSimpleName() + (Thread.interrupted() ? ", the status is not cleared" : ""));
      });
      waiting.start();
      asked.await();
      waiting.interrupt();
      waiting.join();
      assertEquals("WaitInterruptedException", seen.get());
      robot.geometry();
      Thread.currentThread().interrupt();
      robot.drive(0.5);  // sending does not wait
      assertTrue(Thread.interrupted());
      robot.geometry();
    }
  }

  @Test
  public void aClientThatIsClosedByAnInterruptedThreadLeavesItInterrupted() {
    FakeServer.Script silent = peer -> {
      Message opening = peer.receive();
      peer.answer(opening, opening.body());
      while (peer.receive() != null) {
        // the request to close the device, which gets no answer
      }
    };
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), silent)) {
      Client client = Client.connect(server.address(), Expect.PUSH.withTimeout(Options.FOREVER));
      client.position2d(0);
      Thread.currentThread().interrupt();
      client.close();
      assertTrue(Thread.interrupted());
      assertFalse(client.isConnected());
    }
  }

  @Test
  public void aServerThatReadsNothingIsATimeOutOfSending() throws Exception {
    CountDownLatch done = new CountDownLatch(1);
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), peer -> {
      peer.answer(peer.receive(), new PlayerMessages.DeviceReq());
      try {
        done.await();
      } catch (InterruptedException error) {
        peer.leave();
      }
    }); Client client = Client.connect(server.address(), Expect.PUSH.withTimeout(Expect.millis(2000)))) {
      Opaque radio = client.opaque(0);
      byte[] much = new byte[1 << 20];
      Expect.error(ConnectionLostException.class, "the server is gone: timed out$", () -> {
        while (true) {
          radio.send(much);
        }
      });
      assertFalse(client.isConnected());
      Expect.error(ConnectionLostException.class, "the server is gone: timed out$", client::read);
      done.countDown();
    }
  }
}
