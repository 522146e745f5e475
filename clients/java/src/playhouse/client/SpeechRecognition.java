package playhouse.client;

import java.util.List;
import playhouse.client.wire.SpeechRecognitionMessages;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;

/** Speech recognition: texts of other models heard by a robot. */
public final class SpeechRecognition extends Keeping<String> {
  SpeechRecognition(Opening opening) {
    super(opening);
  }

  /** Messages of read() since the last call, in order. */
  public List<String> takeTexts() {
    return takeKept();
  }

  @Override
  String meaning(Struct value) {
    return Text.of(((SpeechRecognitionMessages.Data) value).text());
  }
}
