#include "playhouse/c/fiducial.h"

#include <math.h>
#include <stdlib.h>

#include "proxy.h"

struct ph_fiducial {
  ph_device device;
  void *markers;
};

static void release(ph_device *device) {
  free(((ph_fiducial *)device)->markers);
}

const ph_class ph_fiducial_class = {
    .interface_name = "fiducial", .size = sizeof(ph_fiducial), .release = release};
PH_DEFINE_PROXY(fiducial)

double ph_marker_distance(const ph_marker *marker) {
  return hypot(marker->pose.x, marker->pose.y);
}
double ph_marker_bearing(const ph_marker *marker) {
  return atan2(marker->pose.y, marker->pose.x);
}

ph_status ph_fiducial_markers(ph_fiducial *finder, const ph_marker **markers, size_t *count,
                              ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&finder->device, PH_FIDUCIAL_DATA_SCAN, &value, error));
  const ph_fiducial_data *data = value->data;
  ph_marker *made = ph_list_new(&finder->markers, data->fiducials_count, sizeof *made);
  if (made == NULL) return ph_fail_no_memory(error);
  for (uint32_t i = 0; i < data->fiducials_count; ++i) {
    made[i] = (ph_marker){data->fiducials[i].id, ph_pose3d_of(data->fiducials[i].pose)};
  }
  *markers = made;
  *count = data->fiducials_count;
  return PH_OK;
}

ph_status ph_fiducial_field_of_view(ph_fiducial *finder, ph_fiducial_fov *view, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&finder->device, PH_FIDUCIAL_REQ_GET_FOV, NULL, &answer, error));
  *view = *(const ph_fiducial_fov *)answer->data;
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_fiducial_set_field_of_view(ph_fiducial *finder, double min_range, double max_range,
                                        double view_angle, ph_error *error) {
  const ph_device *device = &finder->device;
  PH_INSIST_ON_FINITE(device, error, {"min_range", min_range}, {"max_range", max_range},
                      {"view_angle", view_angle});
  ph_fiducial_fov body = {0};
  PH_TRY(ph_to_float(device, min_range, &body.min_range, error));
  PH_TRY(ph_to_float(device, max_range, &body.max_range, error));
  PH_TRY(ph_to_float(device, view_angle, &body.view_angle, error));
  return ph_device_tell(&finder->device, PH_FIDUCIAL_REQ_SET_FOV, &body, error);
}

ph_status ph_fiducial_geometry(ph_fiducial *finder, ph_geometry *geometry, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&finder->device, PH_FIDUCIAL_REQ_GET_GEOM, NULL, &answer, error));
  const ph_fiducial_geom *geom = answer->data;
  *geometry = ph_geometry_of(geom->pose, geom->size);
  ph_value_free(answer);
  return PH_OK;
}
