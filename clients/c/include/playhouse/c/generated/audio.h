/** Interface audio, code 9. Plays and records sound, samples and tones, and sets mixer levels. Generated
 * from interfaces/009_audio.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_AUDIO_H
#define PLAYHOUSE_C_GENERATED_AUDIO_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_AUDIO_CODE 9

/** Bits of State.state. */
enum {
  PH_AUDIO_STATE_STOPPED = 0,
  PH_AUDIO_STATE_PLAYING = 1,
  PH_AUDIO_STATE_RECORDING = 2,
};

/** Mask of the bits of Wav.format that describe raw sound. */
enum {
  PH_AUDIO_DESCRIPTION_BITS = 255,
};

/** Bits per value of raw sound: mask and values. */
enum {
  PH_AUDIO_BITS = 3,
  PH_AUDIO_8BIT = 0,
  PH_AUDIO_16BIT = 1,
  PH_AUDIO_24BIT = 2,
};

/** Channels of raw sound. */
enum {
  PH_AUDIO_MONO = 0,
  PH_AUDIO_STEREO = 4,
};

/** Sampling rate of raw sound: mask and values. */
enum {
  PH_AUDIO_FREQ = 24,
  PH_AUDIO_FREQ_44k = 0,
  PH_AUDIO_FREQ_11k = 8,
  PH_AUDIO_FREQ_22k = 16,
  PH_AUDIO_FREQ_48k = 24,
};

/** Kind of sound data: mask and values. */
enum {
  PH_AUDIO_FORMAT_BITS = 65280,
  PH_AUDIO_FORMAT_NULL = 0,
  PH_AUDIO_FORMAT_RAW = 256,
  PH_AUDIO_FORMAT_MP3 = 512,
  PH_AUDIO_FORMAT_OGG = 768,
  PH_AUDIO_FORMAT_FLAC = 1024,
  PH_AUDIO_FORMAT_AAC = 1280,
};

/** Bits of MixerChannelDetail.caps. */
enum {
  PH_AUDIO_MIXER_CHANNEL_TYPE_INPUT = 1,
  PH_AUDIO_MIXER_CHANNEL_TYPE_OUTPUT = 2,
  PH_AUDIO_MIXER_CHANNEL_TYPE_SPECIAL = 4,
};

/** A sound. (player_audio_wav_t) */
typedef struct ph_audio_wav {
  /** The sound, in the format of `format`. */
  const uint8_t *data;
  uint32_t data_count;
  /** Kind, rate, channels and bits in one number. */
  uint32_t format;
} ph_audio_wav;
PH_CODEC(ph_audio_wav)

/** One tone. (player_audio_seq_item_t) */
typedef struct ph_audio_seq_item {
  /** In Hz. */
  float freq;
  /** In s. */
  float duration;
  /** 0: silent, to 1: full volume. */
  float amplitude;
  /** On: joined to the next tone without a gap. */
  ph_common_bool link;
} ph_audio_seq_item;
PH_CODEC(ph_audio_seq_item)

/** A sequence of tones. (player_audio_seq_t) */
typedef struct ph_audio_seq {
  const ph_audio_seq_item *tones;
  uint32_t tones_count;
} ph_audio_seq;
PH_CODEC(ph_audio_seq)

/** Level of one channel. (player_audio_mixer_channel_t) */
typedef struct ph_audio_mixer_channel {
  /** 0: silent, to 1: full volume. */
  float amplitude;
  /** Off: muted. */
  ph_common_bool active;
  /** Index of the channel. */
  uint32_t index;
} ph_audio_mixer_channel;
PH_CODEC(ph_audio_mixer_channel)

/** Levels of some channels. (player_audio_mixer_channel_list_t) */
typedef struct ph_audio_mixer_channel_list {
  const ph_audio_mixer_channel *channels;
  uint32_t channels_count;
} ph_audio_mixer_channel_list;
PH_CODEC(ph_audio_mixer_channel_list)

