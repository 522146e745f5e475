/** Generated from interfaces/009_audio.toml by codegen; do not edit. */
#include "playhouse/c/generated/audio.h"

#include <stddef.h>

static const ph_field ph_audio_wav_fields[2] = {
    {"data", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_audio_wav, data), offsetof(ph_audio_wav, data_count), NULL},
    {"format", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_wav, format), 0, NULL},
};
const ph_struct_type ph_audio_wav_type = {"audio.Wav", ph_audio_wav_fields, 2, 12, sizeof(ph_audio_wav)};

static const ph_field ph_audio_seq_item_fields[4] = {
    {"freq", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_seq_item, freq), 0, NULL},
    {"duration", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_seq_item, duration), 0, NULL},
    {"amplitude", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_seq_item, amplitude), 0, NULL},
    {"link", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_seq_item, link), 0, &ph_common_bool_type},
};
const ph_struct_type ph_audio_seq_item_type = {"audio.SeqItem", ph_audio_seq_item_fields, 4, 16, sizeof(ph_audio_seq_item)};

static const ph_field ph_audio_seq_fields[1] = {
    {"tones", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2097149, offsetof(ph_audio_seq, tones), offsetof(ph_audio_seq, tones_count), &ph_audio_seq_item_type},
};
const ph_struct_type ph_audio_seq_type = {"audio.Seq", ph_audio_seq_fields, 1, 8, sizeof(ph_audio_seq)};

static const ph_field ph_audio_mixer_channel_fields[3] = {
    {"amplitude", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel, amplitude), 0, NULL},
    {"active", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel, active), 0, &ph_common_bool_type},
    {"index", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel, index), 0, NULL},
};
const ph_struct_type ph_audio_mixer_channel_type = {"audio.MixerChannel", ph_audio_mixer_channel_fields, 3, 12, sizeof(ph_audio_mixer_channel)};

static const ph_field ph_audio_mixer_channel_list_fields[1] = {
    {"channels", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2796199, offsetof(ph_audio_mixer_channel_list, channels), offsetof(ph_audio_mixer_channel_list, channels_count), &ph_audio_mixer_channel_type},
};
const ph_struct_type ph_audio_mixer_channel_list_type = {"audio.MixerChannelList", ph_audio_mixer_channel_list_fields, 1, 8, sizeof(ph_audio_mixer_channel_list)};

static const ph_field ph_audio_mixer_channel_detail_fields[2] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_audio_mixer_channel_detail, name), offsetof(ph_audio_mixer_channel_detail, name_count), NULL},
    {"caps", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel_detail, caps), 0, NULL},
};
const ph_struct_type ph_audio_mixer_channel_detail_type = {"audio.MixerChannelDetail", ph_audio_mixer_channel_detail_fields, 2, 12, sizeof(ph_audio_mixer_channel_detail)};

static const ph_field ph_audio_mixer_channel_list_detail_fields[3] = {
    {"details", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2796199, offsetof(ph_audio_mixer_channel_list_detail, details), offsetof(ph_audio_mixer_channel_list_detail, details_count), &ph_audio_mixer_channel_detail_type},
    {"default_output", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel_list_detail, default_output), 0, NULL},
    {"default_input", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_mixer_channel_list_detail, default_input), 0, NULL},
};
const ph_struct_type ph_audio_mixer_channel_list_detail_type = {"audio.MixerChannelListDetail", ph_audio_mixer_channel_list_detail_fields, 3, 16, sizeof(ph_audio_mixer_channel_list_detail)};

static const ph_field ph_audio_sample_fields[2] = {
    {"sample", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_sample, sample), 0, &ph_audio_wav_type},
    {"index", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_sample, index), 0, NULL},
};
const ph_struct_type ph_audio_sample_type = {"audio.Sample", ph_audio_sample_fields, 2, 16, sizeof(ph_audio_sample)};

static const ph_field ph_audio_sample_item_fields[1] = {
    {"index", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_sample_item, index), 0, NULL},
};
const ph_struct_type ph_audio_sample_item_type = {"audio.SampleItem", ph_audio_sample_item_fields, 1, 4, sizeof(ph_audio_sample_item)};

static const ph_field ph_audio_sample_rec_req_fields[2] = {
    {"index", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_sample_rec_req, index), 0, NULL},
    {"length", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_sample_rec_req, length), 0, NULL},
};
const ph_struct_type ph_audio_sample_rec_req_type = {"audio.SampleRecReq", ph_audio_sample_rec_req_fields, 2, 8, sizeof(ph_audio_sample_rec_req)};

static const ph_field ph_audio_state_fields[1] = {
    {"state", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_audio_state, state), 0, NULL},
};
const ph_struct_type ph_audio_state_type = {"audio.State", ph_audio_state_fields, 1, 4, sizeof(ph_audio_state)};

const ph_message_type ph_audio_messages[15] = {
    {9, PH_KIND_DATA, 1, "audio.data.wav_rec", &ph_audio_wav_type},
    {9, PH_KIND_DATA, 2, "audio.data.seq", &ph_audio_seq_type},
    {9, PH_KIND_DATA, 3, "audio.data.mixer_channel", &ph_audio_mixer_channel_list_type},
    {9, PH_KIND_DATA, 4, "audio.data.state", &ph_audio_state_type},
    {9, PH_KIND_CMD, 1, "audio.cmd.wav_play", &ph_audio_wav_type},
    {9, PH_KIND_CMD, 2, "audio.cmd.wav_stream_rec", &ph_common_bool_type},
    {9, PH_KIND_CMD, 3, "audio.cmd.sample_play", &ph_audio_sample_item_type},
    {9, PH_KIND_CMD, 4, "audio.cmd.seq_play", &ph_audio_seq_type},
    {9, PH_KIND_CMD, 5, "audio.cmd.mixer_channel", &ph_audio_mixer_channel_list_type},
    {9, PH_KIND_REQ, 1, "audio.req.wav_rec", &ph_audio_wav_type},
    {9, PH_KIND_REQ, 2, "audio.req.sample_load", &ph_audio_sample_type},
    {9, PH_KIND_REQ, 3, "audio.req.sample_retrieve", &ph_audio_sample_type},
    {9, PH_KIND_REQ, 4, "audio.req.sample_rec", &ph_audio_sample_item_type},
    {9, PH_KIND_REQ, 5, "audio.req.mixer_channel_list", &ph_audio_mixer_channel_list_detail_type},
    {9, PH_KIND_REQ, 6, "audio.req.mixer_channel_level", &ph_audio_mixer_channel_list_type},
};
