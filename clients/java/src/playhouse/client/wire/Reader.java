package playhouse.client.wire;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import playhouse.client.WireException;

/**
 * Reads values from a body, front to back. Bytes that are missing, and lists longer than the rest, throw
 * WireException.
 */
public final class Reader {
  private final ByteBuffer in;

  public Reader(byte[] body) {
    in = ByteBuffer.wrap(body);
  }

  /** Decodes a whole body; {@code name} is that of the struct in errors. */
  static <T> T decode(String name, byte[] body, Function<Reader, T> read) {
    try {
      return read.apply(new Reader(body));
    } catch (WireException error) {
      throw new WireException(name + ": " + error.getMessage());
    }
  }

  public int uint8() {
    return int32() & 0xFF;
  }

  public int int8() {
    return (byte) int32();
  }

  public int uint16() {
    return int32() & 0xFFFF;
  }

  public int int16() {
    return (short) int32();
  }

  public long uint32() {
    return Integer.toUnsignedLong(int32());
  }

  public int int32() {
    return take(4).getInt();
  }

  public long int64() {
    return take(8).getLong();
  }

  public float float32() {
    return take(4).getFloat();
  }

  public double float64() {
    return take(8).getDouble();
  }

  /** Raw bytes, and the zeros up to the end of their last word. */
  public byte[] bytes(int count) {
    int padded = (count + 3) & ~3;
    take(padded);
    byte[] out = new byte[count];
    in.get(in.position(), out);
    return skipped(out, padded);
  }

  public int[] int32s(int count) {
    take(4L * count);
    int[] out = new int[count];
    in.asIntBuffer().get(out);
    return skipped(out, 4 * count);
  }

  public long[] uint32s(int count) {
    int[] signed = int32s(count);
    long[] out = new long[count];
    for (int i = 0; i < count; ++i) {
      out[i] = Integer.toUnsignedLong(signed[i]);
    }
    return out;
  }

  public float[] float32s(int count) {
    take(4L * count);
    float[] out = new float[count];
    in.asFloatBuffer().get(out);
    return skipped(out, 4 * count);
  }

  public double[] float64s(int count) {
    take(8L * count);
    double[] out = new double[count];
    in.asDoubleBuffer().get(out);
    return skipped(out, 8 * count);
  }

  <T> List<T> structs(int count, Function<Reader, T> read) {
    List<T> out = new ArrayList<>(count);
    for (int i = 0; i < count; ++i) {
      out.add(read.apply(this));
    }
    return Collections.unmodifiableList(out);
  }

  /**
   * The length before the elements of a list: at most {@code limit}, each element at least {@code least}
   * bytes.
   */
  public int length(String name, long limit, int least) {
    long count = uint32();
    if (count > limit) {
      throw new WireException(at() + name + " has a length of " + count + ", over its limit of " + limit);
    }
    if (count * least > in.remaining()) {
      throw new WireException(
          at() + name + " claims " + count + " elements, but " + in.remaining() + " bytes are left");
    }
    return (int) count;
  }

  private ByteBuffer take(long size) {
    if (size > in.remaining()) {
      throw new WireException(at() + size + " bytes expected, " + in.remaining() + " are left");
    }
    return in;
  }

  private <T> T skipped(T value, int bytes) {
    in.position(in.position() + bytes);
    return value;
  }

  private String at() {
    return "byte " + in.position() + ": ";
  }
}
