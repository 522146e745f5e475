// Generated from interfaces/045_log.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface log, code 45. Records data of devices to a file, or plays back such a file. */
public final class LogMessages {
  /** The interface's code. */
  public static final int CODE = 45;

  // Values of GetState.type.
  public static final int TYPE_READ = 1;
  public static final int TYPE_WRITE = 2;

  /**
   * Whether data is being recorded. (player_log_set_write_state_t)
   *
   * @param state 1: on, 0: off.
   */
  public record SetWriteState(int state) implements Struct {
    /** Every number 0, every list empty. */
    public SetWriteState() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetWriteState decode(byte[] body) {
      return Reader.decode("log.SetWriteState", body, SetWriteState::read);
    }

    static SetWriteState read(Reader in) {
      int state = in.uint8();
      return new SetWriteState(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /**
   * Whether the file is being played. (player_log_set_read_state_t)
   *
   * @param state 1: on, 0: off.
   */
  public record SetReadState(int state) implements Struct {
    /** Every number 0, every list empty. */
    public SetReadState() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetReadState decode(byte[] body) {
      return Reader.decode("log.SetReadState", body, SetReadState::read);
    }

    static SetReadState read(Reader in) {
      int state = in.uint8();
      return new SetReadState(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /**
   * Type and state of the device. (player_log_get_state_t)
   *
   * @param type Reader or writer.
   * @param state 1: running, 0: stopped.
   */
  public record GetState(int type, int state) implements Struct {
    /** Every number 0, every list empty. */
    public GetState() {
      this(0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static GetState decode(byte[] body) {
      return Reader.decode("log.GetState", body, GetState::read);
    }

    static GetState read(Reader in) {
      int type = in.uint8();
      int state = in.uint8();
      return new GetState(type, state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(type);
      out.uint8(state);
    }
  }

  /**
   * The file to write to. (player_log_set_filename_t)
   *
   * @param filename NUL-terminated.
   */
  public record SetFilename(byte[] filename) implements Struct {
    /** Every number 0, every list empty. */
    public SetFilename() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetFilename decode(byte[] body) {
      return Reader.decode("log.SetFilename", body, SetFilename::read);
    }

    static SetFilename read(Reader in) {
      in.uint32();
      byte[] filename = in.bytes(in.length("filename", 256, 1));
      return new SetFilename(filename);
    }

    @Override
    public void write(Writer out) {
      out.length("filename", filename.length, 256);
      out.length("filename", filename.length, 256);
      out.bytes(filename);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof SetFilename that && Arrays.equals(filename, that.filename);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(filename);
    }
  }

  /** Starts or stops writing. */
  public static final MessageType<SetWriteState> REQ_SET_WRITE_STATE =
      new MessageType<>(45, Kind.REQ, 1, "log.req.set_write_state", SetWriteState::decode);

  /** Starts or stops playing. */
  public static final MessageType<SetReadState> REQ_SET_READ_STATE =
      new MessageType<>(45, Kind.REQ, 2, "log.req.set_read_state", SetReadState::decode);

  /** Requests the type and state of the device. */
  public static final MessageType<GetState> REQ_GET_STATE =
      new MessageType<>(45, Kind.REQ, 3, "log.req.get_state", GetState::decode);

  /** Rewinds to the start of the file. */
  public static final MessageType<Nothing> REQ_SET_READ_REWIND =
      new MessageType<>(45, Kind.REQ, 4, "log.req.set_read_rewind", null);

  /** Sets the file to write to. */
  public static final MessageType<SetFilename> REQ_SET_FILENAME =
      new MessageType<>(45, Kind.REQ, 5, "log.req.set_filename", SetFilename::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_SET_WRITE_STATE, REQ_SET_READ_STATE, REQ_GET_STATE, REQ_SET_READ_REWIND, REQ_SET_FILENAME);

  private LogMessages() {}
}
