package playhouse.client;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Header;
import playhouse.client.wire.Kind;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Struct;

/**
 * One session with a server: matches answers to requests, queues data, and tracks rounds of data. Messages
 * that are neither are skipped and counted.
 */
final class Session {
  /**
   * Limit on data queued for the next read() while a request waits for its answer: the queue length of a
   * server per client. The oldest are dropped and counted.
   */
  private static final int WAITING_LIMIT = 1024;

  private static final Key DATA_KEY = new Key(PlayerMessages.CODE, 0, PlayerMessages.REQ_DATA.subtype());
  private static final Key OPENING_KEY = new Key(PlayerMessages.CODE, 0, PlayerMessages.REQ_DEV.subtype());

  /**
   * Access in an unrequested answer to an open request: the device was retired. (Failed open requests have
   * ERROR_MODE.)
   */
  private static final int ERROR_LETTER = 'e';

  /** What an answer has of its request. */
  private record Key(int interfaceCode, int index, int subtype) {
    boolean isOf(Header header) {
      return header.isAnswer() && header.interfaceCode() == interfaceCode && header.index() == index
          && header.subtype() == subtype;
    }
  }

  private final Connection connection;
  private final Duration timeout;
  private final Consumer<CommonMessages.Devaddr> retire;
  private final List<Key> abandoned = new ArrayList<>();
  private final ArrayDeque<Message> waiting = new ArrayDeque<>();
  private boolean roundOpen;
  private boolean roundRefused;
  private boolean roundWaits;  // it ended during a request: its data are queued
  private boolean told;  // a device was retired
  private long overflowCount;
  private long unreadCount;  // those of them lost here
  private long skippedCount;
  private int serverPort;
  private int sequence;

  /** {@code retire} is called with the address of a device that the server has retired. */
  Session(Connection connection, Duration timeout, Consumer<CommonMessages.Devaddr> retire) {
    this.connection = connection;
    this.timeout = Deadline.checked(timeout);
    this.retire = retire;
  }

  /** For instance "position2d:0"; with a number if the interface has no known name. */
  static String deviceName(int interfaceCode, int index) {
    return Catalogue.interfaceName(interfaceCode) + ":" + index;
  }

  Connection connection() {
    return connection;
  }

  Duration timeout() {
    return timeout;
  }

  /** HOST:PORT of the server. */
  String peer() {
    return connection.peer();
  }

  /** The server's port as reported in its answers; the connected port may be that of a forwarder. */
  int serverPort() {
    return serverPort != 0 ? serverPort : connection.port();
  }

  long overflowCount() {
    return overflowCount;
  }

  long unreadCount() {
    return unreadCount;
  }

  long skippedCount() {
    return skippedCount;
  }

  boolean roundIsOpen() {
    return roundOpen;
  }

  boolean roundWasRefused() {
    return roundRefused;
  }

  /** Whether a device was retired since forgetNotices(). */
  boolean wasTold() {
    return told;
  }

  void forgetNotices() {
    told = false;
  }

  /** Counts a message that nobody takes. */
  void skip() {
    ++skippedCount;
  }

  /** The next queued data message; null if there is none. */
  Message nextWaiting() {
    return waiting.poll();
  }

  /** Sends a message; {@code payload} may be null. */
  void send(int interfaceCode, int index, MessageType<?> message, Struct payload) {
    send(interfaceCode, index, message, payload, 0);
  }

  /**
   * Sends a request and waits for the ACK. Throws RequestRefusedException on NACK, RequestTimeoutException on
   * silence.
   */
  Message request(int interfaceCode, int index, MessageType<?> message, Struct payload, Duration longest) {
    Deadline.checked(longest);
    send(interfaceCode, index, message, payload, sequence);
    String whose = message.name() + " of " + deviceName(interfaceCode, index);
    Message answer;
    try {
      answer = answer(new Key(interfaceCode, index, message.subtype()), Deadline.after(longest));
    } catch (RequestTimeoutException error) {
      throw new RequestTimeoutException(
          peer() + ": no answer to " + whose + " in " + Words.seconds(longest) + " s");
    }
    serverPort = answer.header().robot();
    if (answer.header().is(Kind.NACK)) {
      throw new RequestRefusedException(peer() + ": " + whose + " was refused", answer.body());
    }
    return answer;
  }

