/** Where and how the robot is: gps, imu, pointcloud3d, power, health. */
#include "inside.h"

// --- gps

static void put_gps(void *proxy, char *header, char *body) {
  playerc_gps_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_GPS_DATA_STATE) return;
  const player_gps_data_t *data = message;
  device->utc_time = data->time_sec + 1e-6 * data->time_usec;
  device->lat = 1e-7 * data->latitude;
  device->lon = 1e-7 * data->longitude;
  device->alt = 1e-3 * data->altitude;
  device->speed = data->speed;
  device->course = data->course;
  device->utm_e = data->utm_e;
  device->utm_n = data->utm_n;
  device->hdop = 0.1 * data->hdop;
  device->vdop = 0.1 * data->vdop;
  device->err_horz = data->err_horz;
  device->err_vert = data->err_vert;
  device->quality = (int)data->quality;
  device->sat_count = (int)data->num_sats;
}

PLAYERC_PROXY(gps, PLAYER_GPS_CODE, put_gps, PLAYERC_NO_LISTS)

// --- imu

static void put_quaternion(playerc_imu_t *device, const player_imu_data_quat_t *data) {
  device->calib_data = data->calib_data;
  device->q0 = data->q0;
  device->q1 = data->q1;
  device->q2 = data->q2;
  device->q3 = data->q3;
}

static void put_euler(playerc_imu_t *device, const player_imu_data_euler_t *data) {
  device->calib_data = data->calib_data;
  device->pose.proll = data->orientation.proll;
  device->pose.ppitch = data->orientation.ppitch;
  device->pose.pyaw = data->orientation.pyaw;
}

static void put_full(playerc_imu_t *device, const player_imu_data_fullstate_t *data) {
  device->pose = data->pose;
  device->vel = data->vel;
  device->acc = data->acc;
}

static void put_imu(void *proxy, char *header, char *body) {
  playerc_imu_t *device = proxy;
  const void *message = body;
  switch (playerc_subtype(header)) {
    case PLAYER_IMU_DATA_STATE:
      device->pose = ((const player_imu_data_state_t *)message)->pose;
      break;
    case PLAYER_IMU_DATA_CALIB:
      device->calib_data = *(const player_imu_data_calib_t *)message;
      break;
    case PLAYER_IMU_DATA_QUAT:
      put_quaternion(device, message);
      break;
    case PLAYER_IMU_DATA_EULER:
      put_euler(device, message);
      break;
    case PLAYER_IMU_DATA_FULLSTATE:
      put_full(device, message);
      break;
    default:
      break;
  }
}

PLAYERC_PROXY(imu, PLAYER_IMU_CODE, put_imu, PLAYERC_NO_LISTS)

int playerc_imu_datatype(playerc_imu_t *device, int value) {
  const player_imu_datatype_config_t wanted = {(uint8_t)value};
  return playerc_tell(&device->info, PLAYER_IMU_REQ_SET_DATATYPE, &wanted);
}

int playerc_imu_reset_orientation(playerc_imu_t *device, int value) {
  const player_imu_reset_orientation_config_t wanted = {(uint32_t)value};
  return playerc_tell(&device->info, PLAYER_IMU_REQ_RESET_ORIENTATION, &wanted);
}

int playerc_imu_reset_euler(playerc_imu_t *device, float roll, float pitch, float yaw) {
  const player_imu_reset_euler_config_t wanted = {{0.0, 0.0, 0.0, (double)roll, (double)pitch, (double)yaw}};
  return playerc_tell(&device->info, PLAYER_IMU_REQ_RESET_EULER, &wanted);
}

// --- pointcloud3d

static void put_points(void *proxy, char *header, char *body) {
  playerc_pointcloud3d_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_POINTCLOUD3D_DATA_STATE) return;
  const player_pointcloud3d_data_t *data = message;
  const uint16_t count = data->points_count < UINT16_MAX ? (uint16_t)data->points_count : UINT16_MAX;
  if (playerc_keep(&device->points, data->points, count, sizeof *data->points)) device->points_count = count;
}

static void release_points(playerc_pointcloud3d_t *device) {
  free(device->points);
}

PLAYERC_PROXY(pointcloud3d, PLAYER_POINTCLOUD3D_CODE, put_points, release_points)

// --- power

static void put_power(void *proxy, char *header, char *body) {
  playerc_power_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_POWER_DATA_STATE) return;
  const player_power_data_t *data = message;
  device->valid = (int)data->valid;
  device->charge = (double)data->volts;
  device->percent = (double)data->percent;
  device->joules = (double)data->joules;
  device->watts = (double)data->watts;
  device->charging = data->charging;
}

PLAYERC_PROXY(power, PLAYER_POWER_CODE, put_power, PLAYERC_NO_LISTS)

// --- health

static void put_health(void *proxy, char *header, char *body) {
  playerc_health_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_HEALTH_DATA_STATE) return;
  const player_health_data_t *data = message;
  device->cpu_usage = data->cpu_usage;
  device->mem = data->mem;
  device->swap = data->swap;
}

PLAYERC_PROXY(health, PLAYER_HEALTH_CODE, put_health, PLAYERC_NO_LISTS)
