// Generated from interfaces/033_blinkenlight.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface blinkenlight, code 33. Lights that can be switched, colored and made to blink. */
public final class BlinkenlightMessages {
  /** The interface's code. */
  public static final int CODE = 33;

  /**
   * State of the light. (player_blinkenlight_data_t)
   *
   * @param enable 1: on, 0: off.
   * @param period Blinking period; 0: steady light (in s).
   * @param dutycycle Duty cycle: fraction of the period in which the light is on, 0 to 1.
   * @param color Color.
   */
  public record Data(
      int enable, float period, float dutycycle, CommonMessages.Color color)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0, 0f, 0f, new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("blinkenlight.Data", body, Data::read);
    }

    static Data read(Reader in) {
      int enable = in.uint8();
      float period = in.float32();
      float dutycycle = in.float32();
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new Data(enable, period, dutycycle, color);
    }

    @Override
    public void write(Writer out) {
      out.uint8(enable);
      out.float32(period);
      out.float32(dutycycle);
      color.write(out);
    }
  }

  /**
   * Commanded state of one light. (player_blinkenlight_cmd_t)
   *
   * @param id Index of the light.
   * @param enable 1: on, 0: off.
   * @param period Blinking period; 0: steady light (in s).
   * @param dutycycle Duty cycle: fraction of the period in which the light is on, 0 to 1.
   * @param color Color.
   */
  public record Cmd(
      int id, int enable, float period, float dutycycle, CommonMessages.Color color)
      implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0, 0, 0f, 0f, new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("blinkenlight.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      int id = in.uint16();
      int enable = in.uint8();
      float period = in.float32();
      float dutycycle = in.float32();
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new Cmd(id, enable, period, dutycycle, color);
    }

    @Override
    public void write(Writer out) {
      out.uint16(id);
      out.uint8(enable);
      out.float32(period);
      out.float32(dutycycle);
      color.write(out);
    }
  }

  /**
   * Switch of one light. (player_blinkenlight_cmd_power_t)
   *
   * @param id Index of the light.
   * @param enable 1: on, 0: off.
   */
  public record CmdPower(int id, int enable) implements Struct {
    /** Every number 0, every list empty. */
    public CmdPower() {
      this(0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPower decode(byte[] body) {
      return Reader.decode("blinkenlight.CmdPower", body, CmdPower::read);
    }

    static CmdPower read(Reader in) {
      int id = in.uint16();
      int enable = in.uint8();
      return new CmdPower(id, enable);
    }

    @Override
    public void write(Writer out) {
      out.uint16(id);
      out.uint8(enable);
    }
  }

  /**
   * Color of one light. (player_blinkenlight_cmd_color_t)
   *
   * @param id Index of the light.
   * @param color Color.
   */
  public record CmdColor(int id, CommonMessages.Color color) implements Struct {
    /** Every number 0, every list empty. */
    public CmdColor() {
      this(0, new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdColor decode(byte[] body) {
      return Reader.decode("blinkenlight.CmdColor", body, CmdColor::read);
    }

    static CmdColor read(Reader in) {
      int id = in.uint16();
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new CmdColor(id, color);
    }

    @Override
    public void write(Writer out) {
      out.uint16(id);
      color.write(out);
    }
  }

  /**
   * Blinking of one light. (player_blinkenlight_cmd_flash_t)
   *
   * @param id Index of the light.
   * @param period Blinking period (in s).
   * @param dutycycle Duty cycle: fraction of the period in which the light is on, 0 to 1.
   */
  public record CmdFlash(int id, float period, float dutycycle) implements Struct {
    /** Every number 0, every list empty. */
    public CmdFlash() {
      this(0, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdFlash decode(byte[] body) {
      return Reader.decode("blinkenlight.CmdFlash", body, CmdFlash::read);
    }

    static CmdFlash read(Reader in) {
      int id = in.uint16();
      float period = in.float32();
      float dutycycle = in.float32();
      return new CmdFlash(id, period, dutycycle);
    }

    @Override
    public void write(Writer out) {
      out.uint16(id);
      out.float32(period);
      out.float32(dutycycle);
    }
  }

  /** State of the light. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(33, Kind.DATA, 1, "blinkenlight.data.state", Data::decode);

  /** Sets all properties of one light. */
  public static final MessageType<Cmd> CMD_STATE =
      new MessageType<>(33, Kind.CMD, 1, "blinkenlight.cmd.state", Cmd::decode);

  /** Switches one light. */
  public static final MessageType<CmdPower> CMD_POWER =
      new MessageType<>(33, Kind.CMD, 2, "blinkenlight.cmd.power", CmdPower::decode);

  /** Colors one light. */
  public static final MessageType<CmdColor> CMD_COLOR =
      new MessageType<>(33, Kind.CMD, 3, "blinkenlight.cmd.color", CmdColor::decode);

  /** Makes one light blink. */
  public static final MessageType<CmdFlash> CMD_FLASH =
      new MessageType<>(33, Kind.CMD, 4, "blinkenlight.cmd.flash", CmdFlash::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, CMD_STATE, CMD_POWER, CMD_COLOR, CMD_FLASH);

  private BlinkenlightMessages() {}
}
