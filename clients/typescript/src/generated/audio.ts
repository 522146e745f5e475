/**
 * Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels.
 *
 * Generated from interfaces/009_audio.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 9;

// Bits of State.state.
export const STATE_STOPPED = 0;
export const STATE_PLAYING = 1;
export const STATE_RECORDING = 2;

// Mask of the bits of Wav.format that describe raw sound.
export const DESCRIPTION_BITS = 255;

// Bits per value of raw sound: mask and values.
export const BITS = 3;
export const AUDIO_8BIT = 0;
export const AUDIO_16BIT = 1;
export const AUDIO_24BIT = 2;

// Channels of raw sound.
export const MONO = 0;
export const STEREO = 4;

// Sampling rate of raw sound: mask and values.
export const FREQ = 24;
export const FREQ_44k = 0;
export const FREQ_11k = 8;
export const FREQ_22k = 16;
export const FREQ_48k = 24;

// Kind of sound data: mask and values.
export const FORMAT_BITS = 65280;
export const FORMAT_NULL = 0;
export const FORMAT_RAW = 256;
export const FORMAT_MP3 = 512;
export const FORMAT_OGG = 768;
export const FORMAT_FLAC = 1024;
export const FORMAT_AAC = 1280;

// Bits of MixerChannelDetail.caps.
export const MIXER_CHANNEL_TYPE_INPUT = 1;
export const MIXER_CHANNEL_TYPE_OUTPUT = 2;
export const MIXER_CHANNEL_TYPE_SPECIAL = 4;

/** A sound. (player_audio_wav_t) */
export interface Wav {
  /** The sound, in the format of `format`. */
  data: Uint8Array;
  /** Kind, rate, channels and bits in one number. */
  format: number;
}

export const Wav: Codec<Wav> = new Codec<Wav>('audio.Wav', {
  zero: () => ({ data: new Uint8Array(), format: 0 }),
  write(to, value) {
    to.length('data', value.data.length, 33554392);
    to.length('data', value.data.length, 33554392);
    to.opaque(value.data);
    to.uint32(value.format);
  },
  read(from) {
    const dataCount = from.uint32();
    const data = from.opaque(from.length('data', dataCount, 1));
    const format = from.uint32();
    return { data, format };
  },
});

/** One tone. (player_audio_seq_item_t) */
export interface SeqItem {
  /** In Hz. */
  freq: number;
  /** In s. */
  duration: number;
  /** 0: silent, to 1: full volume. */
  amplitude: number;
  /** On: joined to the next tone without a gap. */
  link: common.Bool;
}

export const SeqItem: Codec<SeqItem> = new Codec<SeqItem>('audio.SeqItem', {
  zero: () => ({ freq: 0, duration: 0, amplitude: 0, link: common.Bool.make() }),
  write(to, value) {
    to.float32(value.freq);
    to.float32(value.duration);
    to.float32(value.amplitude);
    common.Bool.write(to, value.link);
  },
  read(from) {
    const freq = from.float32();
    const duration = from.float32();
    const amplitude = from.float32();
    const link = common.Bool.read(from);
    return { freq, duration, amplitude, link };
  },
});

/** A sequence of tones. (player_audio_seq_t) */
export interface Seq {
  tones: SeqItem[];
}

export const Seq: Codec<Seq> = new Codec<Seq>('audio.Seq', {
  zero: () => ({ tones: [] }),
  write(to, value) {
    to.length('tones', value.tones.length, 2097149);
    to.length('tones', value.tones.length, 2097149);
    for (const each of value.tones) SeqItem.write(to, each);
  },
  read(from) {
    const tonesCount = from.uint32();
    const tones = from.many(from.length('tones', tonesCount, 16), () => SeqItem.read(from));
    return { tones };
  },
});

/** Level of one channel. (player_audio_mixer_channel_t) */
export interface MixerChannel {
  /** 0: silent, to 1: full volume. */
  amplitude: number;
  /** Off: muted. */
  active: common.Bool;
  /** Index of the channel. */
  index: number;
}

