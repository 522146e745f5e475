package playhouse.client;

import playhouse.client.wire.SpeechMessages;
import playhouse.client.wire.Text;

/** Speech output of a robot. */
public final class Speech extends Device {
  Speech(Opening opening) {
    super(opening);
  }

  /** Sets the text that the robot says, replacing the previous one; "": none. */
  public void say(String text) {
    command(SpeechMessages.CMD_SAY, new SpeechMessages.Cmd(Text.field(text)));
  }
}
