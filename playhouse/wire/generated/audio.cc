// Generated from interfaces/009_audio.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/audio.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::audio {

void read(Reader& in, Wav& m) {
  std::uint32_t data_count = 0;
  in.read(data_count);
  in.read_bytes(m.data, in.dynamic_length("data", data_count, 1));
  in.read(m.format);
}

void write(Writer& out, const Wav& m) {
  out.write_length("data", m.data.size(), 33554392);
  out.write_length("data", m.data.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.data)));
  out.write(m.format);
}

void to_json(std::string& out, const Wav& m) {
  json_key(out, '{', "data");
  json_bytes(out, m.data);
  json_key(out, ',', "format");
  json_value(out, m.format);
  out += '}';
}

void read(Reader& in, SeqItem& m) {
  in.read(m.freq);
  in.read(m.duration);
  in.read(m.amplitude);
  read(in, m.link);
}

void write(Writer& out, const SeqItem& m) {
  out.write(m.freq);
  out.write(m.duration);
  out.write(m.amplitude);
  write(out, m.link);
}

void to_json(std::string& out, const SeqItem& m) {
  json_key(out, '{', "freq");
  json_value(out, m.freq);
  json_key(out, ',', "duration");
  json_value(out, m.duration);
  json_key(out, ',', "amplitude");
  json_value(out, m.amplitude);
  json_key(out, ',', "link");
  to_json(out, m.link);
  out += '}';
}

void read(Reader& in, Seq& m) {
  std::uint32_t tones_count = 0;
  in.read(tones_count);
  m.tones.resize(in.dynamic_length("tones", tones_count, 16));
  for (auto& element : m.tones) read(in, element);
}

void write(Writer& out, const Seq& m) {
  out.write_length("tones", m.tones.size(), 2097149);
  out.write_length("tones", m.tones.size(), 2097149);
  for (const auto& element : m.tones) write(out, element);
}

