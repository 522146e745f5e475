/** The way through a map: localize, planner. */
#include <string.h>

#include "inside.h"

enum { MOST_WAYPOINTS = 1 << 20 };  // that data may announce

// --- localize

static void put_localize(void *proxy, char *header, char *body) {
  playerc_localize_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_LOCALIZE_DATA_HYPOTHS) return;
  const player_localize_data_t *data = message;
  device->pending_count = (int)data->pending_count;
  device->pending_time = data->pending_time;
  if (playerc_keep(&device->hypoths, data->hypoths, data->hypoths_count, sizeof *data->hypoths))
    device->hypoth_count = (int)data->hypoths_count;
}

static void release_localize(playerc_localize_t *device) {
  free(device->hypoths);
  free(device->particles);
}

PLAYERC_PROXY(localize, PLAYER_LOCALIZE_CODE, put_localize, release_localize)

int playerc_localize_set_pose_of(playerc_localize_t *device, const double pose[3], const double *cov,
                                 size_t cov_count) {
  player_localize_set_pose_t wanted = {.mean = {pose[0], pose[1], pose[2]}};
  memcpy(wanted.cov, cov, cov_count * sizeof *cov);
  return playerc_tell(&device->info, PLAYER_LOCALIZE_REQ_SET_POSE, &wanted);
}

/** For programs that are built already, and those that take its address. */
int(playerc_localize_set_pose)(playerc_localize_t *device, double pose[3], double cov[6]) {
  return playerc_localize_set_pose_of(device, pose, cov, 6);
}

int playerc_localize_get_particles(playerc_localize_t *device) {
  player_localize_get_particles_t *told = NULL;
  int result = playerc_ask(&device->info, PLAYER_LOCALIZE_REQ_GET_PARTICLES, NULL, &told);
  if (result != 0) return result;
  device->mean[0] = told->mean.px;
  device->mean[1] = told->mean.py;
  device->mean[2] = told->mean.pa;
  device->variance = told->variance;
  if (playerc_room(&device->particles, told->particles_count, sizeof *device->particles)) {
    device->num_particles = (int)told->particles_count;
    for (uint32_t i = 0; i < told->particles_count; ++i) {
      const player_pose2d_t *at = &told->particles[i].pose;
      device->particles[i] =
          (playerc_localize_particle_t){{at->px, at->py, at->pa}, told->particles[i].alpha};
    }
  } else {
    result = playerc_fail_no_memory();
  }
  player_localize_get_particles_t_free(told);
  return result;
}

// --- planner

/** Their number comes with the data, before or without the list itself: what is not known of it is zeros. */
static void count_waypoints(playerc_planner_t *device, uint32_t count) {
  const uint32_t known = (uint32_t)device->waypoint_count;
  if (!playerc_room(&device->waypoints, count, sizeof *device->waypoints)) return;
  if (count > known) memset(device->waypoints + known, 0, (count - known) * sizeof *device->waypoints);
  device->waypoint_count = (int)count;
}

static void put_planner(void *proxy, char *header, char *body) {
  playerc_planner_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_PLANNER_DATA_STATE) return;
  const player_planner_data_t *data = message;
  device->path_valid = data->valid;
  device->path_done = data->done;
  device->px = data->pos.px;
  device->py = data->pos.py;
  device->pa = data->pos.pa;
  device->gx = data->goal.px;
  device->gy = data->goal.py;
  device->ga = data->goal.pa;
  device->wx = data->waypoint.px;
  device->wy = data->waypoint.py;
  device->wa = data->waypoint.pa;
  device->curr_waypoint = data->waypoint_idx;
  if (data->waypoints_count < MOST_WAYPOINTS) count_waypoints(device, data->waypoints_count);
}

static void release_planner(playerc_planner_t *device) {
  free(device->waypoints);
}

PLAYERC_PROXY(planner, PLAYER_PLANNER_CODE, put_planner, release_planner)

int playerc_planner_set_cmd_pose(playerc_planner_t *device, double gx, double gy, double ga) {
  const player_planner_cmd_t command = {{gx, gy, ga}};
  return playerc_command(&device->info, PLAYER_PLANNER_CMD_GOAL, &command);
}

int playerc_planner_set_cmd_start(playerc_planner_t *device, double sx, double sy, double sa) {
  const player_planner_cmd_t command = {{sx, sy, sa}};
  return playerc_command(&device->info, PLAYER_PLANNER_CMD_START, &command);
}

int playerc_planner_get_waypoints(playerc_planner_t *device) {
  player_planner_waypoints_req_t *way = NULL;
  int result = playerc_ask(&device->info, PLAYER_PLANNER_REQ_GET_WAYPOINTS, NULL, &way);
  if (result != 0) return result;
  if (playerc_room(&device->waypoints, way->waypoints_count, sizeof *device->waypoints)) {
    device->waypoint_count = (int)way->waypoints_count;
    device->waypoint_distance = way->waypoints_distance;
    for (uint32_t i = 0; i < way->waypoints_count; ++i) {
      device->waypoints[i][0] = way->waypoints[i].px;
      device->waypoints[i][1] = way->waypoints[i].py;
      device->waypoints[i][2] = way->waypoints[i].pa;
    }
  } else {
    result = playerc_fail_no_memory();
  }
  player_planner_waypoints_req_t_free(way);
  return result;
}

int playerc_planner_enable(playerc_planner_t *device, int state) {
  const player_planner_enable_req_t wanted = {(uint8_t)(state != 0)};
  return playerc_tell(&device->info, PLAYER_PLANNER_REQ_ENABLE, &wanted);
}
