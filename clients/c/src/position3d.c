#include "playhouse/c/position3d.h"

#include "playhouse/c/generated/position3d.h"
#include "proxy.h"

struct ph_position3d {
  ph_device device;
  bool moving; /**< by the last command */
};

static void stop_moving(ph_device *device) {
  if (((ph_position3d *)device)->moving) ph_position3d_stop((ph_position3d *)device, NULL);
}

const ph_class ph_position3d_class = {
    .interface_name = "position3d", .size = sizeof(ph_position3d), .before_close = stop_moving};
PH_DEFINE_PROXY(position3d)

ph_status ph_position3d_state(ph_position3d *robot, ph_state3d *state, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&robot->device, PH_POSITION3D_DATA_STATE, &value, error));
  const ph_position3d_data *data = value->data;
  *state = (ph_state3d){ph_pose3d_of(data->pos), ph_pose3d_of(data->vel), data->stall != 0, value->timestamp};
  return PH_OK;
}

ph_status ph_position3d_drive(ph_position3d *robot, double vx, double va, double vy, double vz,
                              ph_error *error) {
  PH_INSIST_ON_FINITE(&robot->device, error, {"vx", vx}, {"va", va}, {"vy", vy}, {"vz", vz});
  const ph_position3d_cmd_vel command = {.vel = {vx, vy, vz, 0.0, 0.0, va}, .state = 1};
  robot->moving = vx != 0.0 || vy != 0.0 || vz != 0.0 || va != 0.0;
  return ph_device_command(&robot->device, PH_POSITION3D_CMD_SET_VEL, &command, error);
}

ph_status ph_position3d_stop(ph_position3d *robot, ph_error *error) {
  return ph_position3d_drive(robot, 0.0, 0.0, 0.0, 0.0, error);
}

ph_status ph_position3d_go_to(ph_position3d *robot, ph_pose3d pose, ph_error *error) {
  PH_TRY(ph_insist_on_pose3d(&robot->device, pose, error));
  const ph_position3d_cmd_pos command = {.pos = ph_wire_pose3d(pose), .state = 1};
  robot->moving = true;
  return ph_device_command(&robot->device, PH_POSITION3D_CMD_SET_POS, &command, error);
}

ph_status ph_position3d_set_motor_power(ph_position3d *robot, bool on, ph_error *error) {
  const ph_position3d_power_config body = {on};
  return ph_device_tell(&robot->device, PH_POSITION3D_REQ_MOTOR_POWER, &body, error);
}

ph_status ph_position3d_set_odometry(ph_position3d *robot, ph_pose3d pose, ph_error *error) {
  PH_TRY(ph_insist_on_pose3d(&robot->device, pose, error));
  const ph_position3d_set_odom_req body = {ph_wire_pose3d(pose)};
  return ph_device_tell(&robot->device, PH_POSITION3D_REQ_SET_ODOM, &body, error);
}

ph_status ph_position3d_reset_odometry(ph_position3d *robot, ph_error *error) {
  return ph_device_tell(&robot->device, PH_POSITION3D_REQ_RESET_ODOM, NULL, error);
}

ph_status ph_position3d_geometry(ph_position3d *robot, ph_geometry *geometry, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&robot->device, PH_POSITION3D_REQ_GET_GEOM, NULL, &answer, error));
  const ph_position3d_geom *geom = answer->data;
  *geometry = ph_geometry_of(geom->pose, geom->size);
  ph_value_free(answer);
  return PH_OK;
}
