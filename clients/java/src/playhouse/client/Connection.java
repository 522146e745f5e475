package playhouse.client;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import playhouse.client.wire.Header;

/**
 * One TCP connection to a Player server: banner, framing, deadlines. It interprets headers only.
 *
 * <p>It sends and receives complete messages. A time-out keeps partially read bytes, so reading can continue.
 * If the server disconnects, messages that it had sent can still be received; then every call throws the
 * reason. The channel does not block: so writing has a time-out, too, and the interrupt of a thread does not
 * close it.
 */
final class Connection {
  private static final int BANNER_BYTES = 32;
  private static final int CHUNK = 65536;
  private static final Duration LONGEST_CONNECTING = Duration.ofDays(1);

  private final String peer;
  private final int port;
  private final Duration timeout;
  private final String banner;
  private SocketChannel channel;  // null: closed
  private Selector selector;
  private byte[] bytes = new byte[CHUNK];
  private int start;  // of what has been received and not been taken
  private int end;
  private String fault = "";  // why nothing can be sent
  private boolean ended;  // by the server, in order

  /** Connects, and reads the banner. Throws ConnectionLostException. */
  Connection(String host, int port, Duration timeout) {
    peer = host + ":" + port;
    this.port = port;
    this.timeout = Deadline.checked(timeout);
    try {
      channel = connected(host, port);
      channel.configureBlocking(false);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      selector = Selector.open();
      channel.register(selector, 0);
      banner = readBanner(Deadline.after(timeout));
    } catch (RequestTimeoutException error) {
      throw drop("cannot connect: no banner in time");
    } catch (IOException | IllegalArgumentException error) {  // the latter of an invalid port or host
      ConnectionLostException lost = drop("cannot connect: " + reason(error));
      if (Thread.interrupted()) {
        throw interrupted();
      }
      throw lost;
    } catch (ConnectionLostException | WaitInterruptedException error) {
      drop(reason(error));
      throw error;
    }
  }

  /** HOST:PORT of the server. */
  String peer() {
    return peer;
  }

  int port() {
    return port;
  }

  String banner() {
    return banner;
  }

  boolean isAlive() {
    return channel != null && fault.isEmpty();
  }

