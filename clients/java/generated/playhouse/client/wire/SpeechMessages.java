// Generated from interfaces/012_speech.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface speech, code 12. Speaks text. */
public final class SpeechMessages {
  /** The interface's code. */
  public static final int CODE = 12;

  /**
   * A text to speak. (player_speech_cmd_t)
   *
   * @param string NUL-terminated.
   */
  public record Cmd(byte[] string) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("speech.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      long stringCount = in.uint32();
      byte[] string = in.bytes(in.length("string", stringCount, 1));
      return new Cmd(string);
    }

    @Override
    public void write(Writer out) {
      out.length("string", string.length, 33554392);
      out.length("string", string.length, 33554392);
      out.bytes(string);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Cmd that && Arrays.equals(string, that.string);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(string);
    }
  }

  /** Speaks a text; texts are spoken one after the other. */
  public static final MessageType<Cmd> CMD_SAY =
      new MessageType<>(12, Kind.CMD, 1, "speech.cmd.say", Cmd::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      CMD_SAY);

  private SpeechMessages() {}
}
