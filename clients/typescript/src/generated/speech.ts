/**
 * Interface speech, code 12. Speaks text.
 *
 * Generated from interfaces/012_speech.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 12;

/** A text to speak. (player_speech_cmd_t) */
export interface Cmd {
  /** NUL-terminated. */
  string: Uint8Array;
}

export const Cmd: Codec<Cmd> = new Codec<Cmd>('speech.Cmd', {
  zero: () => ({ string: new Uint8Array() }),
  write(to, value) {
    to.length('string', value.string.length, 33554392);
    to.length('string', value.string.length, 33554392);
    to.opaque(value.string);
  },
  read(from) {
    const stringCount = from.uint32();
    const string = from.opaque(from.length('string', stringCount, 1));
    return { string };
  },
});

/** Speaks a text; texts are spoken one after the other. */
export const CMD_SAY: MessageType<Cmd> = new MessageType(12, Kind.CMD, 1, 'speech.cmd.say', Cmd);
