#include "playhouse/c/gps.h"

#include "playhouse/c/generated/gps.h"
#include "proxy.h"

struct ph_gps {
  ph_device device;
};

const ph_class ph_gps_class = {.interface_name = "gps", .size = sizeof(ph_gps)};
PH_DEFINE_PROXY(gps)

ph_status ph_gps_fix(ph_gps *receiver, ph_fix *fix, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&receiver->device, PH_GPS_DATA_STATE, &value, error));
  const ph_gps_data *data = value->data;
  *fix = (ph_fix){
      .latitude = data->latitude * 1e-7,
      .longitude = data->longitude * 1e-7,
      .altitude = data->altitude * 1e-3,
      .easting = data->utm_e,
      .northing = data->utm_n,
      .speed = data->speed,
      .course = data->course,
      .quality = data->quality,
      .satellites = data->num_sats,
      .horizontal_error = data->err_horz,
      .vertical_error = data->err_vert,
      .time = value->timestamp,
  };
  return PH_OK;
}
