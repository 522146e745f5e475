/** What cameras and scanners find, and what turns them: blobfinder, fiducial, ptz. */
#include "inside.h"

// --- blobfinder

static void put_blobs(void *proxy, char *header, char *body) {
  playerc_blobfinder_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_BLOBFINDER_DATA_BLOBS) return;
  const player_blobfinder_data_t *data = message;
  device->width = data->width;
  device->height = data->height;
  if (playerc_keep(&device->blobs, data->blobs, data->blobs_count, sizeof *data->blobs))
    device->blobs_count = data->blobs_count;
}

static void release_blobs(playerc_blobfinder_t *device) {
  free(device->blobs);
}

PLAYERC_PROXY(blobfinder, PLAYER_BLOBFINDER_CODE, put_blobs, release_blobs)

// --- fiducial

static void put_fiducials(void *proxy, char *header, char *body) {
  playerc_fiducial_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_FIDUCIAL_DATA_SCAN) return;
  const player_fiducial_data_t *data = message;
  if (playerc_keep(&device->fiducials, data->fiducials, data->fiducials_count, sizeof *data->fiducials))
    device->fiducials_count = (int)data->fiducials_count;
}

static void release_fiducials(playerc_fiducial_t *device) {
  free(device->fiducials);
}

PLAYERC_PROXY(fiducial, PLAYER_FIDUCIAL_CODE, put_fiducials, release_fiducials)

int playerc_fiducial_get_geom(playerc_fiducial_t *device) {
  player_fiducial_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_FIDUCIAL_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) device->fiducial_geom = *geom;
  player_fiducial_geom_t_free(geom);
  return result;
}

// --- ptz

static void put_ptz(void *proxy, char *header, char *body) {
  playerc_ptz_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_PTZ_DATA_STATE) return;
  const player_ptz_data_t *data = message;
  device->pan = (double)data->pan;
  device->tilt = (double)data->tilt;
  device->zoom = (double)data->zoom;
  device->status = (int)data->status;
}

PLAYERC_PROXY(ptz, PLAYER_PTZ_CODE, put_ptz, PLAYERC_NO_LISTS)

int playerc_ptz_set_ws(playerc_ptz_t *device, double pan, double tilt, double zoom, double panspeed,
                       double tiltspeed) {
  const player_ptz_cmd_t command = {(float)pan, (float)tilt, (float)zoom, (float)panspeed, (float)tiltspeed};
  return playerc_command(&device->info, PLAYER_PTZ_CMD_STATE, &command);
}

int playerc_ptz_set(playerc_ptz_t *device, double pan, double tilt, double zoom) {
  return playerc_ptz_set_ws(device, pan, tilt, zoom, 0.0, 0.0);
}

int playerc_ptz_query_status(playerc_ptz_t *device) {
  player_ptz_req_status_t *told = NULL;
  const int result = playerc_ask(&device->info, PLAYER_PTZ_REQ_STATUS, NULL, &told);
  if (result == 0) device->status = (int)told->status;
  player_ptz_req_status_t_free(told);
  return result;
}

int playerc_ptz_set_control_mode(playerc_ptz_t *device, int mode) {
  const player_ptz_req_control_mode_t wanted = {(uint32_t)mode};
  return playerc_tell(&device->info, PLAYER_PTZ_REQ_CONTROL_MODE, &wanted);
}
