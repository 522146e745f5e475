#include "proxy.h"

#include <stdlib.h>

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

ph_geometry ph_geometry_of(ph_common_pose3d pose, ph_common_bbox3d size) {
  return (ph_geometry){ph_pose3d_of(pose), {size.sl, size.sw, size.sh}};
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

void ph_beams_spread(ph_beams *beams, size_t count, double low, double high) {
  double *angles = beams->angles;
  const double step = count > 1 ? (high - low) / (double)(count - 1) : 0.0;
  for (size_t i = 0; i < count; ++i) angles[i] = low + (double)i * step;
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
