#include "playhouse/c/laser.h"

#include "proxy.h"

struct ph_laser {
  ph_device device;
  ph_beams beams;
};

static void release(ph_device *device) {
  ph_beams_free(&((ph_laser *)device)->beams);
}

const ph_class ph_laser_class = {.interface_name = "laser", .size = sizeof(ph_laser), .release = release};
PH_DEFINE_PROXY(laser)

ph_status ph_laser_scan(ph_laser *laser, ph_scan *scan, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&laser->device, PH_LASER_DATA_SCAN, &value, error));
  const ph_laser_data *data = value->data;
  const size_t count = data->ranges_count;
  PH_TRY(ph_beams_begin(&laser->beams, count, error));
  ph_beams_spread(&laser->beams, count, (double)data->min_angle, (double)data->max_angle);
  double *ranges = laser->beams.ranges;
  for (size_t i = 0; i < count; ++i) ranges[i] = (double)data->ranges[i];
  *scan = (ph_scan){ranges, laser->beams.angles, count, (double)data->max_range, value->timestamp};
  return PH_OK;
}

ph_status ph_laser_intensities(ph_laser *laser, const uint8_t **intensities, size_t *count, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&laser->device, PH_LASER_DATA_SCAN, &value, error));
  const ph_laser_data *data = value->data;
  *intensities = data->intensity;
  *count = data->intensity_count;
  return PH_OK;
}

ph_status ph_laser_get_config(ph_laser *laser, ph_laser_config *config, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&laser->device, PH_LASER_REQ_GET_CONFIG, NULL, &answer, error));
  *config = *(const ph_laser_config *)answer->data;
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_laser_set_config(ph_laser *laser, const ph_laser_config *config, ph_error *error) {
  return ph_device_tell(&laser->device, PH_LASER_REQ_SET_CONFIG, config, error);
}

ph_status ph_laser_geometry(ph_laser *laser, ph_geometry *geometry, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&laser->device, PH_LASER_REQ_GET_GEOM, NULL, &answer, error));
  const ph_laser_geom *geom = answer->data;
  *geometry = ph_geometry_of(geom->pose, geom->size);
  ph_value_free(answer);
  return PH_OK;
}
