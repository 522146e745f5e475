/** Messages and texts: opaque, blackboard, speech, speech_recognition. */
#include <string.h>
#include <time.h>

#include "inside.h"

// --- opaque

static void put_opaque(void *proxy, char *header, char *body) {
  playerc_opaque_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_OPAQUE_DATA_STATE) return;
  const player_opaque_data_t *data = message;
  if (playerc_keep(&device->data, data->data, data->data_count, 1))
    device->data_count = (int)data->data_count;
}

static void release_opaque(playerc_opaque_t *device) {
  free(device->data);
}

PLAYERC_PROXY(opaque, PLAYER_OPAQUE_CODE, put_opaque, release_opaque)

int playerc_opaque_cmd(playerc_opaque_t *device, player_opaque_data_t *data) {
  return playerc_command(&device->info, PLAYER_OPAQUE_CMD_DATA, data);
}

int playerc_opaque_req(playerc_opaque_t *device, player_opaque_data_t *request,
                       player_opaque_data_t **reply) {
  player_opaque_data_t *answer = NULL;
  if (reply == NULL) return playerc_tell(&device->info, PLAYER_OPAQUE_REQ_DATA, request);
  const int result = playerc_ask(&device->info, PLAYER_OPAQUE_REQ_DATA, request, &answer);
  if (result == 0) *reply = answer;
  return result;
}

// --- blackboard

static void put_entry(void *proxy, char *header, char *body) {
  playerc_blackboard_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_BLACKBOARD_DATA_UPDATE || device->on_blackboard_event == NULL) return;
  device->on_blackboard_event(device, *(const player_blackboard_entry_t *)message);
}

PLAYERC_PROXY(blackboard, PLAYER_BLACKBOARD_CODE, put_entry, PLAYERC_NO_LISTS)

static player_blackboard_entry_t entry_of(const char *key, const char *group) {
  const player_blackboard_entry_t entry = {.key_count = playerc_text_count(key),
                                           .key = playerc_text(key),
                                           .group_count = playerc_text_count(group),
                                           .group = playerc_text(group)};
  return entry;
}

static int ask_for(playerc_blackboard_t *device, uint8_t subtype, const char *key, const char *group,
                   player_blackboard_entry_t **entry) {
  const player_blackboard_entry_t question = entry_of(key, group);
  player_blackboard_entry_t *answer = NULL;
  if (entry == NULL) return playerc_tell(&device->info, subtype, &question);
  const int result = playerc_ask(&device->info, subtype, &question, &answer);
  if (result == 0) *entry = answer;
  return result;
}

int playerc_blackboard_subscribe_to_key(playerc_blackboard_t *device, const char *key, const char *group,
                                        player_blackboard_entry_t **entry) {
  return ask_for(device, PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_KEY, key, group, entry);
}

int playerc_blackboard_get_entry(playerc_blackboard_t *device, const char *key, const char *group,
                                 player_blackboard_entry_t **entry) {
  return ask_for(device, PLAYER_BLACKBOARD_REQ_GET_ENTRY, key, group, entry);
}

int playerc_blackboard_unsubscribe_from_key(playerc_blackboard_t *device, const char *key,
                                            const char *group) {
  return ask_for(device, PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_KEY, key, group, NULL);
}

int playerc_blackboard_subscribe_to_group(playerc_blackboard_t *device, const char *group) {
  return ask_for(device, PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_GROUP, "", group, NULL);
}

int playerc_blackboard_unsubscribe_from_group(playerc_blackboard_t *device, const char *group) {
  return ask_for(device, PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_GROUP, "", group, NULL);
}

int playerc_blackboard_set_entry(playerc_blackboard_t *device, player_blackboard_entry_t *entry) {
  return playerc_tell(&device->info, PLAYER_BLACKBOARD_REQ_SET_ENTRY, entry);
}

static int set_simple(playerc_blackboard_t *device, const char *key, const char *group, uint16_t subtype,
                      const void *value, size_t size) {
  player_blackboard_entry_t entry = {.key_count = playerc_text_count(key),
                                     .key = playerc_text(key),
                                     .group_count = playerc_text_count(group),
                                     .group = playerc_text(group),
                                     .type = PLAYERC_BLACKBOARD_DATA_TYPE_SIMPLE,
                                     .subtype = subtype,
                                     .data_count = (uint32_t)size,
                                     .data = (uint8_t *)(uintptr_t)value};
  struct timespec now = {0};
  timespec_get(&now, TIME_UTC);
  entry.timestamp_sec = (uint32_t)now.tv_sec;
  entry.timestamp_usec = (uint32_t)(now.tv_nsec / 1000);
  return playerc_blackboard_set_entry(device, &entry);
}

int playerc_blackboard_set_string(playerc_blackboard_t *device, const char *key, const char *group,
                                  const char *value) {
  return set_simple(device, key, group, PLAYERC_BLACKBOARD_DATA_SUBTYPE_STRING, value, strlen(value) + 1);
}

int playerc_blackboard_set_int(playerc_blackboard_t *device, const char *key, const char *group, int value) {
  return set_simple(device, key, group, PLAYERC_BLACKBOARD_DATA_SUBTYPE_INT, &value, sizeof value);
}

int playerc_blackboard_set_double(playerc_blackboard_t *device, const char *key, const char *group,
                                  double value) {
  return set_simple(device, key, group, PLAYERC_BLACKBOARD_DATA_SUBTYPE_DOUBLE, &value, sizeof value);
}

// --- speech

PLAYERC_PROXY(speech, PLAYER_SPEECH_CODE, NULL, PLAYERC_NO_LISTS)

int playerc_speech_say(playerc_speech_t *device, const char *text) {
  const player_speech_cmd_t command = {playerc_text_count(text), playerc_text(text)};
  return playerc_command(&device->info, PLAYER_SPEECH_CMD_SAY, &command);
}

// --- speech_recognition

static void release_words(playerc_speechrecognition_t *device) {
  for (int i = 0; i < device->wordCount; ++i) free(device->words[i]);
  free(device->words);
  free(device->rawText);
  device->words = NULL;
  device->rawText = NULL;
  device->wordCount = 0;
}

/** The next word of a text, and where it ends; NULL behind the last. */
static const char *next_word(const char *text, size_t *length) {
  static const char between[] = " \t\n";
  text += strspn(text, between);
  *length = strcspn(text, between);
  return *length > 0 ? text : NULL;
}

static void put_text(void *proxy, char *header, char *body) {
  playerc_speechrecognition_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_SPEECH_RECOGNITION_DATA_STRING) return;
  const player_speech_recognition_data_t *data = message;
  const char *text = data->text != NULL ? data->text : "";
  release_words(device);
  if (!playerc_keep(&device->rawText, text, strlen(text) + 1, 1)) return;
  size_t length = 0;
  for (const char *word = next_word(text, &length); word != NULL; word = next_word(word + length, &length)) {
    if (!playerc_room(&device->words, (size_t)device->wordCount + 1, sizeof *device->words)) return;
    char *copy = calloc(1, length + 1);
    if (copy == NULL) return;
    device->words[device->wordCount++] = memcpy(copy, word, length);
  }
}

PLAYERC_PROXY(speechrecognition, PLAYER_SPEECH_RECOGNITION_CODE, put_text, release_words)
