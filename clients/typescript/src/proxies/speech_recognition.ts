import type { speech_recognition } from '../generated/index.js';
import { text } from '../text.js';
import { Keeping } from './keeping.js';

/** Speech recognition: texts of other models heard by a robot. */
export class SpeechRecognition extends Keeping<string> {
  /** Messages of read() since the last call, in order. */
  takeTexts(): string[] {
    return this.takeKept();
  }

  protected override meaning(value: unknown): string {
    return text((value as speech_recognition.Data).text);
  }
}
