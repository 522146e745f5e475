// Generated from interfaces/049_joystick.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface joystick, code 49. A joystick or gamepad. */
public final class JoystickMessages {
  /** The interface's code. */
  public static final int CODE = 49;

  /**
   * Sticks and buttons. (player_joystick_data_t)
   *
   * @param pos One per axis, from -scale to scale (8 elements).
   * @param scale Maximum value per axis (8 elements).
   * @param buttons One bit per button, the first in the lowest bit.
   * @param axesCount Number of axes.
   */
  public record Data(int[] pos, int[] scale, long buttons, long axesCount) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new int[8], new int[8], 0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("joystick.Data", body, Data::read);
    }

    static Data read(Reader in) {
      int[] pos = in.int32s(8);
      int[] scale = in.int32s(8);
      long buttons = in.uint32();
      long axesCount = in.uint32();
      return new Data(pos, scale, buttons, axesCount);
    }

    @Override
    public void write(Writer out) {
      out.exactly("pos", pos.length, 8);
      out.int32s(pos);
      out.exactly("scale", scale.length, 8);
      out.int32s(scale);
      out.uint32(buttons);
      out.uint32(axesCount);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(pos, that.pos) && Arrays.equals(scale, that.scale)
          && buttons == that.buttons && axesCount == that.axesCount;
    }

    @Override
    public int hashCode() {
      return Objects.hash(buttons, axesCount, Arrays.hashCode(pos), Arrays.hashCode(scale));
    }
  }

  /** Sticks and buttons. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(49, Kind.DATA, 1, "joystick.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE);

  private JoystickMessages() {}
}
