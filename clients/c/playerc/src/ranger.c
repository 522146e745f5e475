#include <math.h>
#include <string.h>

#include "inside.h"

/** The direction of a range, and what it is measured from. Several ranges of one element are a scan, as many as there
 * are elements are one of each. */
static void put_point(playerc_ranger_t *device, uint32_t i) {
  const player_pose3d_t *element = device->element_count > 1 && device->element_count == device->ranges_count
                                       ? &device->element_poses[i]
                                       : NULL;
  const double turned = element != NULL ? 0.0 : device->min_angle + i * device->angular_res;
  const double yaw = turned + (element != NULL ? element->pyaw : device->device_pose.pyaw);
  const double pitch = element != NULL ? element->ppitch : device->device_pose.ppitch;
  const player_pose3d_t *from = element != NULL ? element : &device->device_pose;
  device->bearings[i] = turned;
  device->points[i].px = from->px + device->ranges[i] * cos(pitch) * cos(yaw);
  device->points[i].py = from->py + device->ranges[i] * cos(pitch) * sin(yaw);
  device->points[i].pz = from->pz - device->ranges[i] * sin(pitch);
}

/** Bearings and points, of what is known of the device. */
static void put_points(playerc_ranger_t *device) {
  const uint32_t count = device->ranges_count;
  device->bearings_count = device->points_count = 0;
  if (!playerc_room(&device->bearings, count, sizeof *device->bearings)) return;
  if (!playerc_room(&device->points, count, sizeof *device->points)) return;
  device->bearings_count = device->points_count = count;
  for (uint32_t i = 0; i < count; ++i) put_point(device, i);
}

static void put_ranges(playerc_ranger_t *device, const player_ranger_data_range_t *data) {
  if (!playerc_keep(&device->ranges, data->ranges, data->ranges_count, sizeof *data->ranges)) return;
  device->ranges_count = data->ranges_count;
  put_points(device);
}

static void put_intensities(playerc_ranger_t *device, const player_ranger_data_intns_t *data) {
  if (playerc_keep(&device->intensities, data->intensities, data->intensities_count,
                   sizeof *data->intensities))
    device->intensities_count = data->intensities_count;
}

static void put_geom(playerc_ranger_t *device, const player_ranger_geom_t *geom) {
  const uint32_t poses = geom->element_poses_count, sizes = geom->element_sizes_count;
  const uint32_t count = poses < sizes || sizes == 0 ? poses : sizes;
  device->device_pose = geom->pose;
  device->device_size = geom->size;
  device->info.freshgeom = 1;
  device->element_count = 0;
  if (!playerc_keep(&device->element_poses, geom->element_poses, count, sizeof *geom->element_poses)) return;
  if (!playerc_room(&device->element_sizes, count, sizeof *geom->element_sizes)) return;
  memset(device->element_sizes, 0, count * sizeof *device->element_sizes);
  if (sizes > 0) memcpy(device->element_sizes, geom->element_sizes, count * sizeof *device->element_sizes);
  device->element_count = count;
}

static void put_config(playerc_ranger_t *device, const player_ranger_config_t *config) {
  device->min_angle = config->min_angle;
  device->max_angle = config->max_angle;
  device->angular_res = config->angular_res;
  device->min_range = config->min_range;
  device->max_range = config->max_range;
  device->range_res = config->range_res;
  device->frequency = config->frequency;
  device->info.freshconfig = 1;
}

static void put(void *proxy, char *header, char *body) {
  playerc_ranger_t *device = proxy;
  const void *message = body;
  const player_ranger_data_rangestamped_t *ranges = message;
  const player_ranger_data_intnsstamped_t *intensities = message;
  switch (playerc_subtype(header)) {
    case PLAYER_RANGER_DATA_RANGE:
      put_ranges(device, message);
      break;
    case PLAYER_RANGER_DATA_RANGESTAMPED:
      if (ranges->have_geom != 0) put_geom(device, &ranges->geom);
      if (ranges->have_config != 0) put_config(device, &ranges->config);
      put_ranges(device, &ranges->data);
      break;
    case PLAYER_RANGER_DATA_INTNS:
      put_intensities(device, message);
      break;
    case PLAYER_RANGER_DATA_INTNSSTAMPED:
      if (intensities->have_geom != 0) put_geom(device, &intensities->geom);
      if (intensities->have_config != 0) put_config(device, &intensities->config);
      put_intensities(device, &intensities->data);
      break;
    case PLAYER_RANGER_DATA_GEOM:
      put_geom(device, message);
      break;
    default:
      break;
  }
}

static void release(playerc_ranger_t *device) {
  free(device->element_poses);
  free(device->element_sizes);
  free(device->ranges);
  free(device->intensities);
  free(device->bearings);
  free(device->points);
}

PLAYERC_PROXY(ranger, PLAYER_RANGER_CODE, put, release)

int playerc_ranger_get_geom(playerc_ranger_t *device) {
  player_ranger_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_RANGER_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_geom(device, geom);
  player_ranger_geom_t_free(geom);
  return result;
}

int playerc_ranger_power_config(playerc_ranger_t *device, uint8_t value) {
  const player_ranger_power_config_t wanted = {value};
  return playerc_tell(&device->info, PLAYER_RANGER_REQ_POWER, &wanted);
}

int playerc_ranger_intns_config(playerc_ranger_t *device, uint8_t value) {
  const player_ranger_intns_config_t wanted = {value};
  return playerc_tell(&device->info, PLAYER_RANGER_REQ_INTNS, &wanted);
}

int playerc_ranger_set_config(playerc_ranger_t *device, double min_angle, double max_angle,
                              double angular_res, double min_range, double max_range, double range_res,
                              double frequency) {
  const player_ranger_config_t wanted = {min_angle, max_angle, angular_res, min_range,
                                         max_range, range_res, frequency};
  const int result = playerc_tell(&device->info, PLAYER_RANGER_REQ_SET_CONFIG, &wanted);
  if (result == 0) put_config(device, &wanted);
  return result;
}

int playerc_ranger_get_config(playerc_ranger_t *device, double *min_angle, double *max_angle,
                              double *angular_res, double *min_range, double *max_range, double *range_res,
                              double *frequency) {
  player_ranger_config_t *config = NULL;
  const int result = playerc_ask(&device->info, PLAYER_RANGER_REQ_GET_CONFIG, NULL, &config);
  if (result != 0) return result;
  put_config(device, config);
  player_ranger_config_t_free(config);
  const struct {
    double *to, from;
  } told[] = {{min_angle, device->min_angle},     {max_angle, device->max_angle},
              {angular_res, device->angular_res}, {min_range, device->min_range},
              {max_range, device->max_range},     {range_res, device->range_res},
              {frequency, device->frequency}};
  for (size_t i = 0; i < sizeof told / sizeof *told; ++i) {
    if (told[i].to != NULL) *told[i].to = told[i].from;
  }
  return 0;
}
