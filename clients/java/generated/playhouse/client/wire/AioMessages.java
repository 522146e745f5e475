// Generated from interfaces/021_aio.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface aio, code 21. Analog inputs and outputs. */
public final class AioMessages {
  /** The interface's code. */
  public static final int CODE = 21;

  /**
   * Voltages of the inputs. (player_aio_data_t)
   *
   * @param voltages In V.
   */
  public record Data(float[] voltages) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("aio.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long voltagesCount = in.uint32();
      float[] voltages = in.float32s(in.length("voltages", voltagesCount, 4));
      return new Data(voltages);
    }

    @Override
    public void write(Writer out) {
      out.length("voltages", voltages.length, 8388598);
      out.length("voltages", voltages.length, 8388598);
      out.float32s(voltages);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(voltages, that.voltages);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(voltages);
    }
  }

  /**
   * Commanded voltage of one output. (player_aio_cmd_t)
   *
   * @param id Index of the output.
   * @param voltage In V.
   */
  public record Cmd(long id, float voltage) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0L, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("aio.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      long id = in.uint32();
      float voltage = in.float32();
      return new Cmd(id, voltage);
    }

    @Override
    public void write(Writer out) {
      out.uint32(id);
      out.float32(voltage);
    }
  }

  /** Commanded voltage of one output. */
  public static final MessageType<Cmd> CMD_STATE =
      new MessageType<>(21, Kind.CMD, 1, "aio.cmd.state", Cmd::decode);

  /** Voltages of the inputs. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(21, Kind.DATA, 1, "aio.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      CMD_STATE, DATA_STATE);

  private AioMessages() {}
}
