#include "proxy.h"

#include <stdlib.h>
#include <string.h>

#include "playhouse/c/generated/wifi.h"

void *ph_list_new(void **list, size_t count, size_t size) {
  free(*list);
  *list = calloc(count > 0 ? count : 1, size);
  return *list;
}

// --- poses

ph_pose ph_pose_of(ph_common_pose2d pose) {
  return (ph_pose){pose.px, pose.py, pose.pa};
}

ph_pose3d ph_pose3d_of(ph_common_pose3d pose) {
  return (ph_pose3d){pose.px, pose.py, pose.pz, pose.proll, pose.ppitch, pose.pyaw};
}

ph_common_pose2d ph_wire_pose(ph_pose pose) {
  return (ph_common_pose2d){pose.x, pose.y, pose.a};
}

ph_common_pose3d ph_wire_pose3d(ph_pose3d pose) {
  return (ph_common_pose3d){pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw};
}

ph_pose3d ph_pose3d_at(ph_common_point3d point, ph_common_orientation3d orientation) {
  return (ph_pose3d){point.px, point.py, point.pz, orientation.proll, orientation.ppitch, orientation.pyaw};
}

ph_size ph_size_of(ph_common_bbox3d size) {
  return (ph_size){size.sl, size.sw, size.sh};
}

ph_velocity ph_velocity_of(ph_common_pose2d velocity) {
  return (ph_velocity){velocity.px, velocity.py, velocity.pa};
}

ph_status ph_insist_on_pose(const ph_device *device, ph_pose pose, ph_error *error) {
  PH_INSIST_ON_FINITE(device, error, {"x", pose.x}, {"y", pose.y}, {"a", pose.a});
  return PH_OK;
}

ph_status ph_insist_on_pose3d(const ph_device *device, ph_pose3d pose, ph_error *error) {
  PH_INSIST_ON_FINITE(device, error, {"x", pose.x}, {"y", pose.y}, {"z", pose.z}, {"roll", pose.roll},
                      {"pitch", pose.pitch}, {"yaw", pose.yaw});
  return PH_OK;
}

// --- other values

void ph_attitude_of(ph_common_orientation3d orientation, double attitude[3]) {
  attitude[0] = orientation.proll;
  attitude[1] = orientation.ppitch;
  attitude[2] = orientation.pyaw;
}

void ph_vector_of(ph_common_point3d point, double vector[3]) {
  vector[0] = point.px;
  vector[1] = point.py;
  vector[2] = point.pz;
}

void ph_rgb_of(ph_common_color color, uint8_t rgb[3]) {
  rgb[0] = color.red;
  rgb[1] = color.green;
  rgb[2] = color.blue;
}

void ph_rgba_of(ph_common_color color, uint8_t rgba[4]) {
  ph_rgb_of(color, rgba);
  rgba[3] = color.alpha;
}

ph_common_color ph_wire_rgb(const uint8_t rgb[3]) {
  return (ph_common_color){.alpha = 255, .red = rgb[0], .green = rgb[1], .blue = rgb[2]};
}

void ph_packed_rgb(uint32_t color, uint8_t rgb[3]) {
  for (size_t i = 0; i < 3; ++i) rgb[i] = (uint8_t)(color >> (16 - 8 * i) & 255);
}

ph_charging ph_charging_of(int32_t charging) {
  return charging < 0 ? PH_CHARGING_IMPOSSIBLE : charging > 0 ? PH_CHARGING_YES : PH_CHARGING_NO;
}

int64_t ph_level_of(int32_t level, uint32_t unit) {
  return unit == PH_WIFI_QUAL_DBM ? level : (int64_t)(uint32_t)level;
}

void ph_text_of(const void *bytes, size_t count, char *text) {
  const uint8_t *from = bytes;
  size_t size = 0;
  while (size < count && from[size] != 0) ++size;
  if (size > 0) memcpy(text, from, size);
  text[size] = '\0';
}

// --- arguments

