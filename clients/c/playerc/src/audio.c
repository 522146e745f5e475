#include "inside.h"

/** Replaces a value of the proxy by a copy of another. */
#define KEEP(T, TO, FROM) \
  do {                    \
    T##_cleanup(TO);      \
    T##_copy(TO, FROM);   \
  } while (0)

static void put(void *proxy, char *header, char *body) {
  playerc_audio_t *device = proxy;
  const void *message = body;
  switch (playerc_subtype(header)) {
    case PLAYER_AUDIO_DATA_WAV_REC:
      KEEP(player_audio_wav_t, &device->wav_data, message);
      break;
    case PLAYER_AUDIO_DATA_SEQ:
      KEEP(player_audio_seq_t, &device->seq_data, message);
      break;
    case PLAYER_AUDIO_DATA_MIXER_CHANNEL:
      KEEP(player_audio_mixer_channel_list_t, &device->mixer_data, message);
      break;
    case PLAYER_AUDIO_DATA_STATE:
      device->state = ((const player_audio_state_t *)message)->state;
      break;
    default:
      break;
  }
}

static void release(playerc_audio_t *device) {
  player_audio_mixer_channel_list_detail_t_cleanup(&device->channel_details_list);
  player_audio_wav_t_cleanup(&device->wav_data);
  player_audio_seq_t_cleanup(&device->seq_data);
  player_audio_mixer_channel_list_t_cleanup(&device->mixer_data);
}

PLAYERC_PROXY(audio, PLAYER_AUDIO_CODE, put, release)

int playerc_audio_wav_play_cmd(playerc_audio_t *device, uint32_t data_count, uint8_t data[],
                               uint32_t format) {
  const player_audio_wav_t command = {data_count, data, format};
  return playerc_command(&device->info, PLAYER_AUDIO_CMD_WAV_PLAY, &command);
}

int playerc_audio_wav_stream_rec_cmd(playerc_audio_t *device, uint8_t state) {
  const player_bool_t command = {state};
  return playerc_command(&device->info, PLAYER_AUDIO_CMD_WAV_STREAM_REC, &command);
}

int playerc_audio_sample_play_cmd(playerc_audio_t *device, int index) {
  const player_audio_sample_item_t command = {index};
  return playerc_command(&device->info, PLAYER_AUDIO_CMD_SAMPLE_PLAY, &command);
}

int playerc_audio_seq_play_cmd(playerc_audio_t *device, player_audio_seq_t *tones) {
  return playerc_command(&device->info, PLAYER_AUDIO_CMD_SEQ_PLAY, tones);
}

int playerc_audio_mixer_multchannels_cmd(playerc_audio_t *device, player_audio_mixer_channel_list_t *levels) {
  return playerc_command(&device->info, PLAYER_AUDIO_CMD_MIXER_CHANNEL, levels);
}

int playerc_audio_mixer_channel_cmd(playerc_audio_t *device, uint32_t index, float amplitude,
                                    uint8_t active) {
  player_audio_mixer_channel_t channel = {amplitude, {active}, index};
  player_audio_mixer_channel_list_t levels = {1, &channel};
  return playerc_audio_mixer_multchannels_cmd(device, &levels);
}

int playerc_audio_wav_rec(playerc_audio_t *device) {
  player_audio_wav_t *wav = NULL;
  const int result = playerc_ask(&device->info, PLAYER_AUDIO_REQ_WAV_REC, NULL, &wav);
  if (result == 0) KEEP(player_audio_wav_t, &device->wav_data, wav);
  player_audio_wav_t_free(wav);
  return result;
}

int playerc_audio_sample_load(playerc_audio_t *device, int index, uint32_t data_count, uint8_t data[],
                              uint32_t format) {
  const player_audio_sample_t wanted = {{data_count, data, format}, index};
  return playerc_tell(&device->info, PLAYER_AUDIO_REQ_SAMPLE_LOAD, &wanted);
}

int playerc_audio_sample_retrieve(playerc_audio_t *device, int index) {
  const player_audio_sample_t question = {.index = index};
  player_audio_sample_t *sample = NULL;
  const int result = playerc_ask(&device->info, PLAYER_AUDIO_REQ_SAMPLE_RETRIEVE, &question, &sample);
  if (result == 0) KEEP(player_audio_wav_t, &device->wav_data, &sample->sample);
  player_audio_sample_t_free(sample);
  return result;
}

int playerc_audio_sample_rec(playerc_audio_t *device, int index, uint32_t length) {
  const player_audio_sample_rec_req_t wanted = {index, length};
  return playerc_tell(&device->info, PLAYER_AUDIO_REQ_SAMPLE_REC, &wanted);
}

int playerc_audio_get_mixer_levels(playerc_audio_t *device) {
  player_audio_mixer_channel_list_t *levels = NULL;
  const int result = playerc_ask(&device->info, PLAYER_AUDIO_REQ_MIXER_CHANNEL_LEVEL, NULL, &levels);
  if (result == 0) KEEP(player_audio_mixer_channel_list_t, &device->mixer_data, levels);
  player_audio_mixer_channel_list_t_free(levels);
  return result;
}

int playerc_audio_get_mixer_details(playerc_audio_t *device) {
  player_audio_mixer_channel_list_detail_t *details = NULL;
  const int result = playerc_ask(&device->info, PLAYER_AUDIO_REQ_MIXER_CHANNEL_LIST, NULL, &details);
  if (result == 0) KEEP(player_audio_mixer_channel_list_detail_t, &device->channel_details_list, details);
  player_audio_mixer_channel_list_detail_t_free(details);
  return result;
}
