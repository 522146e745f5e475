#include "inside.h"

PLAYERC_PROXY(vectormap, PLAYER_VECTORMAP_CODE, NULL, playerc_vectormap_cleanup)

void playerc_vectormap_cleanup(playerc_vectormap_t *device) {
  for (uint32_t i = 0; i < device->layers_count; ++i) {
    player_vectormap_layer_data_t_free(device->layers_data[i]);
    player_vectormap_layer_info_t_free(device->layers_info[i]);
  }
  free(device->layers_data);
  free(device->layers_info);
  device->layers_data = NULL;
  device->layers_info = NULL;
  device->layers_count = 0;
}

static int keep_info(playerc_vectormap_t *device, const player_vectormap_info_t *info) {
  playerc_vectormap_cleanup(device);
  device->srid = info->srid;
  device->extent = info->extent;
  const size_t room = info->layers_count + (size_t)1;
  device->layers_data = calloc(room, sizeof *device->layers_data);
  device->layers_info = calloc(room, sizeof *device->layers_info);
  if (device->layers_data == NULL || device->layers_info == NULL) return playerc_fail_no_memory();
  device->layers_count = info->layers_count;
  for (uint32_t i = 0; i < info->layers_count; ++i) {
    device->layers_info[i] = player_vectormap_layer_info_t_clone(&info->layers[i]);
    if (device->layers_info[i] == NULL) return playerc_fail_no_memory();
  }
  return 0;
}

int playerc_vectormap_get_map_info(playerc_vectormap_t *device) {
  player_vectormap_info_t *info = NULL;
  int result = playerc_ask(&device->info, PLAYER_VECTORMAP_REQ_GET_MAP_INFO, NULL, &info);
  if (result == 0) result = keep_info(device, info);
  player_vectormap_info_t_free(info);
  return result;
}

int playerc_vectormap_get_layer_data(playerc_vectormap_t *device, unsigned layer_index) {
  if (layer_index >= device->layers_count)
    return playerc_fail("there is no layer %u: the map has %u", layer_index, device->layers_count);
  const player_vectormap_layer_info_t *info = device->layers_info[layer_index];
  const player_vectormap_layer_data_t question = {.name_count = info->name_count, .name = info->name};
  player_vectormap_layer_data_t *layer = NULL;
  const int result = playerc_ask(&device->info, PLAYER_VECTORMAP_REQ_GET_LAYER_DATA, &question, &layer);
  if (result != 0) return result;
  player_vectormap_layer_data_t_free(device->layers_data[layer_index]);
  device->layers_data[layer_index] = layer;
  return 0;
}

int playerc_vectormap_write_layer(playerc_vectormap_t *device, const player_vectormap_layer_data_t *data) {
  return playerc_tell(&device->info, PLAYER_VECTORMAP_REQ_WRITE_LAYER, data);
}

static const player_vectormap_feature_data_t *feature(const playerc_vectormap_t *device, unsigned layer_index,
                                                      unsigned feature_index) {
  if (layer_index >= device->layers_count || device->layers_data[layer_index] == NULL) return NULL;
  const player_vectormap_layer_data_t *layer = device->layers_data[layer_index];
  return feature_index < layer->features_count ? &layer->features[feature_index] : NULL;
}

uint8_t *playerc_vectormap_get_feature_data(playerc_vectormap_t *device, unsigned layer_index,
                                            unsigned feature_index) {
  const player_vectormap_feature_data_t *found = feature(device, layer_index, feature_index);
  return found != NULL ? found->wkb : NULL;
}

size_t playerc_vectormap_get_feature_data_count(playerc_vectormap_t *device, unsigned layer_index,
                                                unsigned feature_index) {
  const player_vectormap_feature_data_t *found = feature(device, layer_index, feature_index);
  return found != NULL ? found->wkb_count : 0;
}
