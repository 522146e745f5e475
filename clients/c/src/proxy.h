/** Definitions of what PH_PROXY declares. */
#ifndef PLAYHOUSE_C_SRC_PROXY_H
#define PLAYHOUSE_C_SRC_PROXY_H

#include "device.h"
#include "fail.h"
#include "playhouse/c/generated/common.h"
#include "playhouse/c/proxy.h"

/** The device as one of a class; PH_INVALID_VALUE, and NULL, if it is of another. */
ph_device *ph_device_as(ph_device *device, const ph_class *class_of, ph_error *error);

/** For a proxy whose type has the member `ph_device device` first, and whose class is ph_NAME_class. */
#define PH_DEFINE_PROXY(NAME)                                                                           \
  ph_##NAME *ph_##NAME##_open(ph_client *client, int index, ph_access access, ph_error *error) {        \
    return (ph_##NAME *)ph_device_open(client, ph_##NAME##_class.interface_name, index, access, error); \
  }                                                                                                     \
  ph_##NAME *ph_robot_##NAME(ph_robot *robot, size_t nth, ph_error *error) {                            \
    return (ph_##NAME *)ph_robot_device(robot, ph_##NAME##_class.interface_name, nth, error);           \
  }                                                                                                     \
  ph_device *ph_##NAME##_device(ph_##NAME *proxy) {                                                     \
    return &proxy->device;                                                                              \
  }                                                                                                     \
  ph_##NAME *ph_##NAME##_of(ph_device *device, ph_error *error) {                                       \
    return (ph_##NAME *)ph_device_as(device, &ph_##NAME##_class, error);                                \
  }                                                                                                     \
  ph_status ph_##NAME##_next_data(ph_##NAME *proxy, double timeout, ph_error *error) {                  \
    return ph_device_next_data(&proxy->device, timeout, error);                                         \
  }                                                                                                     \
  ph_status ph_##NAME##_close(ph_##NAME *proxy, ph_error *error) {                                      \
    return ph_device_close(&proxy->device, error);                                                      \
  }                                                                                                     \
  void ph_##NAME##_free(ph_##NAME *proxy) {                                                             \
    ph_device_free(proxy != NULL ? &proxy->device : NULL);                                              \
  }

/** Memory for a list that a proxy gives out, in place of the one before. NULL without memory. */
void *ph_list_new(void **list, size_t count, size_t size);

ph_pose ph_pose_of(ph_common_pose2d pose);
ph_pose3d ph_pose3d_of(ph_common_pose3d pose);
ph_common_pose2d ph_wire_pose(ph_pose pose);
ph_common_pose3d ph_wire_pose3d(ph_pose3d pose);
ph_geometry ph_geometry_of(ph_common_pose3d pose, ph_common_bbox3d size);

ph_status ph_insist_on_pose(const ph_device *device, ph_pose pose, ph_error *error);
ph_status ph_insist_on_pose3d(const ph_device *device, ph_pose3d pose, ph_error *error);

/** Ranges and angles of a scan, as long as the device. Begin with zeros. */
typedef struct ph_beams {
  void *ranges, *angles;
} ph_beams;

void ph_beams_free(ph_beams *beams);
/** Makes room for `count` beams; their ranges and angles are then to be written. */
ph_status ph_beams_begin(ph_beams *beams, size_t count, ph_error *error);
/** Angles from `low` to `high`. */
void ph_beams_spread(ph_beams *beams, size_t count, double low, double high);

/** The last messages of a device, oldest first. Begin with zeros. */
typedef struct ph_kept {
  ph_value *values[1024];
  size_t first, count;
  ph_value *taken; /**< what was given out last */
} ph_kept;

/** Keeps a message; the oldest of 1024 is dropped. */
void ph_kept_add(ph_kept *kept, const ph_value *value);
/** The oldest message, which is kept until the next call; NULL if there is none. */
const ph_value *ph_kept_take(ph_kept *kept);
/** Drops the messages that were not given out. */
void ph_kept_clear(ph_kept *kept);
void ph_kept_free(ph_kept *kept);

extern const ph_class ph_aio_class, ph_bumper_class, ph_camera_class, ph_fiducial_class, ph_gps_class,
    ph_imu_class, ph_laser_class, ph_localize_class, ph_map_class, ph_opaque_class, ph_planner_class,
    ph_pointcloud3d_class, ph_position2d_class, ph_position3d_class, ph_ptz_class, ph_ranger_class,
    ph_simulation_class, ph_sonar_class, ph_speech_class, ph_speech_recognition_class;

#endif /* PLAYHOUSE_C_SRC_PROXY_H */
