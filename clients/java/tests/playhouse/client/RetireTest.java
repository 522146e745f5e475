package playhouse.client;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** What a program sees of devices that the real server retires. */
public final class RetireTest {
  private static final Duration LONG = Duration.ofSeconds(30);  // an answer comes, or something hangs

  /** The server of clients/tests/retiring_server.cc, which PLAYHOUSE_RETIRING_SERVER names. */
  private static final class RetiringServer implements AutoCloseable {
    private final Process process;
    private final BufferedReader out;
    private final PrintWriter in;
    private final String address;

    RetiringServer() throws IOException {
      process = new ProcessBuilder(System.getenv("PLAYHOUSE_RETIRING_SERVER"))
          .redirectError(ProcessBuilder.Redirect.INHERIT).start();
      out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
      in = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8);
      address = out.readLine();
    }

    /** The line of an error about a device of it. */
    String gone(String device) {
      return "^" + address.split(":")[1] + ":" + device + " is gone: the server retired it$";
    }

    void run(String... lines) throws IOException {
      for (String line : lines) {
        in.println(line);
        assertEquals("done", out.readLine());
      }
    }

    Client client(Mode mode) throws IOException {
      run("add 0", "add 3");
      return Client.connect(address, new Options(mode, LONG));
    }

    @Override
    public void close() throws IOException {
      in.close();
      try {
        process.waitFor();
      } catch (InterruptedException error) {
        throw new AssertionError(error);
      }
    }
  }

  @Test
  public void itGivesItsLastDataAndFailsAtOnceFromThenOn() throws IOException {
    for (Mode mode : Mode.values()) {
      try (RetiringServer server = new RetiringServer(); Client client = server.client(mode)) {
        Position2d gone = client.position2d(3);
        Position2d other = client.position2d(0);
        server.run("publish 3 1", "retire 3", "publish 0 2");
        while (!(gone.isGone() && other.hasData())) {
          client.read();
        }
        assertEquals(1, gone.pose().x(), 0);
        gone.nextData();  // its last
        List<ThrowingRunnable> uses = List.of(() -> gone.drive(1), gone::geometry, gone::nextData);
        for (ThrowingRunnable use : uses) {
          Expect.error(DeviceGoneException.class, server.gone("position2d:3"), use);
        }
        gone.close();
        assertFalse(gone.isOpen());
        other.geometry();
      }
    }
  }

  @Test
  public void nextDataOfItDoesNotWait() throws IOException {
    for (Mode mode : Mode.values()) {
      try (RetiringServer server = new RetiringServer(); Client client = server.client(mode)) {
        Position2d gone = client.position2d(3);
        server.run("retire 3");
        Expect.error(DeviceGoneException.class, server.gone("position2d:3"), gone::nextData);
        assertTrue(client.isConnected());
      }
    }
  }

  @Test
  public void itLeavesItsAddressToAnotherAndDoesNotBecomeIt() throws IOException {
    for (Mode mode : Mode.values()) {
      try (RetiringServer server = new RetiringServer(); Client client = server.client(mode)) {
        Position2d gone = client.position2d(3);
        server.run("publish 3 1", "retire 3", "add 3");
        Position2d following = client.position2d(3);
        assertTrue(gone.isGone());
        server.run("publish 3 2");
        while (!following.hasData()) {
          client.read();
        }
        assertEquals(2, following.pose().x(), 0);
        assertFalse(following.isGone());
        assertFalse(gone.hasData() && gone.pose().x() == 2);
        gone.close();
        following.geometry();
      }
    }
  }

  @Test
  public void aRequestBeforeItIsToldIsRefused() throws IOException {
    try (RetiringServer server = new RetiringServer(); Client client = server.client(Mode.PULL)) {
      Position2d gone = client.position2d(3);
      server.run("retire 3");
      assertThrows(RequestRefusedException.class, gone::geometry);
      client.read();
      assertThrows(DeviceGoneException.class, gone::geometry);
    }
  }
}
