/** Arms and hands: gripper, actarray, limb. */
#include "inside.h"

// --- gripper

static void put_gripper(void *proxy, char *header, char *body) {
  playerc_gripper_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_GRIPPER_DATA_STATE) return;
  const player_gripper_data_t *data = message;
  device->state = data->state;
  device->beams = data->beams;
  device->stored = data->stored;
}

PLAYERC_PROXY(gripper, PLAYER_GRIPPER_CODE, put_gripper, PLAYERC_NO_LISTS)

int playerc_gripper_open_cmd(playerc_gripper_t *device) {
  return playerc_command(&device->info, PLAYER_GRIPPER_CMD_OPEN, NULL);
}
int playerc_gripper_close_cmd(playerc_gripper_t *device) {
  return playerc_command(&device->info, PLAYER_GRIPPER_CMD_CLOSE, NULL);
}
int playerc_gripper_stop_cmd(playerc_gripper_t *device) {
  return playerc_command(&device->info, PLAYER_GRIPPER_CMD_STOP, NULL);
}
int playerc_gripper_store_cmd(playerc_gripper_t *device) {
  return playerc_command(&device->info, PLAYER_GRIPPER_CMD_STORE, NULL);
}
int playerc_gripper_retrieve_cmd(playerc_gripper_t *device) {
  return playerc_command(&device->info, PLAYER_GRIPPER_CMD_RETRIEVE, NULL);
}

void playerc_gripper_printout(playerc_gripper_t *device, const char *prefix) {
  static const char *const states[] = {"unknown", "open", "closed", "moving", "failed"};
  const size_t known = sizeof states / sizeof *states;
  printf("%s%sgripper %s, beams 0x%x, %u stored\n", prefix != NULL ? prefix : "", prefix != NULL ? ": " : "",
         states[device->state < known ? device->state : 0], device->beams, device->stored);
}

int playerc_gripper_get_geom(playerc_gripper_t *device) {
  player_gripper_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_GRIPPER_REQ_GET_GEOM, NULL, &geom);
  if (result != 0) return result;
  device->pose = geom->pose;
  device->outer_size = geom->outer_size;
  device->inner_size = geom->inner_size;
  device->num_beams = geom->num_beams;
  device->capacity = geom->capacity;
  player_gripper_geom_t_free(geom);
  return 0;
}

// --- actarray

static void put_actarray(void *proxy, char *header, char *body) {
  playerc_actarray_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_ACTARRAY_DATA_STATE) return;
  const player_actarray_data_t *data = message;
  device->motor_state = data->motor_state;
  if (playerc_keep(&device->actuators_data, data->actuators, data->actuators_count, sizeof *data->actuators))
    device->actuators_count = data->actuators_count;
}

static void release_actarray(playerc_actarray_t *device) {
  free(device->actuators_data);
  free(device->actuators_geom);
}

PLAYERC_PROXY(actarray, PLAYER_ACTARRAY_CODE, put_actarray, release_actarray)

player_actarray_actuator_t playerc_actarray_get_actuator_data(playerc_actarray_t *device, uint32_t index) {
  static const player_actarray_actuator_t none;
  return index < device->actuators_count ? device->actuators_data[index] : none;
}

player_actarray_actuatorgeom_t playerc_actarray_get_actuator_geom(playerc_actarray_t *device,
                                                                  uint32_t index) {
  static const player_actarray_actuatorgeom_t none;
  return index < device->actuators_geom_count ? device->actuators_geom[index] : none;
}

int playerc_actarray_get_geom(playerc_actarray_t *device) {
  player_actarray_geom_t *geom = NULL;
  int result = playerc_ask(&device->info, PLAYER_ACTARRAY_REQ_GET_GEOM, NULL, &geom);
  if (result != 0) return result;
  device->base_pos = geom->base_pos;
  device->base_orientation = geom->base_orientation;
  if (playerc_keep(&device->actuators_geom, geom->actuators, geom->actuators_count,
                   sizeof *geom->actuators)) {
    device->actuators_geom_count = geom->actuators_count;
  } else {
    result = playerc_fail_no_memory();
  }
  player_actarray_geom_t_free(geom);
  return result;
}

int playerc_actarray_position_cmd(playerc_actarray_t *device, int joint, float position) {
  const player_actarray_position_cmd_t command = {joint, position};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_POS, &command);
}

int playerc_actarray_multi_position_cmd(playerc_actarray_t *device, float *positions, int positions_count) {
  const player_actarray_multi_position_cmd_t command = {(uint32_t)positions_count, positions};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_MULTI_POS, &command);
}

int playerc_actarray_speed_cmd(playerc_actarray_t *device, int joint, float speed) {
  const player_actarray_speed_cmd_t command = {joint, speed};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_SPEED, &command);
}

