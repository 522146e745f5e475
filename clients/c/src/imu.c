#include "playhouse/c/imu.h"

#include <ctype.h>

#include "proxy.h"

struct ph_imu {
  ph_device device;
};

const ph_class ph_imu_class = {.interface_name = "imu", .size = sizeof(ph_imu)};
PH_DEFINE_PROXY(imu)

ph_status ph_imu_send(ph_imu *unit, const ph_message_type *datatype, ph_error *error) {
  const ph_imu_datatype_config body = {datatype->subtype};
  return ph_device_tell(&unit->device, PH_IMU_REQ_SET_DATATYPE, &body, error);
}

/** The newest data of a message. If only others came, the error tells how to select it. */
static ph_status stamped(const ph_imu *unit, const ph_message_type *message, const ph_value **value,
                         ph_error *error) {
  const ph_status status = ph_device_stamped(&unit->device, message, value, error);
  if (status == PH_OK || error == NULL || !ph_device_has_data(&unit->device)) return status;
  char constant[32] = "";
  for (size_t i = 0; message->name[i] != '\0' && i + 1 < sizeof constant; ++i)
    constant[i] = message->name[i] == '.' ? '_' : (char)toupper((unsigned char)message->name[i]);
  return ph_fail(error, status, "%s; ph_imu_send(unit, PH_%s) selects it", error->text, constant);
}

/** The newest data of several messages; PH_NO_DATA before the first of all. */
static ph_status newest(const ph_imu *unit, const ph_message_type *const *messages, size_t count,
                        const ph_value **value, ph_error *error) {
  const ph_value *found = NULL;
  for (size_t i = 0; i < count; ++i) {
    const ph_value *each = ph_device_latest(&unit->device, messages[i]);
    if (each != NULL && (found == NULL || each->timestamp > found->timestamp)) found = each;
  }
  *value = found;
  return found != NULL ? PH_OK : stamped(unit, messages[0], value, error);
}

ph_status ph_imu_pose(ph_imu *unit, ph_pose3d *pose, ph_error *error) {
  const ph_message_type *const messages[] = {PH_IMU_DATA_STATE, PH_IMU_DATA_FULLSTATE};
  const ph_value *value = NULL;
  PH_TRY(newest(unit, messages, 2, &value, error));
  const bool full = value->message == PH_IMU_DATA_FULLSTATE;
  *pose = ph_pose3d_of(full ? ((const ph_imu_data_fullstate *)value->data)->pose
                            : ((const ph_imu_data_state *)value->data)->pose);
  return PH_OK;
}

ph_status ph_imu_velocity(ph_imu *unit, ph_pose3d *velocity, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(stamped(unit, PH_IMU_DATA_FULLSTATE, &value, error));
  *velocity = ph_pose3d_of(((const ph_imu_data_fullstate *)value->data)->vel);
  return PH_OK;
}

static const ph_imu_data_calib *calib_of(const ph_value *value) {
  if (value->message == PH_IMU_DATA_QUAT) return &((const ph_imu_data_quat *)value->data)->calib_data;
  if (value->message == PH_IMU_DATA_EULER) return &((const ph_imu_data_euler *)value->data)->calib_data;
  return value->data;
}

ph_status ph_imu_inertia(ph_imu *unit, ph_inertia *inertia, ph_error *error) {
  const ph_message_type *const messages[] = {PH_IMU_DATA_CALIB, PH_IMU_DATA_QUAT, PH_IMU_DATA_EULER};
  const ph_value *value = NULL;
  PH_TRY(newest(unit, messages, 3, &value, error));
  const ph_imu_data_calib *from = calib_of(value);
  *inertia = (ph_inertia){{(double)from->accel_x, (double)from->accel_y, (double)from->accel_z},
                          {(double)from->gyro_x, (double)from->gyro_y, (double)from->gyro_z},
                          {(double)from->magn_x, (double)from->magn_y, (double)from->magn_z}};
  return PH_OK;
}

ph_status ph_imu_attitude(ph_imu *unit, double attitude[3], ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(stamped(unit, PH_IMU_DATA_EULER, &value, error));
  const ph_common_orientation3d *turns = &((const ph_imu_data_euler *)value->data)->orientation;
  attitude[0] = turns->proll;
  attitude[1] = turns->ppitch;
  attitude[2] = turns->pyaw;
  return PH_OK;
}

ph_status ph_imu_quaternion(ph_imu *unit, double quaternion[4], ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(stamped(unit, PH_IMU_DATA_QUAT, &value, error));
  const ph_imu_data_quat *data = value->data;
  quaternion[0] = (double)data->q0;
  quaternion[1] = (double)data->q1;
  quaternion[2] = (double)data->q2;
  quaternion[3] = (double)data->q3;
  return PH_OK;
}

ph_status ph_imu_reset_orientation(ph_imu *unit, bool all_axes, ph_error *error) {
  const ph_imu_reset_orientation_config body = {all_axes};
  return ph_device_tell(&unit->device, PH_IMU_REQ_RESET_ORIENTATION, &body, error);
}

ph_status ph_imu_reset_attitude(ph_imu *unit, double roll, double pitch, double yaw, ph_error *error) {
  PH_INSIST_ON_FINITE(&unit->device, error, {"roll", roll}, {"pitch", pitch}, {"yaw", yaw});
  const ph_imu_reset_euler_config body = {{0.0, 0.0, 0.0, roll, pitch, yaw}};
  return ph_device_tell(&unit->device, PH_IMU_REQ_RESET_EULER, &body, error);
}
