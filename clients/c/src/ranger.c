#include "playhouse/c/ranger.h"

#include <string.h>

#include "proxy.h"

struct ph_ranger {
  ph_device device;
  ph_value *config, *geom; /**< answers; NULL: it refused to tell */
  ph_beams beams;
};

static ph_status ask_again(ph_ranger *ranger, const ph_message_type *message, ph_value **kept,
                           ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&ranger->device, message, NULL, &answer, error));
  ph_value_free(*kept);
  *kept = answer;
  return PH_OK;
}

static ph_status prepare(ph_device *device, ph_error *error) {
  ph_ranger *ranger = (ph_ranger *)device;
  PH_TRY(ask_again(ranger, PH_RANGER_REQ_GET_CONFIG, &ranger->config, error));
  return ask_again(ranger, PH_RANGER_REQ_GET_GEOM, &ranger->geom, error);
}

static void release(ph_device *device) {
  ph_ranger *ranger = (ph_ranger *)device;
  ph_value_free(ranger->config);
  ph_value_free(ranger->geom);
  ph_beams_free(&ranger->beams);
}

const ph_class ph_ranger_class = {
    .interface_name = "ranger", .size = sizeof(ph_ranger), .prepare = prepare, .release = release};
PH_DEFINE_PROXY(ranger)

const ph_ranger_config *ph_ranger_get_config(const ph_ranger *ranger) {
  static const ph_ranger_config none = {0};
  return ranger->config != NULL ? ranger->config->data : &none;
}

const ph_ranger_geom *ph_ranger_get_geom(const ph_ranger *ranger) {
  static const ph_ranger_geom none = {.element_poses = NULL};
  return ranger->geom != NULL ? ranger->geom->data : &none;
}

ph_geometry ph_ranger_geometry(const ph_ranger *ranger) {
  const ph_ranger_geom *geom = ph_ranger_get_geom(ranger);
  return ph_geometry_of(geom->pose, geom->size);
}

ph_status ph_ranger_ranges(ph_ranger *ranger, const double **ranges, size_t *count, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&ranger->device, PH_RANGER_DATA_RANGE, &value, error));
  const ph_ranger_data_range *data = value->data;
  *ranges = data->ranges;
  *count = data->ranges_count;
  return PH_OK;
}

ph_status ph_ranger_intensities(ph_ranger *ranger, const double **intensities, size_t *count,
                                ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&ranger->device, PH_RANGER_DATA_INTNS, &value, error));
  const ph_ranger_data_intns *data = value->data;
  *intensities = data->intensities;
  *count = data->intensities_count;
  return PH_OK;
}

ph_status ph_ranger_scan(ph_ranger *ranger, ph_scan *scan, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&ranger->device, PH_RANGER_DATA_RANGE, &value, error));
  const ph_ranger_data_range *data = value->data;
  const ph_ranger_config *config = ph_ranger_get_config(ranger);
  const ph_ranger_geom *geom = ph_ranger_get_geom(ranger);
  const size_t count = data->ranges_count;
  PH_TRY(ph_beams_begin(&ranger->beams, count, error));
  if (geom->element_poses_count == count && count > 1) {
    double *angles = ranger->beams.angles;
    for (size_t i = 0; i < count; ++i) angles[i] = geom->element_poses[i].pyaw;
  } else {
    ph_beams_spread(&ranger->beams, count, config->min_angle, config->max_angle);
  }
  if (count > 0) memcpy(ranger->beams.ranges, data->ranges, count * sizeof(double));
  *scan = (ph_scan){ranger->beams.ranges, ranger->beams.angles, count, config->max_range, value->timestamp};
  return PH_OK;
}

ph_status ph_ranger_set_config(ph_ranger *ranger, const ph_ranger_config *config, ph_error *error) {
  PH_TRY(ph_device_tell(&ranger->device, PH_RANGER_REQ_SET_CONFIG, config, error));
  return ask_again(ranger, PH_RANGER_REQ_GET_CONFIG, &ranger->config, error);
}

ph_status ph_ranger_set_power(ph_ranger *ranger, bool on, ph_error *error) {
  const ph_ranger_power_config body = {on};
  return ph_device_tell(&ranger->device, PH_RANGER_REQ_POWER, &body, error);
}

ph_status ph_ranger_set_intensities(ph_ranger *ranger, bool on, ph_error *error) {
  const ph_ranger_intns_config body = {on};
  return ph_device_tell(&ranger->device, PH_RANGER_REQ_INTNS, &body, error);
}
