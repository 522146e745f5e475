package playhouse.client.wire;

import java.nio.ByteBuffer;

/**
 * The 40 bytes before every body.
 *
 * @param interfaceCode Code of an interface, 16 bits.
 * @param index Index of a device, 16 bits.
 * @param kind Number of a {@link Kind}, 8 bits; of a hostile peer any other.
 * @param subtype Which message of that kind, 8 bits.
 * @param timestamp In s.
 * @param sequence Echoed in answers, 32 bits.
 * @param size Length of the body in bytes, from 0 to 2^32 - 1.
 * @param host Address of the sender's machine; not used.
 * @param robot TCP port of the server.
 */
public record Header(
    int interfaceCode, int index, int kind, int subtype, double timestamp, int sequence, long size, int host,
    int robot) {
  public static final int BYTES = 40;

  /** The largest body, in bytes. */
  public static final int MAX_BODY_BYTES = 33554432 - BYTES;

  /** Reads 40 bytes; narrow fields keep their low bits only, as in every Player receiver. */
  public static Header decode(ByteBuffer in) {
    int host = in.getInt();
    int robot = in.getInt();
    int interfaceCode = in.getInt() & 0xFFFF;
    int index = in.getInt() & 0xFFFF;
    int kind = in.getInt() & 0xFF;
    int subtype = in.getInt() & 0xFF;
    double timestamp = in.getDouble();
    int sequence = in.getInt();
    long size = Integer.toUnsignedLong(in.getInt());
    return new Header(interfaceCode, index, kind, subtype, timestamp, sequence, size, host, robot);
  }

  /** Writes 40 bytes. */
  public void encode(ByteBuffer out) {
    out.putInt(host).putInt(robot).putInt(interfaceCode).putInt(index).putInt(kind).putInt(subtype);
    out.putDouble(timestamp).putInt(sequence).putInt((int) size);
  }

  /** Whether the message is of this kind. */
  public boolean is(Kind wanted) {
    return kind == wanted.code();
  }

  /** Whether it is an answer: an ACK or a NACK. */
  public boolean isAnswer() {
    return is(Kind.ACK) || is(Kind.NACK);
  }
}
