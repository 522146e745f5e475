// Generated from interfaces/009_audio.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Plays and records sound, samples and tones, and sets mixer levels.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::audio {

inline constexpr std::uint16_t kCode = 9;

// Subtypes of messages.
/// Recorded sound.
inline constexpr std::uint8_t kDataWavRec = 1;
/// Detected tones.
inline constexpr std::uint8_t kDataSeq = 2;
/// Levels of the mixer, sent on change.
inline constexpr std::uint8_t kDataMixerChannel = 3;
/// State of the device.
inline constexpr std::uint8_t kDataState = 4;
/// Plays sound.
inline constexpr std::uint8_t kCmdWavPlay = 1;
/// Starts or stops sending recorded sound.
inline constexpr std::uint8_t kCmdWavStreamRec = 2;
/// Plays a stored sample.
inline constexpr std::uint8_t kCmdSamplePlay = 3;
/// Plays tones.
inline constexpr std::uint8_t kCmdSeqPlay = 4;
/// Sets levels of the mixer.
inline constexpr std::uint8_t kCmdMixerChannel = 5;
/// Records sound.
inline constexpr std::uint8_t kReqWavRec = 1;
/// Stores a sample.
inline constexpr std::uint8_t kReqSampleLoad = 2;
/// Fetches a stored sample.
inline constexpr std::uint8_t kReqSampleRetrieve = 3;
/// Records a sample into the store.
inline constexpr std::uint8_t kReqSampleRec = 4;
/// Requests the channels of the mixer.
inline constexpr std::uint8_t kReqMixerChannelList = 5;
/// Requests the levels of the mixer.
inline constexpr std::uint8_t kReqMixerChannelLevel = 6;

/// Bits of State.state.
inline constexpr std::int32_t kStateStopped = 0;
inline constexpr std::int32_t kStatePlaying = 1;
inline constexpr std::int32_t kStateRecording = 2;

/// Mask of the bits of Wav.format that describe raw sound.
inline constexpr std::int32_t kDescriptionBits = 255;

/// Bits per value of raw sound: mask and values.
inline constexpr std::int32_t kBits = 3;
inline constexpr std::int32_t k8bit = 0;
inline constexpr std::int32_t k16bit = 1;
inline constexpr std::int32_t k24bit = 2;

/// Channels of raw sound.
inline constexpr std::int32_t kMono = 0;
inline constexpr std::int32_t kStereo = 4;

/// Sampling rate of raw sound: mask and values.
inline constexpr std::int32_t kFreq = 24;
inline constexpr std::int32_t kFreq44k = 0;
inline constexpr std::int32_t kFreq11k = 8;
inline constexpr std::int32_t kFreq22k = 16;
inline constexpr std::int32_t kFreq48k = 24;

/// Kind of sound data: mask and values.
inline constexpr std::int32_t kFormatBits = 65280;
inline constexpr std::int32_t kFormatNull = 0;
inline constexpr std::int32_t kFormatRaw = 256;
inline constexpr std::int32_t kFormatMp3 = 512;
inline constexpr std::int32_t kFormatOgg = 768;
inline constexpr std::int32_t kFormatFlac = 1024;
inline constexpr std::int32_t kFormatAac = 1280;

/// Bits of MixerChannelDetail.caps.
inline constexpr std::int32_t kMixerChannelTypeInput = 1;
inline constexpr std::int32_t kMixerChannelTypeOutput = 2;
inline constexpr std::int32_t kMixerChannelTypeSpecial = 4;

/// A sound.
struct Wav {
  /// The sound, in the format of `format`.
  std::vector<std::uint8_t> data{};
  /// Kind, rate, channels and bits in one number.
  std::uint32_t format = 0;

  friend bool operator==(const Wav&, const Wav&) = default;
};

/// One tone.
struct SeqItem {
  /// [Hz]
  float freq = 0;
  /// [s]
  float duration = 0;
  /// 0: silent, to 1: full volume. [1]
  float amplitude = 0;
  /// On: joined to the next tone without a gap.
  Bool link{};

