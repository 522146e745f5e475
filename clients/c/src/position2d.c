#include "playhouse/c/position2d.h"

#include "playhouse/c/generated/position2d.h"
#include "proxy.h"

struct ph_position2d {
  ph_device device;
  bool moving; /**< by the last command */
};

static void stop_moving(ph_device *device) {
  if (((ph_position2d *)device)->moving) ph_position2d_stop((ph_position2d *)device, NULL);
}

const ph_class ph_position2d_class = {
    .interface_name = "position2d", .size = sizeof(ph_position2d), .before_close = stop_moving};
PH_DEFINE_PROXY(position2d)

ph_status ph_position2d_state(ph_position2d *robot, ph_state *state, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&robot->device, PH_POSITION2D_DATA_STATE, &value, error));
  const ph_position2d_data *data = value->data;
  *state = (ph_state){
      ph_pose_of(data->pos), {data->vel.px, data->vel.py, data->vel.pa}, data->stall != 0, value->timestamp};
  return PH_OK;
}

ph_status ph_position2d_drive(ph_position2d *robot, double vx, double va, double vy, ph_error *error) {
  PH_INSIST_ON_FINITE(&robot->device, error, {"vx", vx}, {"va", va}, {"vy", vy});
  const ph_position2d_cmd_vel command = {.vel = {vx, vy, va}, .state = 1};
  robot->moving = vx != 0.0 || vy != 0.0 || va != 0.0;
  return ph_device_command(&robot->device, PH_POSITION2D_CMD_VEL, &command, error);
}

ph_status ph_position2d_stop(ph_position2d *robot, ph_error *error) {
  return ph_position2d_drive(robot, 0.0, 0.0, 0.0, error);
}

ph_status ph_position2d_drive_car(ph_position2d *robot, double speed, double steering, ph_error *error) {
  PH_INSIST_ON_FINITE(&robot->device, error, {"speed", speed}, {"steering", steering});
  const ph_position2d_cmd_car command = {speed, steering};
  robot->moving = speed != 0.0;
  return ph_device_command(&robot->device, PH_POSITION2D_CMD_CAR, &command, error);
}

ph_status ph_position2d_go_to(ph_position2d *robot, ph_pose pose, double speed, ph_error *error) {
  PH_TRY(ph_insist_on_pose(&robot->device, pose, error));
  PH_INSIST_ON_FINITE(&robot->device, error, {"speed", speed});
  const ph_position2d_cmd_pos command = {.pos = ph_wire_pose(pose), .vel = {speed, 0.0, 0.0}, .state = 1};
  robot->moving = true;
  return ph_device_command(&robot->device, PH_POSITION2D_CMD_POS, &command, error);
}

ph_status ph_position2d_set_motor_power(ph_position2d *robot, bool on, ph_error *error) {
  const ph_position2d_power_config body = {on};
  return ph_device_tell(&robot->device, PH_POSITION2D_REQ_MOTOR_POWER, &body, error);
}

ph_status ph_position2d_set_odometry(ph_position2d *robot, ph_pose pose, ph_error *error) {
  PH_TRY(ph_insist_on_pose(&robot->device, pose, error));
  const ph_position2d_set_odom_req body = {ph_wire_pose(pose)};
  return ph_device_tell(&robot->device, PH_POSITION2D_REQ_SET_ODOM, &body, error);
}

ph_status ph_position2d_reset_odometry(ph_position2d *robot, ph_error *error) {
  return ph_device_tell(&robot->device, PH_POSITION2D_REQ_RESET_ODOM, NULL, error);
}

ph_status ph_position2d_geometry(ph_position2d *robot, ph_geometry *geometry, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&robot->device, PH_POSITION2D_REQ_GET_GEOM, NULL, &answer, error));
  const ph_position2d_geom *geom = answer->data;
  *geometry = ph_geometry_of(geom->pose, geom->size);
  ph_value_free(answer);
  return PH_OK;
}
