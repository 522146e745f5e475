/** Definitions of what PH_PROXY declares. */
#ifndef PLAYHOUSE_C_SRC_PROXY_H
#define PLAYHOUSE_C_SRC_PROXY_H

#include "classes.h"
#include "device.h"
#include "fail.h"
#include "playhouse/c/charging.h"
#include "playhouse/c/covariance.h"
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
ph_pose3d ph_pose3d_at(ph_common_point3d point, ph_common_orientation3d orientation);
ph_size ph_size_of(ph_common_bbox3d size);
ph_velocity ph_velocity_of(ph_common_pose2d velocity);
ph_covariance ph_covariance_of(const double cov[6]);
void ph_wire_covariance(ph_covariance covariance, double cov[6]);
void ph_attitude_of(ph_common_orientation3d orientation, double attitude[3]);
void ph_vector_of(ph_common_point3d point, double vector[3]);
void ph_rgb_of(ph_common_color color, uint8_t rgb[3]);
void ph_rgba_of(ph_common_color color, uint8_t rgba[4]);
ph_common_color ph_wire_rgb(const uint8_t rgb[3]);
/** Of 0xRRGGBB. */
void ph_packed_rgb(uint32_t color, uint8_t rgb[3]);
ph_charging ph_charging_of(int32_t charging);
/** Levels of a radio in dBm are signed, all others are not. */
int64_t ph_level_of(int32_t level, uint32_t unit);
/** Copies bytes up to a NUL, and a NUL behind them: `text` has a place more than there may be bytes. */
void ph_text_of(const void *bytes, size_t count, char *text);

ph_status ph_insist_on_pose(const ph_device *device, ph_pose pose, ph_error *error);
ph_status ph_insist_on_pose3d(const ph_device *device, ph_pose3d pose, ph_error *error);
ph_status ph_insist_on_covariance(const ph_device *device, ph_covariance covariance, ph_error *error);
/** PH_INVALID_VALUE if a number is less. */
ph_status ph_insist_on_least(const ph_device *device, const char *name, int32_t value, int32_t least,
                             ph_error *error);
/** PH_WIRE_ERROR if a message is too long even for its count. */
ph_status ph_insist_on_size(const char *name, size_t size, ph_error *error);
/** Rounds numbers to the wire's precision, in memory for the caller to free. `name` is that of one. */
ph_status ph_to_floats(const ph_device *device, const char *name, const double *values, size_t count,
                       float **rounded, ph_error *error);
/** A text with its NUL, and bytes behind it. `joined` is to be freed after PH_OK. */
ph_status ph_join(ph_buffer *joined, const char *text, const void *bytes, size_t size, ph_error *error);
/** PH_NO_DATA: the device has none. */
ph_status ph_fail_none(const ph_device *device, const char *what, ph_error *error);

/** Asks for an answer that is kept, in place of the one before. */
ph_status ph_device_ask_again(ph_device *device, const ph_message_type *message, ph_value **kept,
                              ph_error *error);

/** Selects the data message of a device that has several. */
ph_status ph_select(ph_device *device, const ph_message_type *datatype, ph_error *error);
/** The newest data of a message. If only others came, the error tells how to select it. */
ph_status ph_selected(const ph_device *device, const ph_message_type *message, const ph_value **value,
                      ph_error *error);
/** The newest data of several messages; PH_NO_DATA before the first of all. */
ph_status ph_newest_of(const ph_device *device, const ph_message_type *const *messages, size_t count,
                       const ph_value **value, ph_error *error);

/** Ranges and angles of a scan, as long as the device. Begin with zeros. */
typedef struct ph_beams {
  void *ranges, *angles;
} ph_beams;

void ph_beams_free(ph_beams *beams);
/** Makes room for `count` beams; their ranges and angles are then to be written. */
ph_status ph_beams_begin(ph_beams *beams, size_t count, ph_error *error);
/** Angles: those of the elements if there is one per range, else spread from `low` to `high`. */
void ph_beams_direct(ph_beams *beams, size_t count, double low, double high, const ph_common_pose3d *elements,
                     size_t element_count);

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

#endif /* PLAYHOUSE_C_SRC_PROXY_H */