int playerc_actarray_multi_speed_cmd(playerc_actarray_t *device, float *speeds, int speeds_count) {
  const player_actarray_multi_speed_cmd_t command = {(uint32_t)speeds_count, speeds};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_MULTI_SPEED, &command);
}

int playerc_actarray_home_cmd(playerc_actarray_t *device, int joint) {
  const player_actarray_home_cmd_t command = {joint};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_HOME, &command);
}

int playerc_actarray_current_cmd(playerc_actarray_t *device, int joint, float current) {
  const player_actarray_current_cmd_t command = {joint, current};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_CURRENT, &command);
}

int playerc_actarray_multi_current_cmd(playerc_actarray_t *device, float *currents, int currents_count) {
  const player_actarray_multi_current_cmd_t command = {(uint32_t)currents_count, currents};
  return playerc_command(&device->info, PLAYER_ACTARRAY_CMD_MULTI_CURRENT, &command);
}

int playerc_actarray_power(playerc_actarray_t *device, uint8_t enable) {
  const player_actarray_power_config_t wanted = {enable};
  return playerc_tell(&device->info, PLAYER_ACTARRAY_REQ_POWER, &wanted);
}

int playerc_actarray_brakes(playerc_actarray_t *device, uint8_t enable) {
  const player_actarray_brakes_config_t wanted = {enable};
  return playerc_tell(&device->info, PLAYER_ACTARRAY_REQ_BRAKES, &wanted);
}

int playerc_actarray_speed_config(playerc_actarray_t *device, int joint, float speed) {
  const player_actarray_speed_config_t wanted = {joint, speed};
  return playerc_tell(&device->info, PLAYER_ACTARRAY_REQ_SPEED, &wanted);
}

int playerc_actarray_accel_config(playerc_actarray_t *device, int joint, float accel) {
  const player_actarray_accel_config_t wanted = {joint, accel};
  return playerc_tell(&device->info, PLAYER_ACTARRAY_REQ_ACCEL, &wanted);
}

// --- limb

static void put_limb(void *proxy, char *header, char *body) {
  playerc_limb_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_LIMB_DATA_STATE) device->data = *(const player_limb_data_t *)message;
}

PLAYERC_PROXY(limb, PLAYER_LIMB_CODE, put_limb, PLAYERC_NO_LISTS)

int playerc_limb_get_geom(playerc_limb_t *device) {
  player_limb_geom_req_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_LIMB_REQ_GEOM, NULL, &geom);
  if (result == 0) device->geom = *geom;
  player_limb_geom_req_t_free(geom);
  return result;
}

int playerc_limb_home_cmd(playerc_limb_t *device) {
  return playerc_command(&device->info, PLAYER_LIMB_CMD_HOME, NULL);
}
int playerc_limb_stop_cmd(playerc_limb_t *device) {
  return playerc_command(&device->info, PLAYER_LIMB_CMD_STOP, NULL);
}

int playerc_limb_setpose_cmd(playerc_limb_t *device, float pX, float pY, float pZ, float aX, float aY,
                             float aZ, float oX, float oY, float oZ) {
  const player_limb_setpose_cmd_t command = {{(double)pX, (double)pY, (double)pZ},
                                             {(double)aX, (double)aY, (double)aZ},
                                             {(double)oX, (double)oY, (double)oZ}};
  return playerc_command(&device->info, PLAYER_LIMB_CMD_SETPOSE, &command);
}

int playerc_limb_setposition_cmd(playerc_limb_t *device, float pX, float pY, float pZ) {
  const player_limb_setposition_cmd_t command = {{(double)pX, (double)pY, (double)pZ}};
  return playerc_command(&device->info, PLAYER_LIMB_CMD_SETPOSITION, &command);
}

int playerc_limb_vecmove_cmd(playerc_limb_t *device, float x, float y, float z, float length) {
  const player_limb_vecmove_cmd_t command = {{(double)x, (double)y, (double)z}, length};
  return playerc_command(&device->info, PLAYER_LIMB_CMD_VECMOVE, &command);
}

int playerc_limb_power(playerc_limb_t *device, uint32_t enable) {
  const player_limb_power_req_t wanted = {(uint8_t)(enable != 0)};
  return playerc_tell(&device->info, PLAYER_LIMB_REQ_POWER, &wanted);
}

int playerc_limb_brakes(playerc_limb_t *device, uint32_t enable) {
  const player_limb_brakes_req_t wanted = {(uint8_t)(enable != 0)};
  return playerc_tell(&device->info, PLAYER_LIMB_REQ_BRAKES, &wanted);
}

int playerc_limb_speed_config(playerc_limb_t *device, float speed) {
  const player_limb_speed_req_t wanted = {speed};
  return playerc_tell(&device->info, PLAYER_LIMB_REQ_SPEED, &wanted);
}
