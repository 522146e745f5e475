// Generated from interfaces/050_speech_recognition.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface speech_recognition, code 50. Reports recognised speech. */
public final class SpeechRecognitionMessages {
  /** The interface's code. */
  public static final int CODE = 50;

  /**
   * Recognised speech. (player_speech_recognition_data_t)
   *
   * @param text NUL-terminated.
   */
  public record Data(byte[] text) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("speech_recognition.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long textCount = in.uint32();
      byte[] text = in.bytes(in.length("text", textCount, 1));
      return new Data(text);
    }

    @Override
    public void write(Writer out) {
      out.length("text", text.length, 33554392);
      out.length("text", text.length, 33554392);
      out.bytes(text);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(text, that.text);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(text);
    }
  }

  /** Recognised words. */
  public static final MessageType<Data> DATA_STRING =
      new MessageType<>(50, Kind.DATA, 1, "speech_recognition.data.string", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STRING);

  private SpeechRecognitionMessages() {}
}
