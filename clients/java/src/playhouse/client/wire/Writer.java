package playhouse.client.wire;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import playhouse.client.WireException;

/** Appends values to a body. A value outside the range of its field throws WireException. */
public final class Writer {
  private static final long UINT32_MAX = 0xFFFFFFFFL;

  private ByteBuffer out = ByteBuffer.allocate(64);

  public Writer() {}

  /** What has been written. */
  public byte[] bytes() {
    return Arrays.copyOf(out.array(), out.position());
  }

  public void uint8(int value) {
    room(4).putInt((int) checked(value, 0, 0xFF));
  }

  public void int8(int value) {
    room(4).putInt((int) checked(value, Byte.MIN_VALUE, Byte.MAX_VALUE));
  }

  public void uint16(int value) {
    room(4).putInt((int) checked(value, 0, 0xFFFF));
  }

  public void int16(int value) {
    room(4).putInt((int) checked(value, Short.MIN_VALUE, Short.MAX_VALUE));
  }

  public void uint32(long value) {
    room(4).putInt((int) checked(value, 0, UINT32_MAX));
  }

  public void int32(int value) {
    room(4).putInt(value);
  }

  public void int64(long value) {
    room(8).putLong(value);
  }

  public void float32(float value) {
    room(4).putFloat(value);
  }

  public void float64(double value) {
    room(8).putDouble(value);
  }

  /** Raw bytes, and zeros up to the end of their last word. */
  public void bytes(byte[] values) {
    fill(values, (values.length + 3L) / 4 * 4);
  }

  /**
   * Exactly {@code size} bytes, of which zeros fill what is missing, and zeros up to the end of their last
   * word.
   */
  public void fixed(String name, byte[] values, int size) {
    if (values.length > size) {
      throw new WireException(name + " has " + values.length + " bytes, over its " + size);
    }
    fill(values, (size + 3L) / 4 * 4);
  }

  public void int32s(int[] values) {
    room(4L * values.length).asIntBuffer().put(values);
    skip(4 * values.length);
  }

  public void uint32s(long[] values) {
    for (long value : values) {
      uint32(value);
    }
  }

  public void float32s(float[] values) {
    room(4L * values.length).asFloatBuffer().put(values);
    skip(4 * values.length);
  }

  public void float64s(double[] values) {
    room(8L * values.length).asDoubleBuffer().put(values);
    skip(8 * values.length);
  }

  void structs(List<? extends Struct> values) {
    for (Struct value : values) {
      value.write(this);
    }
  }

  /** A count or length word before a list of at most {@code limit} elements. */
  public void length(String name, int count, int limit) {
    if (count > limit) {
      throw new WireException(name + " has " + count + " elements, over its limit of " + limit);
    }
    int32(count);
  }

  /** Checks a list of fixed length, which is encoded without a length word. */
  public void exactly(String name, int count, int wanted) {
    if (count != wanted) {
      throw new WireException(name + " has " + count + " elements instead of " + wanted);
    }
  }

  private static long checked(long value, long low, long high) {
    if (value < low || value > high) {
      throw new WireException(value + " is outside [" + low + ", " + high + "]");
    }
    return value;
  }

  private void fill(byte[] values, long padded) {
    int end = room(padded).position() + (int) padded;
    out.put(values);
    Arrays.fill(out.array(), out.position(), end, (byte) 0);
    out.position(end);
  }

  private void skip(int bytes) {
    out.position(out.position() + bytes);
  }

  private ByteBuffer room(long bytes) {
    if (bytes > out.remaining()) {
      long wanted = Math.max(2L * out.capacity(), out.position() + bytes);
      if (wanted > Integer.MAX_VALUE - 16) {
        throw new WireException("a message of " + (out.position() + bytes) + " bytes is over the wire's limit of "
            + Header.MAX_BODY_BYTES);
      }
      out = ByteBuffer.wrap(Arrays.copyOf(out.array(), (int) wanted)).position(out.position());
    }
    return out;
  }
}
