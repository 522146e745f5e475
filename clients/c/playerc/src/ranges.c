/** Range finders of a few beams: sonar, ir, bumper. */
#include "inside.h"

// --- sonar

static void put_sonar_geom(playerc_sonar_t *device, const player_sonar_geom_t *geom) {
  if (!playerc_keep(&device->poses, geom->poses, geom->poses_count, sizeof *geom->poses)) return;
  device->pose_count = (int)geom->poses_count;
  device->info.freshgeom = 1;
}

static void put_sonar(void *proxy, char *header, char *body) {
  playerc_sonar_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_SONAR_DATA_GEOM) put_sonar_geom(device, message);
  if (playerc_subtype(header) != PLAYER_SONAR_DATA_RANGES) return;
  const player_sonar_data_t *data = message;
  if (!playerc_room(&device->scan, data->ranges_count, sizeof *device->scan)) return;
  device->scan_count = (int)data->ranges_count;
  for (uint32_t i = 0; i < data->ranges_count; ++i) device->scan[i] = (double)data->ranges[i];
}

static void release_sonar(playerc_sonar_t *device) {
  free(device->poses);
  free(device->scan);
}

PLAYERC_PROXY(sonar, PLAYER_SONAR_CODE, put_sonar, release_sonar)

int playerc_sonar_get_geom(playerc_sonar_t *device) {
  player_sonar_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_SONAR_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_sonar_geom(device, geom);
  player_sonar_geom_t_free(geom);
  return result;
}

// --- ir

static void put_ir(void *proxy, char *header, char *body) {
  playerc_ir_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_IR_DATA_RANGES) return;
  player_ir_data_t_cleanup(&device->data);
  player_ir_data_t_copy(&device->data, message);
}

static void release_ir(playerc_ir_t *device) {
  player_ir_data_t_cleanup(&device->data);
  player_ir_pose_t_cleanup(&device->poses);
}

PLAYERC_PROXY(ir, PLAYER_IR_CODE, put_ir, release_ir)

int playerc_ir_get_geom(playerc_ir_t *device) {
  player_ir_pose_t *poses = NULL;
  const int result = playerc_ask(&device->info, PLAYER_IR_REQ_POSE, NULL, &poses);
  if (result != 0) return result;
  player_ir_pose_t_cleanup(&device->poses);
  device->poses = *poses;  // with its list
  free(poses);
  return 0;
}

// --- bumper

static void put_bumper_geom(playerc_bumper_t *device, const player_bumper_geom_t *geom) {
  if (!playerc_keep(&device->poses, geom->bumper_def, geom->bumper_def_count, sizeof *geom->bumper_def))
    return;
  device->pose_count = (int)geom->bumper_def_count;
  device->info.freshgeom = 1;
}

static void put_bumper(void *proxy, char *header, char *body) {
  playerc_bumper_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_BUMPER_DATA_GEOM) put_bumper_geom(device, message);
  if (playerc_subtype(header) != PLAYER_BUMPER_DATA_STATE) return;
  const player_bumper_data_t *data = message;
  if (playerc_keep(&device->bumpers, data->bumpers, data->bumpers_count, sizeof *data->bumpers))
    device->bumper_count = (int)data->bumpers_count;
}

static void release_bumper(playerc_bumper_t *device) {
  free(device->poses);
  free(device->bumpers);
}

PLAYERC_PROXY(bumper, PLAYER_BUMPER_CODE, put_bumper, release_bumper)

int playerc_bumper_get_geom(playerc_bumper_t *device) {
  player_bumper_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_BUMPER_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_bumper_geom(device, geom);
  player_bumper_geom_t_free(geom);
  return result;
}