void to_json(std::string& out, const Seq& m) {
  json_key(out, '{', "tones");
  json_array(out, m.tones, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, MixerChannel& m) {
  in.read(m.amplitude);
  read(in, m.active);
  in.read(m.index);
}

void write(Writer& out, const MixerChannel& m) {
  out.write(m.amplitude);
  write(out, m.active);
  out.write(m.index);
}

void to_json(std::string& out, const MixerChannel& m) {
  json_key(out, '{', "amplitude");
  json_value(out, m.amplitude);
  json_key(out, ',', "active");
  to_json(out, m.active);
  json_key(out, ',', "index");
  json_value(out, m.index);
  out += '}';
}

void read(Reader& in, MixerChannelList& m) {
  std::uint32_t channels_count = 0;
  in.read(channels_count);
  m.channels.resize(in.dynamic_length("channels", channels_count, 12));
  for (auto& element : m.channels) read(in, element);
}

void write(Writer& out, const MixerChannelList& m) {
  out.write_length("channels", m.channels.size(), 2796199);
  out.write_length("channels", m.channels.size(), 2796199);
  for (const auto& element : m.channels) write(out, element);
}

void to_json(std::string& out, const MixerChannelList& m) {
  json_key(out, '{', "channels");
  json_array(out, m.channels, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, MixerChannelDetail& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  in.read(m.caps);
}

void write(Writer& out, const MixerChannelDetail& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  out.write(m.caps);
}

void to_json(std::string& out, const MixerChannelDetail& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "caps");
  json_value(out, m.caps);
  out += '}';
}

void read(Reader& in, MixerChannelListDetail& m) {
  std::uint32_t details_count = 0;
  in.read(details_count);
  m.details.resize(in.dynamic_length("details", details_count, 12));
  for (auto& element : m.details) read(in, element);
  in.read(m.default_output);
  in.read(m.default_input);
}

void write(Writer& out, const MixerChannelListDetail& m) {
  out.write_length("details", m.details.size(), 2796199);
  out.write_length("details", m.details.size(), 2796199);
  for (const auto& element : m.details) write(out, element);
  out.write(m.default_output);
  out.write(m.default_input);
}

void to_json(std::string& out, const MixerChannelListDetail& m) {
  json_key(out, '{', "details");
  json_array(out, m.details, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "default_output");
  json_value(out, m.default_output);
  json_key(out, ',', "default_input");
  json_value(out, m.default_input);
  out += '}';
}

void read(Reader& in, Sample& m) {
  read(in, m.sample);
  in.read(m.index);
}

void write(Writer& out, const Sample& m) {
  write(out, m.sample);
  out.write(m.index);
}

void to_json(std::string& out, const Sample& m) {
  json_key(out, '{', "sample");
  to_json(out, m.sample);
  json_key(out, ',', "index");
  json_value(out, m.index);
  out += '}';
}

void read(Reader& in, SampleItem& m) {
  in.read(m.index);
}

void write(Writer& out, const SampleItem& m) {
  out.write(m.index);
}

void to_json(std::string& out, const SampleItem& m) {
  json_key(out, '{', "index");
  json_value(out, m.index);
  out += '}';
}

void read(Reader& in, SampleRecReq& m) {
  in.read(m.index);
  in.read(m.length);
}

void write(Writer& out, const SampleRecReq& m) {
  out.write(m.index);
  out.write(m.length);
}

void to_json(std::string& out, const SampleRecReq& m) {
  json_key(out, '{', "index");
  json_value(out, m.index);
  json_key(out, ',', "length");
  json_value(out, m.length);
  out += '}';
}

void read(Reader& in, State& m) {
  in.read(m.state);
}

void write(Writer& out, const State& m) {
  out.write(m.state);
}

void to_json(std::string& out, const State& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

const MessageDef kRows[15] = {
    {9, MessageType::kData, kDataWavRec, "audio.data.wav_rec", "audio::Wav", true, Policy::kQueue,
     check_required<Wav>, reencode<Wav>, body_to_json<Wav>},
    {9, MessageType::kData, kDataSeq, "audio.data.seq", "audio::Seq", true, Policy::kQueue,
     check_required<Seq>, reencode<Seq>, body_to_json<Seq>},
    {9, MessageType::kData, kDataMixerChannel, "audio.data.mixer_channel", "audio::MixerChannelList", true, Policy::kLatest,
     check_required<MixerChannelList>, reencode<MixerChannelList>, body_to_json<MixerChannelList>},
    {9, MessageType::kData, kDataState, "audio.data.state", "audio::State", true, Policy::kLatest,
     check_required<State>, reencode<State>, body_to_json<State>},
    {9, MessageType::kCmd, kCmdWavPlay, "audio.cmd.wav_play", "audio::Wav", true, Policy::kQueue,
     check_required<Wav>, reencode<Wav>, body_to_json<Wav>},
    {9, MessageType::kCmd, kCmdWavStreamRec, "audio.cmd.wav_stream_rec", "Bool", true, Policy::kQueue,
     check_required<Bool>, reencode<Bool>, body_to_json<Bool>},
    {9, MessageType::kCmd, kCmdSamplePlay, "audio.cmd.sample_play", "audio::SampleItem", true, Policy::kQueue,
     check_required<SampleItem>, reencode<SampleItem>, body_to_json<SampleItem>},
    {9, MessageType::kCmd, kCmdSeqPlay, "audio.cmd.seq_play", "audio::Seq", true, Policy::kQueue,
     check_required<Seq>, reencode<Seq>, body_to_json<Seq>},
    {9, MessageType::kCmd, kCmdMixerChannel, "audio.cmd.mixer_channel", "audio::MixerChannelList", true, Policy::kQueue,
     check_required<MixerChannelList>, reencode<MixerChannelList>, body_to_json<MixerChannelList>},
    {9, MessageType::kReq, kReqWavRec, "audio.req.wav_rec", "audio::Wav", true, Policy::kNone,
     check_optional<Wav>, reencode<Wav>, body_to_json<Wav>},
    {9, MessageType::kReq, kReqSampleLoad, "audio.req.sample_load", "audio::Sample", true, Policy::kNone,
     check_optional<Sample>, reencode<Sample>, body_to_json<Sample>},
    {9, MessageType::kReq, kReqSampleRetrieve, "audio.req.sample_retrieve", "audio::Sample", true, Policy::kNone,
     check_optional<Sample>, reencode<Sample>, body_to_json<Sample>},
    {9, MessageType::kReq, kReqSampleRec, "audio.req.sample_rec", "audio::SampleItem", true, Policy::kNone,
     check_optional<SampleItem>, reencode<SampleItem>, body_to_json<SampleItem>},
    {9, MessageType::kReq, kReqMixerChannelList, "audio.req.mixer_channel_list", "audio::MixerChannelListDetail", true, Policy::kNone,
     check_optional<MixerChannelListDetail>, reencode<MixerChannelListDetail>, body_to_json<MixerChannelListDetail>},
    {9, MessageType::kReq, kReqMixerChannelLevel, "audio.req.mixer_channel_level", "audio::MixerChannelList", true, Policy::kNone,
     check_optional<MixerChannelList>, reencode<MixerChannelList>, body_to_json<MixerChannelList>},
};

}  // namespace playhouse::wire::audio
