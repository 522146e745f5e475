// Generated from interfaces/051_opaque.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface opaque, code 51. Opaque bytes, defined by the driver and its clients. */
public final class OpaqueMessages {
  /** The interface's code. */
  public static final int CODE = 51;

  // Subtypes under their older names.
  public static final int REQ = 1;
  public static final int CMD = 1;

  /**
   * Opaque bytes. (player_opaque_data_t)
   *
   * @param data Data.
   */
  public record Data(byte[] data) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("opaque.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long dataCount = in.uint32();
      byte[] data = in.bytes(in.length("data", dataCount, 1));
      return new Data(data);
    }

    @Override
    public void write(Writer out) {
      out.length("data", data.length, 33554392);
      out.length("data", data.length, 33554392);
      out.bytes(data);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(data, that.data);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(data);
    }
  }

  /** Bytes from the driver. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(51, Kind.DATA, 1, "opaque.data.state", Data::decode);

  /** Bytes for the driver. */
  public static final MessageType<Data> CMD_DATA =
      new MessageType<>(51, Kind.CMD, 1, "opaque.cmd.data", Data::decode);

  /** Bytes for the driver, which answers with bytes. */
  public static final MessageType<Data> REQ_DATA =
      new MessageType<>(51, Kind.REQ, 1, "opaque.req.data", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, CMD_DATA, REQ_DATA);

  private OpaqueMessages() {}
}
