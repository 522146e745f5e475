package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Kind;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.RangerMessages;
import playhouse.client.wire.SimulationMessages;
import playhouse.client.wire.SimulationMessages.PropertyReq;
import playhouse.client.wire.Text;

/** Robots by name, from a server of a few lines that lists its models. */
public final class RobotsTest {
  private static final List<String> HOUSE = List.of(
      "0\tr0\tposition\t\tPORT:position2d:0",
      "1\tr0.ranger:0\tranger\tr0\tPORT:ranger:0 PORT:sonar:0",
      "2\twall\tmodel\t\t",
      "3\tguest\tposition\t\tPORT:position2d:12",
      "4\tguest.ranger:0\tranger\tguest\tPORT:ranger:20 PORT:laser:12",
      "5\tguest.arm\tmodel\tguest\t",
      "6\tguest.arm.eye\tfiducial\tguest.arm\tPORT:fiducial:3",
      "7\tguest.ranger:1\tranger\tguest\tPORT:ranger:21 PORT:laser:30",
      "8\tnext\tposition\t\t9999:position2d:0");
  private static final String NAME = "a\tb\\n\n";

  @Test
  public void aLineIsAModelWithItsDevices() {
    List<DeviceAddress> devices =
        List.of(new DeviceAddress(6665, "ranger", 1, NAME), new DeviceAddress(1, "laser", 2, NAME));
    assertEquals(List.of(new Model(NAME, "ranger", "r 0", devices, 4)),
        ModelList.parse("4\ta\\tb\\\\n\\n\tranger\tr 0\t6665:ranger:1 1:laser:2\n"));
  }

  @Test
  public void linesThatMakeNoSenseAreAnError() {
    for (String line : List.of("x\n", "x\ta\tb\tc\t\n", "0\ta\tb\tc\td\te\n", "0\ta\tb\tc\tlaser:0\n",
        "0\ta\tb\tc\t1:laser:\n", "0\ta\tb\tc\t1:laser:99999999999\n", "99999999999999999999\ta\tb\tc\t\n")) {
      Expect.error(WireException.class, "list of models", () -> ModelList.parse(line));
    }
  }

  @Test
  public void whatAModelCarriesIsFoundAtAnyDepth() {
    List<Model> models = ModelList.parse(page(HOUSE, 1));
    assertEquals(List.of("guest", "guest.ranger:0", "guest.arm", "guest.arm.eye", "guest.ranger:1"),
        ModelList.families(models).get(3).stream().map(Model::name).toList());
  }

