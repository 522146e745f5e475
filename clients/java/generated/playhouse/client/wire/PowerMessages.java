// Generated from interfaces/002_power.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface power, code 2. Battery and charger of a robot. */
public final class PowerMessages {
  /** The interface's code. */
  public static final int CODE = 2;

  // Bits of Data.valid: valid fields.
  public static final int MASK_VOLTS = 1;
  public static final int MASK_WATTS = 2;
  public static final int MASK_JOULES = 4;
  public static final int MASK_PERCENT = 8;
  public static final int MASK_CHARGING = 16;

  /**
   * State of charge; only the fields flagged in `valid` apply. (player_power_data_t)
   *
   * @param valid Bits of the valid fields.
   * @param volts In V.
   * @param percent Percentage of a full charge, 0 to 100 (in %).
   * @param joules Remaining energy (in J).
   * @param watts Power drawn from the battery; negative while charging (in W).
   * @param charging 1 charging, 0 not, -1 charging is impossible.
   */
  public record Data(
      long valid, float volts, float percent, float joules, float watts, int charging)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0f, 0f, 0f, 0f, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("power.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long valid = in.uint32();
      float volts = in.float32();
      float percent = in.float32();
      float joules = in.float32();
      float watts = in.float32();
      int charging = in.int32();
      return new Data(valid, volts, percent, joules, watts, charging);
    }

    @Override
    public void write(Writer out) {
      out.uint32(valid);
      out.float32(volts);
      out.float32(percent);
      out.float32(joules);
      out.float32(watts);
      out.int32(charging);
    }
  }

  /**
   * Enabled flows of power. (player_power_chargepolicy_config_t)
   *
   * @param enableInput 1: the battery may be charged.
   * @param enableOutput 1: the battery may supply others.
   */
  public record ChargepolicyConfig(int enableInput, int enableOutput) implements Struct {
    /** Every number 0, every list empty. */
    public ChargepolicyConfig() {
      this(0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ChargepolicyConfig decode(byte[] body) {
      return Reader.decode("power.ChargepolicyConfig", body, ChargepolicyConfig::read);
    }

    static ChargepolicyConfig read(Reader in) {
      int enableInput = in.uint8();
      int enableOutput = in.uint8();
      return new ChargepolicyConfig(enableInput, enableOutput);
    }

    @Override
    public void write(Writer out) {
      out.uint8(enableInput);
      out.uint8(enableOutput);
    }
  }

  /** State of charge. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(2, Kind.DATA, 1, "power.data.state", Data::decode);

  /** Enables or disables charging and discharging of the battery. */
  public static final MessageType<ChargepolicyConfig> REQ_SET_CHARGING_POLICY =
      new MessageType<>(2, Kind.REQ, 1, "power.req.set_charging_policy", ChargepolicyConfig::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, REQ_SET_CHARGING_POLICY);

  private PowerMessages() {}
}
