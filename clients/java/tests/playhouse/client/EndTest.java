package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.Test;
import playhouse.client.wire.Kind;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Position2dMessages;

/**
 * The end of a server, which has often just sent the last data: they are delivered before the error. And the
 * end of a client, which stops what it drove.
 */
public final class EndTest {
  @Test
  public void aRoundThatIsNeverClosedIsDelivered() {
    check(Mode.PULL, List.of(1.0, 2.0), (peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2));
    });
  }

  @Test
  public void dataInsteadOfAnAnswerAreDeliveredAndTheirLossesCounted() {
    List<Double> wanted = IntStream.range(0, 3000).mapToObj(i -> (double) i).toList();  // more than wait for a request
    Client client = check(Mode.PULL, wanted, (peer, message) -> {
      for (double x : wanted) {
        peer.data(Position2dMessages.DATA_STATE, Expect.state(x));
      }
      peer.synch(551);
    });
    assertEquals(551, client.overflowCount());
  }

  @Test
  public void pushedDataAreDelivered() {
    check(Mode.PUSH, List.of(1.0, 2.0), (peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.data(Position2dMessages.DATA_STATE, Expect.state(2));
    });
  }

  @Test
  public void dataThatCameBeforeACommandFailedCanStillBeRead() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.leave();
    }); Client client = Client.connect(server.address(), Expect.PUSH); Position2d robot = client.position2d(0)) {
      Expect.error(ConnectionLostException.class, "the server is gone: ", () -> {
        while (true) {
          robot.drive(0.1);
        }
      });
      client.read();
      assertEquals(1, robot.pose().x(), 0);
      Expect.error(ConnectionLostException.class, "the server is gone: ", client::read);
    }
  }

  @Test
  public void updatesEndWithTheLastData() {
    List<Double> seen = new ArrayList<>();
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      peer.answer(message);
      peer.data(Position2dMessages.DATA_STATE, Expect.state(1));
      peer.finish();
    }); Client client = Client.connect(server.address()); Position2d robot = client.position2d(0)) {
      assertThrows(RunEndedException.class, () -> robot.updates().forEach(state -> seen.add(state.pose().x())));
    }
    assertEquals(List.of(1.0), seen);
  }

  @Test
  public void aMovingRobotIsStoppedBeforeItsDeviceIsClosed() {
    FakeServer ended;
    try (FakeServer server = FakeServer.serving((peer, message) -> {});
        Client client = Client.connect(server.address())) {
      ended = server;
      client.position2d(0).drive(0.4, 0.1);
    }
    assertEquals(List.of(0.4, 0.0), speeds(ended));
    List<Message> received = ended.peer().received();
    Message last = received.get(received.size() - 1);
    assertEquals(PlayerMessages.CLOSE_MODE, PlayerMessages.DeviceReq.decode(last.body()).access());
  }

  @Test
  public void aRobotThatStandsGetsNoFurtherCommand() {
    FakeServer ended;
    try (FakeServer server = FakeServer.serving((peer, message) -> {});
        Client client = Client.connect(server.address()); Position2d robot = client.position2d(0)) {
      ended = server;
      robot.drive(0.4);
      robot.stop();
    }
    assertEquals(List.of(0.4, 0.0), speeds(ended));
  }

  @Test
  public void devicesAreClosedInReverseOrderOfOpening() {
    FakeServer ended;
    try (FakeServer server = FakeServer.serving((peer, message) -> peer.refuse(message));
        Client client = Client.connect(server.address())) {
      ended = server;
      client.position2d(0);
      client.laser(0);
      client.position2d(1);
    }
    List<String> closed = ended.peer().received().stream()
        .filter(each -> each.header().subtype() == PlayerMessages.REQ_DEV.subtype())
        .map(each -> PlayerMessages.DeviceReq.decode(each.body()))
        .filter(each -> each.access() == PlayerMessages.CLOSE_MODE)
        .map(each -> each.addr().interf() + ":" + each.addr().index()).toList();
    assertEquals(List.of("4:1", "6:0", "4:0"), closed);
  }

  @Test
  public void readingAccessIsAskedForByItsLetter() {
    FakeServer ended;
    try (FakeServer server = FakeServer.serving((peer, message) -> {});
        Client client = Client.connect(server.address())) {
      ended = server;
      client.position2d(0, Access.READ);
    }
    assertEquals('r', PlayerMessages.DeviceReq.decode(ended.peer().received().get(1).body()).access());
  }

  /** The server answers the first request of the client with {@code last} and ends. */
  private static Client check(Mode mode, List<Double> wanted, Peer.Rounds last) {
    Peer.Rounds rounds = (peer, message) -> {
      last.answer(peer, message);
      peer.finish();
    };
    try (FakeServer server = FakeServer.serving(rounds);
        Client client = Client.connect(server.address(), Options.DEFAULT.withMode(mode))) {
      Position2d robot = client.position2d(0);
      List<Double> seen = new ArrayList<>();
      robot.onData((message, value, time) -> seen.add(((Position2dMessages.Data) value).pos().px()));
      if (mode == Mode.PUSH) {
        robot.drive(0.1);  // anything, for the script to go on
      }
      int[] counted = {0};
      Expect.error(RunEndedException.class, "the run ended: the server closed the connection$", () -> {
        while (true) {
          counted[0] += client.read();
        }
      });
      assertEquals(wanted, seen);
      assertEquals(wanted.size(), counted[0]);
      Expect.error(RunEndedException.class, "the server closed the connection$", client::read);
      assertFalse(client.isConnected());
      return client;
    }
  }

  private static List<Double> speeds(FakeServer server) {
    return server.peer().received().stream().filter(each -> each.header().is(Kind.CMD))
        .map(each -> Position2dMessages.CmdVel.decode(each.body()).vel().px()).toList();
  }
}
