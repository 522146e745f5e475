package playhouse.client;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import playhouse.client.wire.Header;
import playhouse.client.wire.Kind;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Struct;

/** The server's end of a connection, for scripts. */
final class Peer {
  /** Answers one message of a client. */
  @FunctionalInterface
  interface Rounds {
    void answer(Peer peer, Message message) throws IOException;
  }

  private final Socket socket;
  private final DataInputStream in;
  private final List<Message> received = new CopyOnWriteArrayList<>();

  Peer(Socket socket) throws IOException {
    this.socket = socket;
    in = new DataInputStream(socket.getInputStream());
  }

  /** What the client has sent so far. */
  List<Message> received() {
    return received;
  }

  /** The port that the client has connected to. */
  int port() {
    return socket.getLocalPort();
  }

  /** The client's next message, null at its end. */
  Message receive() throws IOException {
    byte[] header = new byte[Header.BYTES];
    try {
      in.readFully(header);
      Header decoded = Header.decode(ByteBuffer.wrap(header));
      byte[] body = new byte[(int) decoded.size()];
      in.readFully(body);
      received.add(new Message(decoded, body));
      return received.get(received.size() - 1);
    } catch (EOFException error) {
      return null;
    }
  }

  /** Whether the client has sent more than has been received. */
  boolean hasMore() throws IOException {
    return in.available() > 0;
  }

  void send(byte[] data) throws IOException {
    socket.getOutputStream().write(data);
  }

  void sendInSingleBytes(byte[] data) throws IOException {
    for (byte each : data) {
      send(new byte[] {each});
    }
  }

  void answer(Message request) throws IOException {
    answer(request, new byte[0]);
  }

  void answer(Message request, Struct contents) throws IOException {
    answer(request, contents.encode());
  }

  void answer(Message request, byte[] body) throws IOException {
    answer(request, Kind.ACK, body, request.header().sequence());
  }

  void refuse(Message request) throws IOException {
    answer(request, Kind.NACK, new byte[0], request.header().sequence());
  }

  void answer(Message request, Kind kind, byte[] body, int sequence) throws IOException {
    Header to = request.header();
    say(to.interfaceCode(), to.index(), kind.code(), to.subtype(), body, sequence, 1.0);
  }

  void data(MessageType<?> message, Struct value) throws IOException {
    data(message, value, 1.0);
  }

  void data(MessageType<?> message, Struct value, double time) throws IOException {
    say(message.interfaceCode(), 0, message.kind().code(), message.subtype(), value.encode(), 0, time);
  }

  /** Ends a round. */
  void synch() throws IOException {
    say(PlayerMessages.CODE, 0, Kind.SYNCH.code(), 1, new byte[0], 0, 1.0);
  }

  /** Ends a round, of which so many messages were lost. */
  void synch(int lost) throws IOException {
    say(PlayerMessages.CODE, 0, Kind.SYNCH.code(), 2, ByteBuffer.allocate(4).putInt(lost).array(), 0, 1.0);
  }

  void say(int interfaceCode, int index, int kind, int subtype, byte[] body) throws IOException {
    say(interfaceCode, index, kind, subtype, body, 0, 1.0);
  }

  private void say(int interfaceCode, int index, int kind, int subtype, byte[] body, int sequence, double time)
      throws IOException {
    send(encoded(new Header(interfaceCode, index, kind, subtype, time, sequence, body.length, 0, 0), body));
  }

  static byte[] encoded(Header header, byte[] body) {
    ByteBuffer out = ByteBuffer.allocate(Header.BYTES + body.length);
    header.encode(out);
    return out.put(body).array();
  }

  /**
   * Ends the server's side, and waits for the client to end its own. Closing at once answers what the client
   * still sends with a reset, which may arrive before the client has read the end.
   */
  void finish() throws IOException {
    socket.shutdownOutput();
    socket.getInputStream().transferTo(OutputStream.nullOutputStream());
  }

  /** Closes the connection at once: what the client sends from now on is answered with a reset. */
  void leave() throws IOException {
    throw new IOException("the script has ended");
  }

  /**
   * Acknowledges what every client requests (modes, opening, closing) and leaves the rest to {@code rounds}.
   */
  void serve(Rounds rounds) throws IOException {
    for (Message message = receive(); message != null; message = receive()) {
      int subtype = message.header().subtype();
      boolean common = message.header().interfaceCode() == PlayerMessages.CODE;
      if (common && subtype == PlayerMessages.REQ_DEV.subtype()) {
        answer(message, message.body());
      } else if (common && subtype == PlayerMessages.REQ_DATAMODE.subtype()) {
        answer(message);
      } else {
        rounds.answer(this, message);
      }
    }
  }
}
