/**
 * Interface log, code 45. Records data of devices to a file, or plays back such a file.
 *
 * Generated from interfaces/045_log.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 45;

// Values of GetState.type.
export const TYPE_READ = 1;
export const TYPE_WRITE = 2;

/** Whether data is being recorded. (player_log_set_write_state_t) */
export interface SetWriteState {
  /** 1: on, 0: off. */
  state: number;
}

export const SetWriteState: Codec<SetWriteState> = new Codec<SetWriteState>('log.SetWriteState', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Whether the file is being played. (player_log_set_read_state_t) */
export interface SetReadState {
  /** 1: on, 0: off. */
  state: number;
}

export const SetReadState: Codec<SetReadState> = new Codec<SetReadState>('log.SetReadState', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint8(value.state);
  },
  read(from) {
    const state = from.uint8();
    return { state };
  },
});

/** Type and state of the device. (player_log_get_state_t) */
export interface GetState {
  /** Reader or writer. */
  type: number;
  /** 1: running, 0: stopped. */
  state: number;
}

export const GetState: Codec<GetState> = new Codec<GetState>('log.GetState', {
  zero: () => ({ type: 0, state: 0 }),
  write(to, value) {
    to.uint8(value.type);
    to.uint8(value.state);
  },
  read(from) {
    const type = from.uint8();
    const state = from.uint8();
    return { type, state };
  },
});

/** The file to write to. (player_log_set_filename_t) */
export interface SetFilename {
  /** NUL-terminated. */
  filename: Uint8Array;
}

export const SetFilename: Codec<SetFilename> = new Codec<SetFilename>('log.SetFilename', {
  zero: () => ({ filename: new Uint8Array() }),
  write(to, value) {
    to.length('filename', value.filename.length, 256);
    to.length('filename', value.filename.length, 256);
    to.opaque(value.filename);
  },
  read(from) {
    from.uint32();
    const filename = from.opaque(from.length('filename', 256, 1));
    return { filename };
  },
});

/** Starts or stops writing. */
export const REQ_SET_WRITE_STATE: MessageType<SetWriteState> = new MessageType(
  45,
  Kind.REQ,
  1,
  'log.req.set_write_state',
  SetWriteState,
);

/** Starts or stops playing. */
export const REQ_SET_READ_STATE: MessageType<SetReadState> = new MessageType(
  45,
  Kind.REQ,
  2,
  'log.req.set_read_state',
  SetReadState,
);

/** Requests the type and state of the device. */
export const REQ_GET_STATE: MessageType<GetState> = new MessageType(45, Kind.REQ, 3, 'log.req.get_state', GetState);

/** Rewinds to the start of the file. */
export const REQ_SET_READ_REWIND: MessageType<undefined> = new MessageType(45, Kind.REQ, 4, 'log.req.set_read_rewind');

/** Sets the file to write to. */
export const REQ_SET_FILENAME: MessageType<SetFilename> = new MessageType(
  45,
  Kind.REQ,
  5,
  'log.req.set_filename',
  SetFilename,
);