  /** Sends a message, whose header's size is set here. Throws ConnectionLostException, WireException. */
  void send(Header header, byte[] body) {
    if (body.length > Header.MAX_BODY_BYTES) {
      throw new WireException(
          "a message of " + body.length + " bytes is over the wire's limit of " + Header.MAX_BODY_BYTES);
    }
    if (!isAlive()) {
      throw lost();
    }
    ByteBuffer out = ByteBuffer.allocate(Header.BYTES + body.length);
    header.encode(out);
    out.put(body).flip();
    boolean wasInterrupted = false;
    try {
      Deadline deadline = Deadline.after(timeout);
      while (out.hasRemaining()) {
        if (channel.write(out) == 0) {
          wasInterrupted |= !await(SelectionKey.OP_WRITE, deadline);  // a message is sent whole, nevertheless
        }
      }
    } catch (IOException error) {  // a partially sent message cannot be continued
      fault = "the server is gone: " + reason(error);
      throw lost();
    } catch (RequestTimeoutException error) {
      fault = "the server is gone: timed out";
      throw lost();
    } finally {
      if (wasInterrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** The next message. Throws RequestTimeoutException, WaitInterruptedException, ConnectionLostException. */
  Message receive(Deadline deadline) {
    need(Header.BYTES, deadline);
    Header header = Header.decode(ByteBuffer.wrap(bytes, start, Header.BYTES));
    if (header.size() > Header.MAX_BODY_BYTES) {
      throw drop("a header announces " + header.size() + " bytes, over the limit");
    }
    need(Header.BYTES + (int) header.size(), deadline);
    start += Header.BYTES;
    return new Message(header, taken((int) header.size()));
  }

  /** Whether a complete message has been received, so that receive() returns without waiting. */
  boolean hasMessage() {
    if (end - start < Header.BYTES) {
      return false;
    }
    long size = Header.decode(ByteBuffer.wrap(bytes, start, Header.BYTES)).size();
    return size > Header.MAX_BODY_BYTES || end - start >= Header.BYTES + size;
  }

  /**
   * Shuts down sending and waits until the server has read everything, up to {@code longest}: closing with
   * unread data makes TCP discard data in transit, such as a last stop command.
   */
  void close(Duration longest) {
    if (channel == null) {
      return;
    }
    Deadline deadline = Deadline.after(longest);
    try {
      channel.shutdownOutput();
      ByteBuffer unread = ByteBuffer.allocate(CHUNK);
      int count;
      while ((count = channel.read(unread.clear())) >= 0 && !deadline.isPast()) {
        if (count == 0 && !fault.isEmpty()) {
          break;
        }
        if (count == 0 && !await(SelectionKey.OP_READ, deadline)) {
          Thread.currentThread().interrupt();
          break;
        }
      }
    } catch (IOException | RequestTimeoutException error) {
      // already disconnecting, or silent
    }
    drop("the connection is closed");
  }

  private SocketChannel connected(String host, int port) throws IOException {
    Duration longest = timeout.compareTo(LONGEST_CONNECTING) < 0 ? timeout : LONGEST_CONNECTING;
    IOException last = null;
    for (InetAddress address : InetAddress.getAllByName(host)) {
      InetSocketAddress there = new InetSocketAddress(address, port);
      SocketChannel made = SocketChannel.open();
      try {
        made.socket().connect(there, (int) Math.max(longest.toMillis(), 1));  // 0 would be endless
        return made;
      } catch (IOException error) {
        made.close();
        last = error;
      }
    }
    throw last;
  }

  private String readBanner(Deadline deadline) {
    need(BANNER_BYTES, deadline);
    String text = new String(taken(BANNER_BYTES), StandardCharsets.ISO_8859_1);
    if (!text.startsWith("Player v.")) {
      throw drop("not a Player server (it says '" + text.replaceAll("[^ -~]", ".") + "')");
    }
    return text.replaceAll("\0+$", "");
  }

  private byte[] taken(int count) {
    start += count;
    return Arrays.copyOfRange(bytes, start - count, start);
  }

  /** Waits until this number of bytes has been received. */
  private void need(int count, Deadline deadline) {
    while (end - start < count) {
      if (channel == null) {
        throw lost();
      }
      try {
        int received = channel.read(room(count));
        end += Math.max(received, 0);
        if (received < 0) {
          ended = fault.isEmpty();
          throw drop("the run ended: the server closed the connection");
        }
        if (received == 0 && !fault.isEmpty()) {  // after a fault in sending nothing new is expected
          throw drop(fault);
        }
        if (received == 0 && !await(SelectionKey.OP_READ, deadline)) {
          throw interrupted();
        }
      } catch (IOException error) {
        throw drop("the server is gone: " + reason(error));
      }
    }
  }

  /** Room behind what has been received. It grows with what arrives, not with what a header announces. */
  private ByteBuffer room(int wanted) {
    if (start == end) {
      start = end = 0;
    }
    if (end == bytes.length || start > 0 && wanted > bytes.length - start) {
      byte[] to = end - start > bytes.length / 2 ? new byte[2 * bytes.length] : bytes;
      System.arraycopy(bytes, start, to, 0, end - start);
      bytes = to;
      end -= start;
      start = 0;
    }
    return ByteBuffer.wrap(bytes, end, Math.min(CHUNK, bytes.length - end));
  }

  /** Waits until the channel is ready; false if the thread is interrupted, whose status it clears. */
  private boolean await(int operation, Deadline deadline) throws IOException {
    if (deadline.isPast()) {
      throw new RequestTimeoutException(peer + ": no message in time");
    }
    channel.keyFor(selector).interestOps(operation);
    selector.select(Math.max(1, TimeUnit.NANOSECONDS.toMillis(deadline.left().toNanos())));
    selector.selectedKeys().clear();
    return !Thread.interrupted();
  }

  private static String reason(Exception error) {
    return error.getMessage() == null ? error.getClass().getSimpleName() : error.getMessage();
  }

  private WaitInterruptedException interrupted() {
    return new WaitInterruptedException(peer + ": the thread was interrupted");
  }

  private ConnectionLostException lost() {
    String text = peer + ": " + fault;
    return ended ? new RunEndedException(text) : new ConnectionLostException(text);
  }

  /** Closes the connection and returns the error to throw, with the first reason found. */
  private ConnectionLostException drop(String why) {
    fault = fault.isEmpty() ? why : fault;
    for (AutoCloseable each : new AutoCloseable[] {selector, channel}) {
      try {
        if (each != null) {
          each.close();
        }
      } catch (Exception error) {
        // nothing is left to do with it
      }
    }
    channel = null;
    return lost();
  }
}
