#include "playhouse/c/sonar.h"

#include <stdlib.h>

#include "playhouse/c/generated/sonar.h"
#include "proxy.h"

struct ph_sonar {
  ph_device device;
  void *poses;
};

static void release(ph_device *device) {
  free(((ph_sonar *)device)->poses);
}

const ph_class ph_sonar_class = {.interface_name = "sonar", .size = sizeof(ph_sonar), .release = release};
PH_DEFINE_PROXY(sonar)

ph_status ph_sonar_ranges(ph_sonar *sonar, const float **ranges, size_t *count, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&sonar->device, PH_SONAR_DATA_RANGES, &value, error));
  const ph_sonar_data *data = value->data;
  *ranges = data->ranges;
  *count = data->ranges_count;
  return PH_OK;
}

ph_status ph_sonar_poses(ph_sonar *sonar, const ph_pose3d **poses, size_t *count, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&sonar->device, PH_SONAR_REQ_GET_GEOM, NULL, &answer, error));
  const ph_sonar_geom *geom = answer->data;
  ph_pose3d *made = ph_list_new(&sonar->poses, geom->poses_count, sizeof *made);
  for (uint32_t i = 0; made != NULL && i < geom->poses_count; ++i) made[i] = ph_pose3d_of(geom->poses[i]);
  if (made != NULL) {
    *poses = made;
    *count = geom->poses_count;
  }
  ph_value_free(answer);
  return made != NULL ? PH_OK : ph_fail_no_memory(error);
}

ph_status ph_sonar_set_power(ph_sonar *sonar, bool on, ph_error *error) {
  const ph_sonar_power_config body = {on};
  return ph_device_tell(&sonar->device, PH_SONAR_REQ_POWER, &body, error);
}