export const MixerChannel: Codec<MixerChannel> = new Codec<MixerChannel>('audio.MixerChannel', {
  zero: () => ({ amplitude: 0, active: common.Bool.make(), index: 0 }),
  write(to, value) {
    to.float32(value.amplitude);
    common.Bool.write(to, value.active);
    to.uint32(value.index);
  },
  read(from) {
    const amplitude = from.float32();
    const active = common.Bool.read(from);
    const index = from.uint32();
    return { amplitude, active, index };
  },
});

/** Levels of some channels. (player_audio_mixer_channel_list_t) */
export interface MixerChannelList {
  channels: MixerChannel[];
}

export const MixerChannelList: Codec<MixerChannelList> = new Codec<MixerChannelList>('audio.MixerChannelList', {
  zero: () => ({ channels: [] }),
  write(to, value) {
    to.length('channels', value.channels.length, 2796199);
    to.length('channels', value.channels.length, 2796199);
    for (const each of value.channels) MixerChannel.write(to, each);
  },
  read(from) {
    const channelsCount = from.uint32();
    const channels = from.many(from.length('channels', channelsCount, 12), () => MixerChannel.read(from));
    return { channels };
  },
});

/** Description of a channel. (player_audio_mixer_channel_detail_t) */
export interface MixerChannelDetail {
  name: Uint8Array;
  /** Input, output or special. */
  caps: number;
}

export const MixerChannelDetail: Codec<MixerChannelDetail> = new Codec<MixerChannelDetail>('audio.MixerChannelDetail', {
  zero: () => ({ name: new Uint8Array(), caps: 0 }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    to.uint8(value.caps);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const caps = from.uint8();
    return { name, caps };
  },
});

/** List of channels. (player_audio_mixer_channel_list_detail_t) */
export interface MixerChannelListDetail {
  details: MixerChannelDetail[];
  /** Index of the channel that plays; -1 none. */
  defaultOutput: number;
  /** Index of the channel that records; -1 none. */
  defaultInput: number;
}

export const MixerChannelListDetail: Codec<MixerChannelListDetail> = new Codec<MixerChannelListDetail>('audio.MixerChannelListDetail', {
  zero: () => ({ details: [], defaultOutput: 0, defaultInput: 0 }),
  write(to, value) {
    to.length('details', value.details.length, 2796199);
    to.length('details', value.details.length, 2796199);
    for (const each of value.details) MixerChannelDetail.write(to, each);
    to.int32(value.defaultOutput);
    to.int32(value.defaultInput);
  },
  read(from) {
    const detailsCount = from.uint32();
    const details = from.many(from.length('details', detailsCount, 12), () => MixerChannelDetail.read(from));
    const defaultOutput = from.int32();
    const defaultInput = from.int32();
    return { details, defaultOutput, defaultInput };
  },
});

/** A sample and its index in the store. (player_audio_sample_t) */
export interface Sample {
  sample: Wav;
  /** Index in the store; -1: chosen by the driver when loading. */
  index: number;
}

export const Sample: Codec<Sample> = new Codec<Sample>('audio.Sample', {
  zero: () => ({ sample: Wav.make(), index: 0 }),
  write(to, value) {
    Wav.write(to, value.sample);
    to.int32(value.index);
  },
  read(from) {
    const sample = Wav.read(from);
    const index = from.int32();
    return { sample, index };
  },
});

/** An index in the store. (player_audio_sample_item_t) */
export interface SampleItem {
  index: number;
}

export const SampleItem: Codec<SampleItem> = new Codec<SampleItem>('audio.SampleItem', {
  zero: () => ({ index: 0 }),
  write(to, value) {
    to.int32(value.index);
  },
  read(from) {
    const index = from.int32();
    return { index };
  },
});

/** Request to record into the store. (player_audio_sample_rec_req_t) */
export interface SampleRecReq {
  /** Index in the store; -1: chosen by the driver. */
  index: number;
  /** In ms. */
  length: number;
}

