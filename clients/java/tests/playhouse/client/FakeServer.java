package playhouse.client;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A server of a few lines for one client, in a thread of its own: a script says what it answers. */
final class FakeServer implements AutoCloseable {
  private static final int LONGEST_MILLIS = 10_000;

  /** What a server does with its client. */
  @FunctionalInterface
  interface Script {
    void run(Peer peer) throws IOException;
  }

  private final ServerSocket listener = listener();
  private final Script script;
  private final byte[] banner;
  private final Thread thread = new Thread(this::run);
  private volatile Peer peer;
  private volatile Throwable failure;

  FakeServer(byte[] banner, Script script) {
    this.banner = banner;
    this.script = script;
    thread.setDaemon(true);
    thread.start();
  }

  /** With the usual banner, and what every client requests acknowledged. */
  static FakeServer serving(Peer.Rounds rounds) {
    return new FakeServer(banner("Player v.3.1.1"), peer -> peer.serve(rounds));
  }

  static byte[] banner(String text) {
    return Arrays.copyOf(text.getBytes(StandardCharsets.US_ASCII), 32);
  }

  int port() {
    return listener.getLocalPort();
  }

  String address() {
    return "127.0.0.1:" + port();
  }

  /** Once the client has connected. */
  Peer peer() {
    return peer;
  }

  /** Waits for the end of the script. Throws what failed in it. */
  @Override
  public void close() {
    try {
      thread.join(LONGEST_MILLIS);
      listener.close();
    } catch (IOException | InterruptedException error) {
      throw new AssertionError(error);
    }
    if (failure != null) {
      throw new AssertionError(failure);
    }
  }

  private static ServerSocket listener() {
    try {
      ServerSocket made = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
      made.setSoTimeout(LONGEST_MILLIS);
      return made;
    } catch (IOException error) {
      throw new AssertionError(error);
    }
  }

  private void run() {
    try (Socket connection = listener.accept()) {
      connection.setSoTimeout(LONGEST_MILLIS);
      connection.setTcpNoDelay(true);
      peer = new Peer(connection);
      peer.send(banner);
      script.run(peer);
    } catch (IOException error) {
      // nobody came, the client has seen enough, or the script leaves
    } catch (RuntimeException | Error error) {
      failure = error;
    }
  }
}
