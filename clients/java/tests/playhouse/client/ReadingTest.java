package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Header;
import playhouse.client.wire.Kind;
import playhouse.client.wire.LaserMessages;
import playhouse.client.wire.OpaqueMessages;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Position2dMessages;

/** Rounds of data, losses, time-outs, and data that make no sense. */
public final class ReadingTest {
  private static final Position2dMessages.Geom GEOM = new Position2dMessages.Geom();

  @Test
  public void aRoundEndsWithSynchAndBringsEverything() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2), 7.5);
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      assertFalse(robot.hasData());
      assertEquals(2, client.read());
      assertEquals(2, robot.pose().x(), 0);
      assertEquals(7.5, robot.timestamp(), 0);
      assertEquals(7.5, robot.state().time(), 0);
      assertTrue(robot.hasData() && robot.isFresh());
    }
  }

  @Test
  public void messagesInSingleBytesArriveWhole() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      byte[] body = Expect.state(3).encode();
      peer.sendInSingleBytes(Peer.encoded(new Header(4, 0, Kind.DATA.code(), 1, 1.0, 0, body.length, 0, 0), body));
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      assertEquals(1, client.read());
      assertEquals(3, robot.pose().x(), 0);
    }
  }

  @Test
  public void aMessageLongerThanTheBufferArrivesWhole() {
    float[] ranges = new float[200_000];
    ranges[ranges.length - 1] = 5;
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      for (int i = 0; i < 3; ++i) {
        peer.data(Position2dMessages.DATA_STATE, Expect.state(i));
        peer.data(LaserMessages.DATA_SCAN, new LaserMessages.Data(0, 1, 0, 8, ranges, new byte[0], i));
      }
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Laser scanner = client.laser(0);
      client.position2d(0);
      assertEquals(6, client.read());
      assertEquals(5, scanner.ranges()[ranges.length - 1], 0);
    }
  }

  @Test
  public void aRoundThatEndsWhileARequestWaitsIsTheNextRead() {
    AtomicInteger rounds = new AtomicInteger();
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() == PlayerMessages.CODE) {
        rounds.incrementAndGet();
        peer.answer(message);  // and nothing else
        return;
      }
      peer.data(Position2dMessages.DATA_STATE, Expect.state(4));
      peer.synch();
      peer.answer(message, GEOM);
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      assertThrows(RequestTimeoutException.class, () -> client.read(Expect.millis(20)));
      robot.geometry();
      assertEquals(1, client.read());
      assertEquals(1, rounds.get());
    }
  }

  @Test
  public void noDataInTimeIsAnErrorAndTheRoundGoesOn() {
    AtomicInteger rounds = new AtomicInteger();
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() == PlayerMessages.CODE) {
        rounds.incrementAndGet();
        peer.answer(message);  // and nothing else
        return;
      }
      peer.answer(message, GEOM);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(4));
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      Expect.error(RequestTimeoutException.class, "no data in time", () -> client.read(Expect.millis(20)));
      robot.geometry();
      assertEquals(1, client.read());
      assertEquals(4, robot.pose().x(), 0);
      assertEquals(1, rounds.get());
    }
  }

  @Test
  public void lostMessagesAreCountedAndNotAnError() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.synch(41);
    }); Client client = Client.connect(server.address())) {
      client.position2d(0);
      client.read();
      assertEquals(41, client.overflowCount());
    }
  }

  @Test
  public void aLossWithoutANumberIsOne() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.say(PlayerMessages.CODE, 0, Kind.SYNCH.code(), PlayerMessages.SYNCH_OVERFLOW.subtype(), new byte[0]);
    }); Client client = Client.connect(server.address())) {
      assertEquals(0, client.read());
      assertEquals(1, client.overflowCount());
    }
  }

  @Test
  public void aRetiredDeviceThatIsClosedLeavesNoDataToTheNextAtItsAddress() {
    CommonMessages.Devaddr address = new CommonMessages.Devaddr(0, 6665, Position2dMessages.CODE, 0);
    byte[] notice = new PlayerMessages.DeviceReq(address, 'e', new byte[0]).encode();
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.say(PlayerMessages.CODE, 0, Kind.ACK.code(), PlayerMessages.REQ_DEV.subtype(), notice);
      peer.answer(message, GEOM);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d gone = client.position2d(0);
      gone.geometry();
      Expect.error(DeviceGoneException.class, "^6665:position2d:0 is gone: the server retired it$", gone::geometry);
      gone.close();
      Position2d next = client.position2d(0);
      assertThrows(RequestTimeoutException.class, () -> client.read(Duration.ZERO));
      assertFalse(next.hasData() || next.isGone());
      assertEquals(1, client.skippedCount());
    }
  }

  @Test
  public void dataThatWaitTooLongAreDroppedAndCounted() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      for (int i = 0; i < 1030; ++i) {
        peer.data(Position2dMessages.DATA_STATE, Expect.state(i));
      }
      peer.answer(message, GEOM);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      List<Double> seen = new ArrayList<>();
      robot.onData((message, value, time) -> seen.add(((Position2dMessages.Data) value).pos().px()));
      robot.geometry();
      assertEquals(1024, client.read());
      assertEquals(6, client.overflowCount());
      assertEquals(6, seen.get(0), 0);
    }
  }

  @Test
  public void dataThatComeBeforeAnAnswerWaitForRead() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(5));
      peer.answer(message, GEOM);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      robot.geometry();
      assertThrows(NoDataException.class, robot::pose);
      client.read();
      assertEquals(5, robot.pose().x(), 0);
    }
  }

  @Test
  public void beforeTheFirstDataThereIsNoValue() {
    try (FakeServer server = FakeServer.serving(Peer::refuse);
        Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      Laser scanner = client.laser(0);
      Ranger ranger = client.ranger(0);
      List<ThrowingRunnable> looks = List.of(robot::state, robot::pose, robot::velocity, robot::isStalled,
          scanner::scan, scanner::ranges, scanner::intensities, client.sonar(0)::ranges, client.fiducial(0)::markers,
          ranger::scan, ranger::ranges, ranger::intensities, client.bumper(0)::pressed,
          client.camera(0)::image, client.ptz(0)::view,
          client.gps(0)::fix, client.pointCloud3d(0)::points, client.aio(0)::voltages);
      for (ThrowingRunnable look : looks) {
        Expect.error(NoDataException.class, ":0 has sent no data yet; nextData\\(\\) waits for them", look);
      }
      assertTrue(robot.latest(Position2dMessages.DATA_STATE).isEmpty());
    }
  }

  @Test
  public void dataOfOthersDoNotProlongTheTimeOutOfOne() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(LaserMessages.DATA_SCAN, new LaserMessages.Data());
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      Laser scanner = client.laser(0);
      Expect.error(RequestTimeoutException.class, "no data of position2d:0 in 0.05 s$",
          () -> robot.nextData(Expect.millis(50)));
      scanner.nextData();
      assertFalse(robot.hasData());
    }
  }

  @Test
  public void aFloodOfOtherDataDoesNotProlongItEither() {
    FakeServer.Script flood = peer -> {
      for (int opened = 0; opened < 2; ++opened) {
        Message opening = peer.receive();
        peer.answer(opening, opening.body());
      }
      while (!peer.hasMore()) {
        peer.data(LaserMessages.DATA_SCAN, new LaserMessages.Data());
      }
      peer.serve(Peer::refuse);
    };
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), flood);
        Client client = Client.connect(server.address(), Expect.PUSH)) {
      client.laser(0);
      Position2d robot = client.position2d(0);
      Expect.error(RequestTimeoutException.class, "no data of position2d:0 in 0.05 s$",
          () -> robot.nextData(Expect.millis(50)));
    }
  }

  @Test
  public void aServerThatRefusesDataIsAnError() {
    try (FakeServer server = FakeServer.serving(Peer::refuse); Client client = Client.connect(server.address())) {
      for (int i = 0; i < 2; ++i) {
        Expect.error(RequestRefusedException.class, "refuses to send data", client::read);
      }
    }
  }

  @Test
  public void whatMakesNoSenseIsSkippedAndCounted() {
    byte[] four = new byte[4];
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.say(4, 0, Kind.DATA.code(), 99, four);  // no such kind of data
      peer.say(4, 0, Kind.DATA.code(), 1, four);  // too short
      peer.say(4, 9, Kind.DATA.code(), 1, Expect.state(1).encode());  // a device that is not open
      peer.say(4, 0, Kind.NACK.code(), 5, new byte[0]);  // nobody asked
      peer.say(4, 0, 77, 5, new byte[0]);  // no such kind of message
      peer.data(Position2dMessages.DATA_STATE, Expect.state(6));
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      assertEquals(1, client.read());
      assertEquals(6, robot.pose().x(), 0);
      assertEquals(5, client.skippedCount());
    }
  }

  @Test
  public void aSizeOverTheLimitEndsTheConnection() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      ByteBuffer header = ByteBuffer.allocate(Header.BYTES);
      new Header(4, 0, Kind.DATA.code(), 1, 0.0, 0, 0xFFFFFFFFL, 0, 0).encode(header);
      peer.send(header.array());
    }); Client client = Client.connect(server.address())) {
      client.position2d(0);
      Expect.error(ConnectionLostException.class, "a header announces 4294967295 bytes, over the limit", client::read);
      assertFalse(client.isConnected());
    }
  }

  @Test
  public void callbacksMayAskButNotRead() {
    List<String> faults = new ArrayList<>();
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() != PlayerMessages.CODE) {
        peer.answer(message, GEOM);
        return;
      }
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      robot.onData((message, value, time) -> {
        robot.geometry();
        faults.add(assertThrows(PlayerException.class, client::read).getMessage());
      });
      client.read();
    }
    assertEquals(List.of("read() was called from a callback that read() itself is running"), faults);
  }

  @Test
  public void aCallbackMayCloseItsDevice() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2));
      peer.synch();
    }); Client client = Client.connect(server.address())) {
      Position2d robot = client.position2d(0);
      robot.onData((message, value, time) -> robot.close());
      assertEquals(1, client.read());
      assertEquals(1, client.skippedCount());
      assertEquals(1, robot.pose().x(), 0);
    }
  }

  @Test
  public void aTimeOutMayBeEndless() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.synch();
    }); Client client = Client.connect(server.address(), Options.DEFAULT.withTimeout(Options.FOREVER))) {
      client.position2d(0).nextData();
      assertEquals(1, client.read(Options.FOREVER));
    }
  }

  @Test
  public void aResetDropsWhatCameBeforeItsAnswerAndKeepsWhatComesAfter() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2), 2);
      peer.data(OpaqueMessages.DATA_STATE, new OpaqueMessages.Data(new byte[] {7}), 2);
      peer.answer(message, message.body());
      peer.data(Position2dMessages.DATA_STATE, Expect.state(3), 0.5);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      Opaque radio = client.opaque(0);
      Simulation simulator = client.simulation(0);
      simulator.step();
      assertTrue(robot.hasData() && radio.hasData());
      simulator.reset(7);
      for (Device device : List.of(robot, radio)) {
        assertFalse(device.hasData());
        assertFalse(device.isFresh());
        assertEquals(0, device.timestamp(), 0);
      }
      assertTrue(radio.takeMessages().isEmpty());
      Expect.error(NoDataException.class, "position2d:0 has sent no data yet", robot::pose);
      robot.nextData();
      assertEquals(3, robot.pose().x(), 0);
    }
  }

  @Test
  public void aRefusedResetDropsNothing() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2));
      peer.refuse(message);
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      Simulation simulator = client.simulation(0);
      Expect.error(RequestRefusedException.class, "reset was refused", () -> simulator.reset(7));
      client.read();
      assertEquals(2, robot.pose().x(), 0);
    }
  }

  @Test
  public void aTimeThatGoesBackDropsWhatOtherDevicesHaveOfALaterOne() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1), 1);
      peer.data(OpaqueMessages.DATA_STATE, new OpaqueMessages.Data(new byte[] {7}), 2);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2), 0.5);
      peer.answer(message, message.body());
    }); Client client = Client.connect(server.address(), Expect.PUSH)) {
      Position2d robot = client.position2d(0);
      Opaque radio = client.opaque(0);
      client.simulation(0).step();
      assertEquals(2, robot.pose().x(), 0);
      assertFalse(radio.hasData());
    }
  }
}