/** Description of a channel. (player_audio_mixer_channel_detail_t) */
typedef struct ph_audio_mixer_channel_detail {
  const char *name;
  uint32_t name_count;
  /** Input, output or special. */
  uint8_t caps;
} ph_audio_mixer_channel_detail;
PH_CODEC(ph_audio_mixer_channel_detail)

/** List of channels. (player_audio_mixer_channel_list_detail_t) */
typedef struct ph_audio_mixer_channel_list_detail {
  const ph_audio_mixer_channel_detail *details;
  uint32_t details_count;
  /** Index of the channel that plays; -1 none. */
  int32_t default_output;
  /** Index of the channel that records; -1 none. */
  int32_t default_input;
} ph_audio_mixer_channel_list_detail;
PH_CODEC(ph_audio_mixer_channel_list_detail)

/** A sample and its index in the store. (player_audio_sample_t) */
typedef struct ph_audio_sample {
  ph_audio_wav sample;
  /** Index in the store; -1: chosen by the driver when loading. */
  int32_t index;
} ph_audio_sample;
PH_CODEC(ph_audio_sample)

/** An index in the store. (player_audio_sample_item_t) */
typedef struct ph_audio_sample_item {
  int32_t index;
} ph_audio_sample_item;
PH_CODEC(ph_audio_sample_item)

/** Request to record into the store. (player_audio_sample_rec_req_t) */
typedef struct ph_audio_sample_rec_req {
  /** Index in the store; -1: chosen by the driver. */
  int32_t index;
  /** In ms. */
  uint32_t length;
} ph_audio_sample_rec_req;
PH_CODEC(ph_audio_sample_rec_req)

/** State of the device. (player_audio_state_t) */
typedef struct ph_audio_state {
  /** Playing, recording, both or neither. */
  uint32_t state;
} ph_audio_state;
PH_CODEC(ph_audio_state)

/** The messages, each under its name below. */
extern const ph_message_type ph_audio_messages[15];
/** Recorded sound. */
#define PH_AUDIO_DATA_WAV_REC (&ph_audio_messages[0])
/** Detected tones. */
#define PH_AUDIO_DATA_SEQ (&ph_audio_messages[1])
/** Levels of the mixer, sent on change. */
#define PH_AUDIO_DATA_MIXER_CHANNEL (&ph_audio_messages[2])
/** State of the device. */
#define PH_AUDIO_DATA_STATE (&ph_audio_messages[3])
/** Plays sound. */
#define PH_AUDIO_CMD_WAV_PLAY (&ph_audio_messages[4])
/** Starts or stops sending recorded sound. */
#define PH_AUDIO_CMD_WAV_STREAM_REC (&ph_audio_messages[5])
/** Plays a stored sample. */
#define PH_AUDIO_CMD_SAMPLE_PLAY (&ph_audio_messages[6])
/** Plays tones. */
#define PH_AUDIO_CMD_SEQ_PLAY (&ph_audio_messages[7])
/** Sets levels of the mixer. */
#define PH_AUDIO_CMD_MIXER_CHANNEL (&ph_audio_messages[8])
/** Records sound. */
#define PH_AUDIO_REQ_WAV_REC (&ph_audio_messages[9])
/** Stores a sample. */
#define PH_AUDIO_REQ_SAMPLE_LOAD (&ph_audio_messages[10])
/** Fetches a stored sample. */
#define PH_AUDIO_REQ_SAMPLE_RETRIEVE (&ph_audio_messages[11])
/** Records a sample into the store. */
#define PH_AUDIO_REQ_SAMPLE_REC (&ph_audio_messages[12])
/** Requests the channels of the mixer. */
#define PH_AUDIO_REQ_MIXER_CHANNEL_LIST (&ph_audio_messages[13])
/** Requests the levels of the mixer. */
#define PH_AUDIO_REQ_MIXER_CHANNEL_LEVEL (&ph_audio_messages[14])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_AUDIO_H */