  friend bool operator==(const SeqItem&, const SeqItem&) = default;
};

/// A sequence of tones.
struct Seq {
  std::vector<SeqItem> tones{};

  friend bool operator==(const Seq&, const Seq&) = default;
};

/// Level of one channel.
struct MixerChannel {
  /// 0: silent, to 1: full volume. [1]
  float amplitude = 0;
  /// Off: muted.
  Bool active{};
  /// Index of the channel.
  std::uint32_t index = 0;

  friend bool operator==(const MixerChannel&, const MixerChannel&) = default;
};

/// Levels of some channels.
struct MixerChannelList {
  std::vector<MixerChannel> channels{};

  friend bool operator==(const MixerChannelList&, const MixerChannelList&) = default;
};

/// Description of a channel.
struct MixerChannelDetail {
  std::string name{};
  /// Input, output or special.
  std::uint8_t caps = 0;

  friend bool operator==(const MixerChannelDetail&, const MixerChannelDetail&) = default;
};

/// List of channels.
struct MixerChannelListDetail {
  std::vector<MixerChannelDetail> details{};
  /// Index of the channel that plays; -1 none.
  std::int32_t default_output = 0;
  /// Index of the channel that records; -1 none.
  std::int32_t default_input = 0;

  friend bool operator==(const MixerChannelListDetail&, const MixerChannelListDetail&) = default;
};

/// A sample and its index in the store.
struct Sample {
  Wav sample{};
  /// Index in the store; -1: chosen by the driver when loading.
  std::int32_t index = 0;

  friend bool operator==(const Sample&, const Sample&) = default;
};

/// An index in the store.
struct SampleItem {
  std::int32_t index = 0;

  friend bool operator==(const SampleItem&, const SampleItem&) = default;
};

/// Request to record into the store.
struct SampleRecReq {
  /// Index in the store; -1: chosen by the driver.
  std::int32_t index = 0;
  /// [ms]
  std::uint32_t length = 0;

  friend bool operator==(const SampleRecReq&, const SampleRecReq&) = default;
};

/// State of the device.
struct State {
  /// Playing, recording, both or neither.
  std::uint32_t state = 0;

  friend bool operator==(const State&, const State&) = default;
};

void read(Reader& in, Wav& m);
void write(Writer& out, const Wav& m);
void to_json(std::string& out, const Wav& m);
void read(Reader& in, SeqItem& m);
void write(Writer& out, const SeqItem& m);
void to_json(std::string& out, const SeqItem& m);
void read(Reader& in, Seq& m);
void write(Writer& out, const Seq& m);
void to_json(std::string& out, const Seq& m);
void read(Reader& in, MixerChannel& m);
void write(Writer& out, const MixerChannel& m);
void to_json(std::string& out, const MixerChannel& m);
void read(Reader& in, MixerChannelList& m);
void write(Writer& out, const MixerChannelList& m);
void to_json(std::string& out, const MixerChannelList& m);
void read(Reader& in, MixerChannelDetail& m);
void write(Writer& out, const MixerChannelDetail& m);
void to_json(std::string& out, const MixerChannelDetail& m);
void read(Reader& in, MixerChannelListDetail& m);
void write(Writer& out, const MixerChannelListDetail& m);
void to_json(std::string& out, const MixerChannelListDetail& m);
void read(Reader& in, Sample& m);
void write(Writer& out, const Sample& m);
void to_json(std::string& out, const Sample& m);
void read(Reader& in, SampleItem& m);
void write(Writer& out, const SampleItem& m);
void to_json(std::string& out, const SampleItem& m);
void read(Reader& in, SampleRecReq& m);
void write(Writer& out, const SampleRecReq& m);
void to_json(std::string& out, const SampleRecReq& m);
void read(Reader& in, State& m);
void write(Writer& out, const State& m);
void to_json(std::string& out, const State& m);

}  // namespace playhouse::wire::audio
