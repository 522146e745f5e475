#include "inside.h"

/** x, y and heading, or x, y, z where the device has its place in space; length and width. */
static void place(double pose[3], double size[2], const player_pose3d_t *at, double third,
                  const player_bbox3d_t *box) {
  pose[0] = at->px;
  pose[1] = at->py;
  pose[2] = third;
  size[0] = box->sl;
  size[1] = box->sw;
}

// --- position2d

static void put_geom2d(playerc_position2d_t *device, const player_position2d_geom_t *geom) {
  place(device->pose, device->size, &geom->pose, geom->pose.pyaw, &geom->size);
  device->info.freshgeom = 1;
}

static void put2d(void *proxy, char *header, char *body) {
  playerc_position2d_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_POSITION2D_DATA_GEOM) put_geom2d(device, message);
  if (playerc_subtype(header) != PLAYER_POSITION2D_DATA_STATE) return;
  const player_position2d_data_t *data = message;
  device->px = data->pos.px;
  device->py = data->pos.py;
  device->pa = data->pos.pa;
  device->vx = data->vel.px;
  device->vy = data->vel.py;
  device->va = data->vel.pa;
  device->stall = data->stall;
}

PLAYERC_PROXY(position2d, PLAYER_POSITION2D_CODE, put2d, PLAYERC_NO_LISTS)

int playerc_position2d_enable(playerc_position2d_t *device, int enable) {
  const player_position2d_power_config_t wanted = {(uint8_t)(enable != 0)};
  return playerc_tell(&device->info, PLAYER_POSITION2D_REQ_MOTOR_POWER, &wanted);
}

int playerc_position2d_get_geom(playerc_position2d_t *device) {
  player_position2d_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_POSITION2D_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_geom2d(device, geom);
  player_position2d_geom_t_free(geom);
  return result;
}

int playerc_position2d_set_cmd_vel(playerc_position2d_t *device, double vx, double vy, double va, int state) {
  const player_position2d_cmd_vel_t command = {{vx, vy, va}, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_POSITION2D_CMD_VEL, &command);
}

int playerc_position2d_set_cmd_pose_with_vel(playerc_position2d_t *device, player_pose2d_t pos,
                                             player_pose2d_t vel, int state) {
  const player_position2d_cmd_pos_t command = {pos, vel, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_POSITION2D_CMD_POS, &command);
}

int playerc_position2d_set_cmd_pose(playerc_position2d_t *device, double gx, double gy, double ga,
                                    int state) {
  const player_pose2d_t goal = {gx, gy, ga}, any = {0.0, 0.0, 0.0};
  return playerc_position2d_set_cmd_pose_with_vel(device, goal, any, state);
}

int playerc_position2d_set_cmd_vel_head(playerc_position2d_t *device, double vx, double vy, double pa,
                                        int state) {
  (void)vy;
  (void)state;
  const player_position2d_cmd_vel_head_t command = {vx, pa};
  return playerc_command(&device->info, PLAYER_POSITION2D_CMD_VEL_HEAD, &command);
}

int playerc_position2d_set_cmd_car(playerc_position2d_t *device, double vx, double a) {
  const player_position2d_cmd_car_t command = {vx, a};
  return playerc_command(&device->info, PLAYER_POSITION2D_CMD_CAR, &command);
}

int playerc_position2d_set_odom(playerc_position2d_t *device, double ox, double oy, double oa) {
  const player_position2d_set_odom_req_t wanted = {{ox, oy, oa}};
  return playerc_tell(&device->info, PLAYER_POSITION2D_REQ_SET_ODOM, &wanted);
}

// --- position3d

static void put_geom3d(playerc_position3d_t *device, const player_position3d_geom_t *geom) {
  place(device->pose, device->size, &geom->pose, geom->pose.pz, &geom->size);
  device->info.freshgeom = 1;
}

static void put3d(void *proxy, char *header, char *body) {
  playerc_position3d_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_POSITION3D_DATA_GEOMETRY) put_geom3d(device, message);
  if (playerc_subtype(header) != PLAYER_POSITION3D_DATA_STATE) return;
  const player_position3d_data_t *data = message;
  device->pos_x = data->pos.px;
  device->pos_y = data->pos.py;
  device->pos_z = data->pos.pz;
  device->pos_roll = data->pos.proll;
  device->pos_pitch = data->pos.ppitch;
  device->pos_yaw = data->pos.pyaw;
  device->vel_x = data->vel.px;
  device->vel_y = data->vel.py;
  device->vel_z = data->vel.pz;
  device->vel_roll = data->vel.proll;
  device->vel_pitch = data->vel.ppitch;
  device->vel_yaw = data->vel.pyaw;
  device->stall = data->stall;
}

PLAYERC_PROXY(position3d, PLAYER_POSITION3D_CODE, put3d, PLAYERC_NO_LISTS)

int playerc_position3d_enable(playerc_position3d_t *device, int enable) {
  const player_position3d_power_config_t wanted = {(uint8_t)(enable != 0)};
  return playerc_tell(&device->info, PLAYER_POSITION3D_REQ_MOTOR_POWER, &wanted);
}

