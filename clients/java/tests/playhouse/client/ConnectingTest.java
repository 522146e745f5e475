package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import java.io.IOException;
import java.net.ServerSocket;
import org.junit.Test;

/** Banners and addresses. */
public final class ConnectingTest {
  @Test
  public void nobodyThere() {
    String address;
    try (FakeServer server = new FakeServer(FakeServer.banner("Player v.3.1"), peer -> {})) {
      address = server.address();
      Client.connect(address, Expect.PUSH).close();
    }
    Expect.error(ConnectionLostException.class, "^" + address + ": cannot connect: ", () -> Client.connect(address));
  }

  @Test
  public void aServerOfAnotherKind() {
    byte[] banner = FakeServer.banner("220 mail.example.org ESMTP ready now");
    try (FakeServer server = new FakeServer(banner, peer -> {})) {
      Expect.error(ConnectionLostException.class, "not a Player server \\(it says '220 mail",
          () -> Client.connect(server.address()));
    }
  }

  @Test
  public void aServerThatSaysNothing() {
    try (FakeServer server = new FakeServer(new byte[0], Peer::receive)) {
      Expect.error(ConnectionLostException.class, "cannot connect: no banner in time",
          () -> Client.connect(server.address(), Expect.PUSH.withTimeout(Expect.millis(50))));
    }
  }

  @Test
  public void aBannerInPieces() {
    FakeServer.Script pieces = peer -> peer.sendInSingleBytes(FakeServer.banner("Player v.3.1"));
    try (FakeServer server = new FakeServer(new byte[0], pieces);
        Client client = Client.connect(server.address(), Expect.PUSH)) {
      assertEquals("Player v.3.1", client.banner());
    }
  }

  @Test
  public void anIpv6AddressIsInBrackets() {
    Expect.error(ConnectionLostException.class, "^::1:1: cannot connect", () -> Client.connect("[::1]:1"));
    Expect.error(ConnectionLostException.class, "is not HOST or HOST:PORT", () -> Client.connect("[::1]:"));
  }

  @Test
  public void anAddressWithoutAHostIsThisMachineWithoutANameToResolve() {
    Expect.error(ConnectionLostException.class, "^127\\.0\\.0\\.1:1: cannot connect", () -> Client.connect(":1"));
  }

  @Test
  public void anAddressWithoutAPortHasTheUsualOne() {
    for (String host : new String[] {"a..b", "[a..b]"}) {
      Expect.error(ConnectionLostException.class, "^a\\.\\.b:6665: cannot connect", () -> Client.connect(host));
    }
  }

  @Test
  public void aHostThatIsNoName() {
    for (String host : new String[] {"a..b", "x".repeat(70), "nul\0", "no such host"}) {
      Expect.error(ConnectionLostException.class, "cannot connect", () -> Client.connect(host));
    }
    Expect.error(ConnectionLostException.class, "cannot connect",
        () -> new Client("127.0.0.1", 70000, Options.DEFAULT));
  }

  @Test
  public void anAddressThatIsNone() {
    for (String address : new String[] {"localhost:port", "localhost:0", "localhost:65536", "localhost:"}) {
      Expect.error(ConnectionLostException.class, "^\"" + address + "\" is not HOST or HOST:PORT$",
          () -> Client.connect(address));
    }
  }

  @Test
  public void anInterruptedThreadDoesNotConnect() throws IOException {
    try (ServerSocket listener = new ServerSocket(0)) {
      Thread.currentThread().interrupt();
      Expect.error(WaitInterruptedException.class, "the thread was interrupted$",
          () -> Client.connect("127.0.0.1:" + listener.getLocalPort()));
      assertFalse(Thread.interrupted());
    }
  }
}
