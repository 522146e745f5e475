/** Radios and tags: wifi, rfid, wsn. */
#include <string.h>

#include "inside.h"

// --- wifi

/** A text of at most 32 bytes, which is NUL-terminated only if it is shorter. */
static void keep_text(uint8_t to[32], const uint8_t from[32], uint32_t count) {
  memset(to, 0, 32);
  memcpy(to, from, count < 31 ? count : 31);
}

static void put_wifi(void *proxy, char *header, char *body) {
  playerc_wifi_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_WIFI_DATA_STATE) return;
  const player_wifi_data_t *data = message;
  if (!playerc_room(&device->links, data->links_count, sizeof *device->links)) return;
  device->link_count = (int)data->links_count;
  for (uint32_t i = 0; i < data->links_count; ++i) {
    const player_wifi_link_t *from = &data->links[i];
    playerc_wifi_link_t *to = &device->links[i];
    keep_text(to->mac, from->mac, from->mac_count);
    keep_text(to->ip, from->ip, from->ip_count);
    keep_text(to->essid, from->essid, from->essid_count);
    to->mode = (int)from->mode;
    to->encrypt = (int)from->encrypt;
    to->freq = from->freq;
    to->qual = (int)from->qual;
    to->level = (int)from->level;
    to->noise = (int)from->noise;
  }
}

static void release_wifi(playerc_wifi_t *device) {
  free(device->links);
}

PLAYERC_PROXY(wifi, PLAYER_WIFI_CODE, put_wifi, release_wifi)

playerc_wifi_link_t *playerc_wifi_get_link(playerc_wifi_t *device, int link) {
  return link >= 0 && link < device->link_count ? &device->links[link] : NULL;
}

// --- rfid

static void release_tags(playerc_rfid_t *device) {
  for (uint16_t i = 0; i < device->tags_count; ++i) free(device->tags[i].guid);
  free(device->tags);
  device->tags = NULL;
  device->tags_count = 0;
}

static void put_tags(void *proxy, char *header, char *body) {
  playerc_rfid_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_RFID_DATA_TAGS) return;
  const player_rfid_data_t *data = message;
  release_tags(device);
  const uint16_t count = data->tags_count < UINT16_MAX ? (uint16_t)data->tags_count : UINT16_MAX;
  if (!playerc_room(&device->tags, count, sizeof *device->tags)) return;
  for (uint16_t i = 0; i < count; ++i) {
    playerc_rfidtag_t tag = {data->tags[i].type, data->tags[i].guid_count, NULL};
    if (!playerc_keep(&tag.guid, data->tags[i].guid, tag.guid_count, 1)) return;
    device->tags[device->tags_count++] = tag;
  }
}

PLAYERC_PROXY(rfid, PLAYER_RFID_CODE, put_tags, release_tags)

// --- wsn

static void put_wsn(void *proxy, char *header, char *body) {
  playerc_wsn_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_WSN_DATA_STATE) return;
  const player_wsn_data_t *data = message;
  device->node_type = data->node_type;
  device->node_id = data->node_id;
  device->node_parent_id = data->node_parent_id;
  device->data_packet = data->data_packet;
}

PLAYERC_PROXY(wsn, PLAYER_WSN_CODE, put_wsn, PLAYERC_NO_LISTS)

int playerc_wsn_set_devstate(playerc_wsn_t *device, int node_id, int group_id, int devnr, int state) {
  const player_wsn_cmd_t command = {node_id, group_id, (uint32_t)devnr, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_WSN_CMD_DEVSTATE, &command);
}

int playerc_wsn_power(playerc_wsn_t *device, int node_id, int group_id, int value) {
  const player_wsn_power_config_t wanted = {node_id, group_id, (uint8_t)value};
  return playerc_tell(&device->info, PLAYER_WSN_REQ_POWER, &wanted);
}

int playerc_wsn_datatype(playerc_wsn_t *device, int value) {
  const player_wsn_datatype_config_t wanted = {(uint8_t)value};
  return playerc_tell(&device->info, PLAYER_WSN_REQ_DATATYPE, &wanted);
}

int playerc_wsn_datafreq(playerc_wsn_t *device, int node_id, int group_id, double frequency) {
  const player_wsn_datafreq_config_t wanted = {node_id, group_id, frequency};
  return playerc_tell(&device->info, PLAYER_WSN_REQ_DATAFREQ, &wanted);
}