int playerc_position3d_get_geom(playerc_position3d_t *device) {
  player_position3d_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_POSITION3D_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_geom3d(device, geom);
  player_position3d_geom_t_free(geom);
  return result;
}

int playerc_position3d_set_velocity(playerc_position3d_t *device, double vx, double vy, double vz, double vr,
                                    double vp, double vt, int state) {
  const player_position3d_cmd_vel_t command = {{vx, vy, vz, vr, vp, vt}, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_POSITION3D_CMD_SET_VEL, &command);
}

int playerc_position3d_set_speed(playerc_position3d_t *device, double vx, double vy, double vz, int state) {
  return playerc_position3d_set_velocity(device, vx, vy, vz, 0.0, 0.0, 0.0, state);
}

int playerc_position3d_set_pose_with_vel(playerc_position3d_t *device, player_pose3d_t pos,
                                         player_pose3d_t vel) {
  const player_position3d_cmd_pos_t command = {pos, vel, 1};
  return playerc_command(&device->info, PLAYER_POSITION3D_CMD_SET_POS, &command);
}

int playerc_position3d_set_pose(playerc_position3d_t *device, double gx, double gy, double gz, double gr,
                                double gp, double gt) {
  const player_pose3d_t goal = {gx, gy, gz, gr, gp, gt}, any = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  return playerc_position3d_set_pose_with_vel(device, goal, any);
}

int playerc_position3d_set_cmd_pose(playerc_position3d_t *device, double gx, double gy, double gz) {
  return playerc_position3d_set_pose(device, gx, gy, gz, 0.0, 0.0, 0.0);
}

int playerc_position3d_set_vel_mode(playerc_position3d_t *device, int mode) {
  const player_position3d_velocity_mode_config_t wanted = {(uint32_t)mode};
  return playerc_tell(&device->info, PLAYER_POSITION3D_REQ_VELOCITY_MODE, &wanted);
}

int playerc_position3d_set_odom(playerc_position3d_t *device, double ox, double oy, double oz, double oroll,
                                double opitch, double oyaw) {
  const player_position3d_set_odom_req_t wanted = {{ox, oy, oz, oroll, opitch, oyaw}};
  return playerc_tell(&device->info, PLAYER_POSITION3D_REQ_SET_ODOM, &wanted);
}

int playerc_position3d_reset_odom(playerc_position3d_t *device) {
  return playerc_tell(&device->info, PLAYER_POSITION3D_REQ_RESET_ODOM, NULL);
}

// --- position1d

static void put_geom1d(playerc_position1d_t *device, const player_position1d_geom_t *geom) {
  place(device->pose, device->size, &geom->pose, geom->pose.pyaw, &geom->size);
  device->info.freshgeom = 1;
}

static void put1d(void *proxy, char *header, char *body) {
  playerc_position1d_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_POSITION1D_DATA_GEOM) put_geom1d(device, message);
  if (playerc_subtype(header) != PLAYER_POSITION1D_DATA_STATE) return;
  const player_position1d_data_t *data = message;
  device->pos = (double)data->pos;
  device->vel = (double)data->vel;
  device->stall = data->stall;
  device->status = data->status;
}

PLAYERC_PROXY(position1d, PLAYER_POSITION1D_CODE, put1d, PLAYERC_NO_LISTS)

int playerc_position1d_enable(playerc_position1d_t *device, int enable) {
  const player_position1d_power_config_t wanted = {(uint8_t)(enable != 0)};
  return playerc_tell(&device->info, PLAYER_POSITION1D_REQ_MOTOR_POWER, &wanted);
}

int playerc_position1d_get_geom(playerc_position1d_t *device) {
  player_position1d_geom_t *geom = NULL;
  const int result = playerc_ask(&device->info, PLAYER_POSITION1D_REQ_GET_GEOM, NULL, &geom);
  if (result == 0) put_geom1d(device, geom);
  player_position1d_geom_t_free(geom);
  return result;
}

int playerc_position1d_set_cmd_vel(playerc_position1d_t *device, double vel, int state) {
  const player_position1d_cmd_vel_t command = {(float)vel, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_POSITION1D_CMD_VEL, &command);
}

int playerc_position1d_set_cmd_pos_with_vel(playerc_position1d_t *device, double pos, double vel, int state) {
  const player_position1d_cmd_pos_t command = {(float)pos, (float)vel, (uint8_t)state};
  return playerc_command(&device->info, PLAYER_POSITION1D_CMD_POS, &command);
}

int playerc_position1d_set_cmd_pos(playerc_position1d_t *device, double pos, int state) {
  return playerc_position1d_set_cmd_pos_with_vel(device, pos, 0.0, state);
}

int playerc_position1d_set_odom(playerc_position1d_t *device, double odom) {
  const player_position1d_set_odom_req_t wanted = {(float)odom};
  return playerc_tell(&device->info, PLAYER_POSITION1D_REQ_SET_ODOM, &wanted);
}