  @Test
  public void aRobotHasTheDevicesOfAllItCarries() {
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      Robot guest = client.robot("guest");
      assertEquals(List.of("position2d:12", "ranger:20", "laser:12", "fiducial:3", "ranger:21", "laser:30"),
          guest.devices().stream().map(DeviceAddress::name).toList());
      assertEquals("guest", guest.name());
      assertEquals("position2d:12", guest.position2d().name());
      assertEquals("laser:12", guest.laser().name());
      assertEquals("fiducial:3", guest.fiducial().name());
      assertEquals(List.of("ranger:20", "ranger:21"), guest.rangers().stream().map(Device::name).toList());
      assertEquals(List.of(), guest.sonars());
      assertSame(guest.rangers().get(1), guest.device("ranger", 1));
    }
  }

  @Test
  public void robotsAreTheModelsAtTheTopWithDevicesHere() {
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      assertEquals(List.of("r0", "guest"), client.robots().stream().map(Robot::name).toList());
      assertEquals("position", client.robots().get(1).type());
      assertSame(client.robot("guest"), client.robots().get(1));
    }
  }

  @Test
  public void theLastOfEqualNamesIsMeant() {
    String page = "0\tr\tposition\t\t1:position2d:0\n1\tr.l\tranger\tr\t1:laser:0\n2\tr\tposition\t\t1:position2d:1\n";
    try (FakeServer server = FakeServer.serving(lister(Map.of(0, page), Map.of(0, 0)));
        Client client = Client.connect(server.address())) {
      assertEquals(List.of("position2d:1"),
          client.robot("r").devices().stream().map(DeviceAddress::name).toList());
    }
  }

  @Test
  public void devicesAreListedWithTheirModels() {
    try (FakeServer server = FakeServer.serving((peer, message) -> {
      if (message.header().interfaceCode() == SimulationMessages.CODE) {
        peer.answer(message, models(page(HOUSE, peer.port()), 0));
      } else if (message.header().subtype() == PlayerMessages.REQ_DEVLIST.subtype()) {
        peer.answer(message, new PlayerMessages.DeviceDevlist(Stream.of(
            new int[] {31, 0}, new int[] {4, 12}, new int[] {RangerMessages.CODE, 20}, new int[] {6, 77})
            .map(at -> new CommonMessages.Devaddr(0, peer.port(), at[0], at[1])).toList()));
      } else {
        peer.refuse(message);
      }
    }); Client client = Client.connect(server.address())) {
      assertEquals(List.of(new DeviceEntry("simulation", 0, "", "", ""),
          new DeviceEntry("position2d", 12, "", "guest", "guest"),
          new DeviceEntry("ranger", 20, "", "guest.ranger:0", "guest"), new DeviceEntry("laser", 77, "", "", "")),
          client.devices());
    }
  }

  @Test
  public void devicesAreOpenedOnceAndTheModelsRequestedOnce() {
    FakeServer ended;
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      ended = server;
      for (int i = 0; i < 3; ++i) {
        client.robot("guest").position2d().stop();
      }
      assertSame(client.robot("guest").laser(), client.robot("guest").lasers().get(0));
      client.robot("r0");
    }
    assertEquals(List.of("+4:12", "+6:12", "+6:30", "-6:30", "-6:12", "-4:12"), opened(ended));
    assertEquals(3, ended.peer().received().stream()
        .filter(each -> each.header().interfaceCode() == SimulationMessages.CODE).count());
  }

  @Test
  public void aRobotThatCameLaterIsFound() {
    String one = "0\tr0\tposition\t\t1:position2d:0\n";
    ArrayDeque<String> lists = new ArrayDeque<>(List.of(one, one + "1\tr1\tposition\t\t1:position2d:1\n"));
    try (FakeServer server = FakeServer.serving((peer, message) ->
        peer.answer(message, models(lists.size() > 1 ? lists.remove() : lists.element(), 0)));
        Client client = Client.connect(server.address())) {
      Robot first = client.robot("r0");
      assertEquals("position2d:1", client.robot("r1").devices().get(0).name());
      assertSame(first, client.robot("r0"));
      assertEquals(List.of("r0", "r1"), client.models().stream().map(Model::name).toList());
    }
  }

  @Test
  public void closingARobotStopsItAndItOpensAgain() {
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      Robot guest = client.robot("guest");
      Position2d base = guest.position2d();
      base.drive(0.1);
      guest.close();
      assertFalse(base.isOpen());
      List<Message> received = server.peer().received();
      assertEquals(List.of(Kind.CMD.code(), Kind.CMD.code(), Kind.REQ.code()),
          received.subList(received.size() - 3, received.size()).stream().map(each -> each.header().kind()).toList());
      assertTrue(guest.position2d().isOpen());
    }
  }

  @Test
  public void aNameThatIsNotThereGetsTheNearestOne() {
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      Expect.error(RequestRefusedException.class,
          "^there is no robot \"gest\" at " + server.address() + " \\(did you mean \"guest\"\\?\\)$",
          () -> client.robot("gest"));
      Expect.error(RequestRefusedException.class, "^there is no robot \"xyzzy\" at " + server.address() + "$",
          () -> client.robot("xyzzy"));
    }
  }

  @Test
  public void aDeviceThatARobotLacksIsToldWithWhatItHas() {
    try (FakeServer server = FakeServer.serving(RobotsTest::house); Client client = Client.connect(server.address())) {
      Expect.error(RequestRefusedException.class,
          "^robot \"r0\" has no laser \\(it has position2d:0, ranger:0, sonar:0\\)$", () -> client.robot("r0").laser());
      Expect.error(RequestRefusedException.class, "^robot \"r0\" has no sonar number 1 ",
          () -> client.robot("r0").device("sonar", 1));
      Expect.error(RequestRefusedException.class, "^robot \"wall\" has no laser \\(it has no devices\\)$",
          () -> client.robot("wall").laser());
      Expect.error(RequestRefusedException.class,
          "at port " + server.port() + ", but position2d:0 at port 9999: connect there$",
          () -> client.robot("next").position2d());
    }
  }

  @Test
  public void aServerThatDoesNotListModelsIsTold() {
    try (FakeServer server = FakeServer.serving(Peer::refuse); Client client = Client.connect(server.address())) {
      List<ThrowingRunnable> questions = List.of(client::robots, () -> client.robot("r0"));
      for (ThrowingRunnable question : questions) {
        Expect.error(RequestRefusedException.class,
            "this server does not tell the names of models; open devices by number$", question);
      }
    }
  }

  @Test
  public void aListThatGoesRoundInCirclesIsAnError() {
    String page = "0\tr0\tposition\t\t\n";
    try (FakeServer server = FakeServer.serving(lister(Map.of(0, page, 1, page), Map.of(0, 1, 1, 1)));
        Client client = Client.connect(server.address())) {
      Expect.error(WireException.class, "goes on at 1 after 1$", client::robots);
    }
  }

  private static String page(List<String> lines, int port) {
    return lines.stream().map(line -> line.replace("PORT", Integer.toString(port)) + "\n")
        .collect(Collectors.joining());
  }

  private static PropertyReq models(String page, int following) {
    return new PropertyReq(Text.field(""), Text.field("models"), following, page.getBytes(StandardCharsets.UTF_8));
  }

  /** All of HOUSE, three models at a time. */
  private static void house(Peer peer, Message message) throws IOException {
    Map<Integer, String> pages = Stream.of(0, 3, 6)
        .collect(Collectors.toMap(at -> at, at -> page(HOUSE.subList(at, at + 3), peer.port())));
    lister(pages, Map.of(0, 3, 3, 6, 6, 0)).answer(peer, message);
  }

  /** Answers questions for models from an index with a page and the index that follows. */
  private static Peer.Rounds lister(Map<Integer, String> pages, Map<Integer, Integer> following) {
    return (peer, message) -> {
      if (message.header().interfaceCode() != SimulationMessages.CODE) {
        if (message.header().is(Kind.REQ)) {
          peer.refuse(message);
        }
        return;
      }
      PropertyReq question = PropertyReq.decode(message.body());
      assertEquals("models of \"\"", Text.of(question.prop()) + " of \"" + Text.of(question.name()) + "\"");
      peer.answer(message, models(pages.get((int) question.index()), following.get((int) question.index())));
    };
  }

  /** The devices that were opened (+) and closed (-), simulation aside. */
  private static List<String> opened(FakeServer server) {
    return server.peer().received().stream()
        .filter(each -> each.header().interfaceCode() == PlayerMessages.CODE
            && each.header().subtype() == PlayerMessages.REQ_DEV.subtype())
        .map(each -> PlayerMessages.DeviceReq.decode(each.body()))
        .filter(each -> each.addr().interf() != SimulationMessages.CODE)
        .map(each -> (each.access() == PlayerMessages.CLOSE_MODE ? "-" : "+") + each.addr().interf() + ":"
            + each.addr().index()).toList();
  }
}
