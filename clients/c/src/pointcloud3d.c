#include "playhouse/c/pointcloud3d.h"

#include <stdlib.h>

#include "playhouse/c/generated/pointcloud3d.h"
#include "proxy.h"

struct ph_pointcloud3d {
  ph_device device;
  void *points;
};

static void release(ph_device *device) {
  free(((ph_pointcloud3d *)device)->points);
}

const ph_class ph_pointcloud3d_class = {
    .interface_name = "pointcloud3d", .size = sizeof(ph_pointcloud3d), .release = release};
PH_DEFINE_PROXY(pointcloud3d)

ph_status ph_pointcloud3d_points(ph_pointcloud3d *cloud, const ph_cloud_point **points, size_t *count,
                                 ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&cloud->device, PH_POINTCLOUD3D_DATA_STATE, &value, error));
  const ph_pointcloud3d_data *data = value->data;
  ph_cloud_point *made = ph_list_new(&cloud->points, data->points_count, sizeof *made);
  if (made == NULL) return ph_fail_no_memory(error);
  for (uint32_t i = 0; i < data->points_count; ++i) {
    const ph_common_point3d *at = &data->points[i].point;
    const ph_common_color *color = &data->points[i].color;
    made[i] = (ph_cloud_point){at->px, at->py, at->pz, {color->red, color->green, color->blue, color->alpha}};
  }
  *points = made;
  *count = data->points_count;
  return PH_OK;
}