  /**
   * Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH
   * that closes it, or is refused.
   */
  void beginRound() {
    boolean here = roundWaits && !waiting.isEmpty();
    roundWaits = false;
    if (roundOpen || here) {
      return;
    }
    roundOpen = true;
    roundRefused = false;
    try {
      send(PlayerMessages.CODE, 0, PlayerMessages.REQ_DATA, null, sequence);
    } catch (ConnectionLostException error) {
      // data before the disconnection are still to be received, then the same error
    }
  }

  /** Receives one message outside a request and dispatches it. */
  void sortNext(Deadline deadline) {
    Message message = connection.receive(deadline);
    if (!takeNotice(message)) {
      sort(message);
    }
  }

  /** Drops all queued data. */
  void dropWaiting() {
    waiting.clear();
  }

  /** Drops queued data of a retired device, so that they are not delivered to a new device at its address. */
  void dropWaiting(int interfaceCode, int index) {
    int before = waiting.size();
    waiting.removeIf(each -> each.header().interfaceCode() == interfaceCode && each.header().index() == index);
    skippedCount += before - waiting.size();
  }

  private void send(int interfaceCode, int index, MessageType<?> message, Struct payload, int number) {
    byte[] body = payload == null ? new byte[0] : payload.encode();
    // As in libplayerc: the port in messages to a device, 0 in messages to the server.
    int robot = interfaceCode == PlayerMessages.CODE ? 0 : connection.port();
    double now = System.currentTimeMillis() / 1000.0;
    connection.send(new Header(interfaceCode, index, message.kind().code(), message.subtype(), now, number,
        body.length, 0, robot), body);
  }

  private Message answer(Key key, Deadline deadline) {
    boolean settled = false;
    try {
      while (true) {
        Message message = connection.receive(deadline);
        if (takeNotice(message)) {
          continue;
        }
        if (!key.isOf(message.header())) {
          sort(message);
        } else if (isOurs(message.header().sequence(), key)) {
          return message;
        } else {
          ++skippedCount;
          settled |= abandoned.remove(key);
        }
      }
    } catch (PlayerException error) {
      // From now on requests are numbered, so that a late answer to this one is not matched to another. If the answer
      // to an abandoned request of this type arrived meanwhile, the number of missing answers is unchanged.
      ++sequence;
      if (!settled) {
        abandoned.add(key);
      }
      throw error;
    }
  }

  /** 0 is the number of requests before the first time-out, and of servers that do not return numbers. */
  private boolean isOurs(int number, Key key) {
    return number != 0 ? number == sequence : !abandoned.contains(key);
  }

  /** Processes the notice that a device was retired; false for any other message. */
  private boolean takeNotice(Message message) {
    if (!message.header().is(Kind.ACK) || !OPENING_KEY.isOf(message.header())) {
      return false;
    }
    PlayerMessages.DeviceReq notice;
    try {
      notice = PlayerMessages.DeviceReq.decode(message.body());
    } catch (WireException error) {
      return false;
    }
    if (notice.access() != ERROR_LETTER) {
      return false;
    }
    told = true;
    retire.accept(notice.addr());
    return true;
  }

  private void sort(Message message) {
    Header header = message.header();
    if (header.is(Kind.DATA)) {
      if (waiting.size() == WAITING_LIMIT) {
        waiting.poll();
        ++overflowCount;
        ++unreadCount;
      }
      waiting.add(message);
    } else if (header.is(Kind.SYNCH)) {
      endRound(message);
    } else if (DATA_KEY.isOf(header)) {
      if (header.is(Kind.NACK)) {
        roundOpen = false;
        roundRefused = true;
      }
    } else {
      ++skippedCount;
    }
  }

  private void endRound(Message message) {
    roundOpen = false;
    roundWaits = !waiting.isEmpty();
    if (message.header().subtype() != PlayerMessages.SYNCH_OVERFLOW.subtype()) {
      return;
    }
    long lost = 0;
    try {
      lost = PlayerMessages.SYNCH_OVERFLOW.decode(message.body()).value();
    } catch (WireException error) {
      // a count is missing; at least one was lost
    }
    overflowCount += Math.max(lost, 1);
  }
}