export const SampleRecReq: Codec<SampleRecReq> = new Codec<SampleRecReq>('audio.SampleRecReq', {
  zero: () => ({ index: 0, length: 0 }),
  write(to, value) {
    to.int32(value.index);
    to.uint32(value.length);
  },
  read(from) {
    const index = from.int32();
    const length = from.uint32();
    return { index, length };
  },
});

/** State of the device. (player_audio_state_t) */
export interface State {
  /** Playing, recording, both or neither. */
  state: number;
}

export const State: Codec<State> = new Codec<State>('audio.State', {
  zero: () => ({ state: 0 }),
  write(to, value) {
    to.uint32(value.state);
  },
  read(from) {
    const state = from.uint32();
    return { state };
  },
});

/** Recorded sound. */
export const DATA_WAV_REC: MessageType<Wav> = new MessageType(9, Kind.DATA, 1, 'audio.data.wav_rec', Wav);

/** Detected tones. */
export const DATA_SEQ: MessageType<Seq> = new MessageType(9, Kind.DATA, 2, 'audio.data.seq', Seq);

/** Levels of the mixer, sent on change. */
export const DATA_MIXER_CHANNEL: MessageType<MixerChannelList> = new MessageType(
  9,
  Kind.DATA,
  3,
  'audio.data.mixer_channel',
  MixerChannelList,
);

/** State of the device. */
export const DATA_STATE: MessageType<State> = new MessageType(9, Kind.DATA, 4, 'audio.data.state', State);

/** Plays sound. */
export const CMD_WAV_PLAY: MessageType<Wav> = new MessageType(9, Kind.CMD, 1, 'audio.cmd.wav_play', Wav);

/** Starts or stops sending recorded sound. */
export const CMD_WAV_STREAM_REC: MessageType<common.Bool> = new MessageType(
  9,
  Kind.CMD,
  2,
  'audio.cmd.wav_stream_rec',
  common.Bool,
);

/** Plays a stored sample. */
export const CMD_SAMPLE_PLAY: MessageType<SampleItem> = new MessageType(
  9,
  Kind.CMD,
  3,
  'audio.cmd.sample_play',
  SampleItem,
);

/** Plays tones. */
export const CMD_SEQ_PLAY: MessageType<Seq> = new MessageType(9, Kind.CMD, 4, 'audio.cmd.seq_play', Seq);

/** Sets levels of the mixer. */
export const CMD_MIXER_CHANNEL: MessageType<MixerChannelList> = new MessageType(
  9,
  Kind.CMD,
  5,
  'audio.cmd.mixer_channel',
  MixerChannelList,
);

/** Records sound. */
export const REQ_WAV_REC: MessageType<Wav> = new MessageType(9, Kind.REQ, 1, 'audio.req.wav_rec', Wav);

/** Stores a sample. */
export const REQ_SAMPLE_LOAD: MessageType<Sample> = new MessageType(9, Kind.REQ, 2, 'audio.req.sample_load', Sample);

/** Fetches a stored sample. */
export const REQ_SAMPLE_RETRIEVE: MessageType<Sample> = new MessageType(
  9,
  Kind.REQ,
  3,
  'audio.req.sample_retrieve',
  Sample,
);

/** Records a sample into the store. */
export const REQ_SAMPLE_REC: MessageType<SampleItem> = new MessageType(
  9,
  Kind.REQ,
  4,
  'audio.req.sample_rec',
  SampleItem,
);

/** Requests the channels of the mixer. */
export const REQ_MIXER_CHANNEL_LIST: MessageType<MixerChannelListDetail> = new MessageType(
  9,
  Kind.REQ,
  5,
  'audio.req.mixer_channel_list',
  MixerChannelListDetail,
);

/** Requests the levels of the mixer. */
export const REQ_MIXER_CHANNEL_LEVEL: MessageType<MixerChannelList> = new MessageType(
  9,
  Kind.REQ,
  6,
  'audio.req.mixer_channel_level',
  MixerChannelList,
);