ph_status ph_insist_on_least(const ph_device *device, const char *name, int32_t value, int32_t least,
                             ph_error *error) {
  if (value >= least) return PH_OK;
  return ph_fail(error, PH_INVALID_VALUE, "%s: %s is %ld, not a whole number from %ld to %ld", device->name,
                 name, (long)value, (long)least, (long)INT32_MAX);
}

ph_status ph_insist_on_size(const char *name, size_t size, ph_error *error) {
  if (size <= PH_MAX_BODY_BYTES) return PH_OK;
  return ph_fail(error, PH_WIRE_ERROR, "%s has %zu elements, over its limit of %d", name, size,
                 (int)PH_MAX_BODY_BYTES);
}

ph_status ph_to_floats(const ph_device *device, const char *name, const double *values, size_t count,
                       float **rounded, ph_error *error) {
  PH_TRY(ph_insist_on_size(name, count, error));
  float *made = calloc(count > 0 ? count : 1, sizeof *made);
  if (made == NULL) return ph_fail_no_memory(error);
  ph_status status = PH_OK;
  for (size_t i = 0; i < count && status == PH_OK; ++i) {
    const ph_named named = {name, values[i]};
    status = ph_insist_on_finite(device, &named, 1, error);
    if (status == PH_OK) status = ph_to_float(device, values[i], &made[i], error);
  }
  if (status == PH_OK) {
    *rounded = made;
  } else {
    free(made);
  }
  return status;
}

ph_status ph_join(ph_buffer *joined, const char *text, const void *bytes, size_t size, ph_error *error) {
  if (ph_buffer_append(joined, text, strlen(text) + 1) && ph_buffer_append(joined, bytes, size)) return PH_OK;
  ph_buffer_free(joined);
  return ph_fail_no_memory(error);
}

ph_status ph_fail_none(const ph_device *device, const char *what, ph_error *error) {
  return ph_fail(error, PH_NO_DATA, "%s: %s has no %s", ph_session_peer(ph_device_session(device)),
                 device->name, what);
}

ph_status ph_device_ask_again(ph_device *device, const ph_message_type *message, ph_value **kept,
                              ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(device, message, NULL, &answer, error));
  ph_value_free(*kept);
  *kept = answer;
  return PH_OK;
}

// --- beams

void ph_beams_free(ph_beams *beams) {
  free(beams->ranges);
  free(beams->angles);
}

ph_status ph_beams_begin(ph_beams *beams, size_t count, ph_error *error) {
  const bool done = ph_list_new(&beams->ranges, count, sizeof(double)) != NULL &&
                    ph_list_new(&beams->angles, count, sizeof(double)) != NULL;
  return done ? PH_OK : ph_fail_no_memory(error);
}

void ph_beams_direct(ph_beams *beams, size_t count, double low, double high, const ph_common_pose3d *elements,
                     size_t element_count) {
  double *angles = beams->angles;
  const bool each = element_count == count && count > 1;
  const double step = count > 1 ? (high - low) / (double)(count - 1) : 0.0;
  for (size_t i = 0; i < count; ++i) angles[i] = each ? elements[i].pyaw : low + (double)i * step;
}

// --- messages that are kept

enum { MOST = sizeof((ph_kept *)NULL)->values / sizeof(ph_value *) };

void ph_kept_add(ph_kept *kept, const ph_value *value) {
  if (kept->count == MOST) {
    ph_value_free(kept->values[kept->first]);
    kept->first = (kept->first + 1) % MOST;
    --kept->count;
  }
  kept->values[(kept->first + kept->count++) % MOST] = ph_value_keep(value);
}

const ph_value *ph_kept_take(ph_kept *kept) {
  ph_value_free(kept->taken);
  kept->taken = NULL;
  if (kept->count == 0) return NULL;
  kept->taken = kept->values[kept->first];
  kept->first = (kept->first + 1) % MOST;
  --kept->count;
  return kept->taken;
}

void ph_kept_clear(ph_kept *kept) {
  for (; kept->count > 0; --kept->count) {
    ph_value_free(kept->values[kept->first]);
    kept->first = (kept->first + 1) % MOST;
  }
}

void ph_kept_free(ph_kept *kept) {
  while (ph_kept_take(kept) != NULL) {
  }
}
