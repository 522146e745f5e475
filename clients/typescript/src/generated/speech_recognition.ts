/**
 * Interface speech_recognition, code 50. Reports recognised speech.
 *
 * Generated from interfaces/050_speech_recognition.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 50;

/** Recognised speech. (player_speech_recognition_data_t) */
export interface Data {
  /** NUL-terminated. */
  text: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('speech_recognition.Data', {
  zero: () => ({ text: new Uint8Array() }),
  write(to, value) {
    to.length('text', value.text.length, 33554392);
    to.length('text', value.text.length, 33554392);
    to.opaque(value.text);
  },
  read(from) {
    const textCount = from.uint32();
    const text = from.opaque(from.length('text', textCount, 1));
    return { text };
  },
});

/** Recognised words. */
export const DATA_STRING: MessageType<Data> = new MessageType(50, Kind.DATA, 1, 'speech_recognition.data.string', Data);
