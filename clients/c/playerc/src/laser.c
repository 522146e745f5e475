#include <math.h>

#include "inside.h"

/** Makes the lists as long as the scan. */
static bool make_room(playerc_laser_t *device, size_t count) {
  return playerc_room(&device->ranges, count, sizeof *device->ranges) &&
         playerc_room(&device->scan, count, sizeof *device->scan) &&
         playerc_room(&device->point, count, sizeof *device->point) &&
         playerc_room(&device->intensity, count, sizeof *device->intensity);
}

static double shorter(double a, double b) {
  return b < a ? b : a;
}

/** The shortest range of both halves of the scan, its maximum range if a half has no beams. */
static void find_nearest(playerc_laser_t *device) {
  device->min_right = device->min_left = device->max_range;
  for (int i = 0; i < device->scan_count; ++i) {
    double *half = 2 * i < device->scan_count ? &device->min_right : &device->min_left;
    *half = shorter(*half, device->ranges[i]);
  }
}

/** Takes a scan whose beams go into the `angles`, or, if they are NULL, from scan_start in steps of scan_res. */
static void put_scan(playerc_laser_t *device, const float *ranges, uint32_t count, const float *angles,
                     const uint8_t *intensity, uint32_t intensity_count) {
  if (!make_room(device, count)) return;
  device->scan_count = (int)count;
  for (uint32_t i = 0; i < count; ++i) {
    const double range = (double)ranges[i];
    const double angle = angles != NULL ? (double)angles[i] : device->scan_start + i * device->scan_res;
    device->ranges[i] = device->scan[i][0] = range;
    device->scan[i][1] = angle;
    device->point[i].px = range * cos(angle);
    device->point[i].py = range * sin(angle);
    device->intensity[i] = i < intensity_count ? intensity[i] : 0;
  }
  find_nearest(device);
}

static void put_even(playerc_laser_t *device, const player_laser_data_t *data) {
  device->scan_start = (double)data->min_angle;
  device->scan_res = (double)data->resolution;
  device->max_range = (double)data->max_range;
  device->scan_id = (int)data->id;
  put_scan(device, data->ranges, data->ranges_count, NULL, data->intensity, data->intensity_count);
}

static void put_uneven(playerc_laser_t *device, const player_laser_data_scanangle_t *data) {
  const uint32_t count = data->angles_count < data->ranges_count ? data->angles_count : data->ranges_count;
  device->scan_start = count > 0 ? (double)data->angles[0] : 0.0;
  device->scan_res = 0.0;
  device->max_range = (double)data->max_range;
  device->scan_id = (int)data->id;
  put_scan(device, data->ranges, count, data->angles, data->intensity, data->intensity_count);
}

static void put(void *proxy, char *header, char *body) {
  playerc_laser_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_LASER_DATA_SCAN) put_even(device, message);
  if (playerc_subtype(header) == PLAYER_LASER_DATA_SCANANGLE) put_uneven(device, message);
  if (playerc_subtype(header) != PLAYER_LASER_DATA_SCANPOSE) return;
  const player_laser_data_scanpose_t *data = message;
  device->robot_pose[0] = data->pose.px;
  device->robot_pose[1] = data->pose.py;
  device->robot_pose[2] = data->pose.pa;
  put_even(device, &data->scan);
}

static void release(playerc_laser_t *device) {
  free(device->ranges);
  free(device->scan);
  free(device->point);
  free(device->intensity);
}

PLAYERC_PROXY(laser, PLAYER_LASER_CODE, put, release)

static void keep_config(playerc_laser_t *device, const player_laser_config_t *config) {
  device->range_res = (double)config->range_res;
  device->scanning_frequency = (double)config->scanning_frequency;
  device->intensity_on = config->intensity;
}

int playerc_laser_set_config(playerc_laser_t *device, double min_angle, double max_angle, double resolution,
                             double range_res, unsigned char intensity, double scanning_frequency) {
  const player_laser_config_t wanted = {.min_angle = (float)min_angle,
                                        .max_angle = (float)max_angle,
                                        .resolution = (float)resolution,
                                        .range_res = (float)range_res,
                                        .intensity = intensity,
                                        .scanning_frequency = (float)scanning_frequency};
  const int result = playerc_tell(&device->info, PLAYER_LASER_REQ_SET_CONFIG, &wanted);
  if (result == 0) keep_config(device, &wanted);
  return result;
}

int playerc_laser_get_config(playerc_laser_t *device, double *min_angle, double *max_angle,
                             double *resolution, double *range_res, unsigned char *intensity,
                             double *scanning_frequency) {
  player_laser_config_t *config = NULL;
  const int result = playerc_ask(&device->info, PLAYER_LASER_REQ_GET_CONFIG, NULL, &config);
  if (result != 0) return result;
  *min_angle = (double)config->min_angle;
  *max_angle = (double)config->max_angle;
  *resolution = (double)config->resolution;
  *range_res = (double)config->range_res;
  *intensity = config->intensity;
  *scanning_frequency = (double)config->scanning_frequency;
  keep_config(device, config);
  player_laser_config_t_free(config);
  return 0;
}

int playerc_laser_get_geom(playerc_laser_t *device) {
  player_laser_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_LASER_REQ_GET_GEOM, NULL, &geom);
  if (result != 0) return result;
  device->pose[0] = geom->pose.px;
  device->pose[1] = geom->pose.py;
  device->pose[2] = geom->pose.pyaw;
  device->size[0] = geom->size.sl;
  device->size[1] = geom->size.sw;
  player_laser_geom_t_free(geom);
  return 0;
}

int playerc_laser_get_id(playerc_laser_t *device) {
  player_laser_get_id_config_t *id = NULL;
  const int result = playerc_ask(&device->info, PLAYER_LASER_REQ_GET_ID, NULL, &id);
  if (result == 0) device->laser_id = (int)id->serial_number;
  player_laser_get_id_config_t_free(id);
  return result;
}

void playerc_laser_printout(playerc_laser_t *device, const char *prefix) {
  printf("%s%s%d beams from %.3f rad in steps of %.5f rad, up to %.3f m:", prefix != NULL ? prefix : "",
         prefix != NULL ? ": " : "", device->scan_count, device->scan_start, device->scan_res,
         device->max_range);
  for (int i = 0; i < device->scan_count; ++i) printf(" %.3f", device->ranges[i]);
  printf("\n");
}
