// Generated from interfaces/020_dio.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface dio, code 20. Digital inputs and outputs. */
public final class DioMessages {
  /** The interface's code. */
  public static final int CODE = 20;

  /**
   * State of the inputs. (player_dio_data_t)
   *
   * @param count Number of valid bits.
   * @param bits One bit per input, the first in the lowest bit.
   */
  public record Data(long count, long bits) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("dio.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long count = in.uint32();
      long bits = in.uint32();
      return new Data(count, bits);
    }

    @Override
    public void write(Writer out) {
      out.uint32(count);
      out.uint32(bits);
    }
  }

  /**
   * Commanded state of the outputs. (player_dio_cmd_t)
   *
   * @param count Number of valid bits.
   * @param digout One bit per output, the first in the lowest bit.
   */
  public record Cmd(long count, long digout) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("dio.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      long count = in.uint32();
      long digout = in.uint32();
      return new Cmd(count, digout);
    }

    @Override
    public void write(Writer out) {
      out.uint32(count);
      out.uint32(digout);
    }
  }

  /** State of the inputs. */
  public static final MessageType<Data> DATA_VALUES =
      new MessageType<>(20, Kind.DATA, 1, "dio.data.values", Data::decode);

  /** Commanded state of the outputs. */
  public static final MessageType<Cmd> CMD_VALUES =
      new MessageType<>(20, Kind.CMD, 1, "dio.cmd.values", Cmd::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_VALUES, CMD_VALUES);

  private DioMessages() {}
}
