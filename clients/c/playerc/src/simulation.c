#include <string.h>

#include "inside.h"

PLAYERC_PROXY(simulation, PLAYER_SIMULATION_CODE, NULL, PLAYERC_NO_LISTS)

int playerc_simulation_set_pose2d(playerc_simulation_t *device, const char *name, double gx, double gy,
                                  double ga) {
  const player_simulation_pose2d_req_t wanted = {playerc_text_count(name), playerc_text(name), {gx, gy, ga}};
  return playerc_tell(&device->info, PLAYER_SIMULATION_REQ_SET_POSE2D, &wanted);
}

int playerc_simulation_get_pose2d(playerc_simulation_t *device, const char *name, double *x, double *y,
                                  double *a) {
  const player_simulation_pose2d_req_t question = {
      playerc_text_count(name), playerc_text(name), {0.0, 0.0, 0.0}};
  player_simulation_pose2d_req_t *answer = NULL;
  const int result = playerc_ask(&device->info, PLAYER_SIMULATION_REQ_GET_POSE2D, &question, &answer);
  if (result != 0) return result;
  *x = answer->pose.px;
  *y = answer->pose.py;
  *a = answer->pose.pa;
  player_simulation_pose2d_req_t_free(answer);
  return 0;
}

int playerc_simulation_set_pose3d(playerc_simulation_t *device, const char *name, double gx, double gy,
                                  double gz, double groll, double gpitch, double gyaw) {
  const player_simulation_pose3d_req_t wanted = {
      playerc_text_count(name), playerc_text(name), {gx, gy, gz, groll, gpitch, gyaw}, 0.0};
  return playerc_tell(&device->info, PLAYER_SIMULATION_REQ_SET_POSE3D, &wanted);
}

int playerc_simulation_get_pose3d(playerc_simulation_t *device, const char *name, double *x, double *y,
                                  double *z, double *roll, double *pitch, double *yaw, double *time) {
  const player_simulation_pose3d_req_t question = {.name_count = playerc_text_count(name),
                                                   .name = playerc_text(name)};
  player_simulation_pose3d_req_t *answer = NULL;
  const int result = playerc_ask(&device->info, PLAYER_SIMULATION_REQ_GET_POSE3D, &question, &answer);
  if (result != 0) return result;
  *x = answer->pose.px;
  *y = answer->pose.py;
  *z = answer->pose.pz;
  *roll = answer->pose.proll;
  *pitch = answer->pose.ppitch;
  *yaw = answer->pose.pyaw;
  *time = answer->simtime;
  player_simulation_pose3d_req_t_free(answer);
  return 0;
}

int playerc_simulation_set_property(playerc_simulation_t *device, const char *name, const char *property,
                                    void *value, size_t value_len) {
  const player_simulation_property_req_t wanted = {.name_count = playerc_text_count(name),
                                                   .name = playerc_text(name),
                                                   .prop_count = playerc_text_count(property),
                                                   .prop = playerc_text(property),
                                                   .value_count = (uint32_t)value_len,
                                                   .value = value};
  return playerc_tell(&device->info, PLAYER_SIMULATION_REQ_SET_PROPERTY, &wanted);
}

int playerc_simulation_get_property(playerc_simulation_t *device, const char *name, const char *property,
                                    void *value, size_t value_len) {
  char *room = calloc(1, value_len + 1);  // the question has room for the answer
  if (room == NULL) return playerc_fail_no_memory();
  const player_simulation_property_req_t question = {.name_count = playerc_text_count(name),
                                                     .name = playerc_text(name),
                                                     .prop_count = playerc_text_count(property),
                                                     .prop = playerc_text(property),
                                                     .value_count = (uint32_t)value_len,
                                                     .value = room};
  player_simulation_property_req_t *answer = NULL;
  const int result = playerc_ask(&device->info, PLAYER_SIMULATION_REQ_GET_PROPERTY, &question, &answer);
  free(room);
  if (result != 0) return result;
  const size_t told = answer->value_count < value_len ? answer->value_count : value_len;
  if (told > 0) memcpy(value, answer->value, told);
  player_simulation_property_req_t_free(answer);
  return 0;
}

int playerc_simulation_pause(playerc_simulation_t *device) {
  return playerc_command(&device->info, PLAYER_SIMULATION_CMD_PAUSE, NULL);
}

int playerc_simulation_reset(playerc_simulation_t *device) {
  return playerc_command(&device->info, PLAYER_SIMULATION_CMD_RESET, NULL);
}

int playerc_simulation_save(playerc_simulation_t *device) {
  return playerc_command(&device->info, PLAYER_SIMULATION_CMD_SAVE, NULL);
}
