#include "playhouse/c/ptz.h"

#include "playhouse/c/generated/ptz.h"
#include "proxy.h"

struct ph_ptz {
  ph_device device;
};

const ph_class ph_ptz_class = {.interface_name = "ptz", .size = sizeof(ph_ptz)};
PH_DEFINE_PROXY(ptz)

ph_status ph_ptz_view(ph_ptz *mount, ph_view *view, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&mount->device, PH_PTZ_DATA_STATE, &value, error));
  const ph_ptz_data *data = value->data;
  *view = (ph_view){(double)data->pan, (double)data->tilt, (double)data->zoom, (double)data->panspeed,
                    (double)data->tiltspeed};
  return PH_OK;
}

ph_status ph_ptz_look(ph_ptz *mount, double pan, double tilt, double zoom, ph_error *error) {
  const ph_device *device = &mount->device;
  PH_INSIST_ON_FINITE(device, error, {"pan", pan}, {"tilt", tilt}, {"zoom", zoom});
  ph_ptz_cmd command = {0};
  PH_TRY(ph_to_float(device, pan, &command.pan, error));
  PH_TRY(ph_to_float(device, tilt, &command.tilt, error));
  PH_TRY(ph_to_float(device, zoom, &command.zoom, error));
  return ph_device_command(&mount->device, PH_PTZ_CMD_STATE, &command, error);
}

ph_status ph_ptz_turn(ph_ptz *mount, double pan_speed, double tilt_speed, ph_error *error) {
  const ph_device *device = &mount->device;
  PH_INSIST_ON_FINITE(device, error, {"pan_speed", pan_speed}, {"tilt_speed", tilt_speed});
  ph_ptz_cmd command = {0};
  PH_TRY(ph_to_float(device, pan_speed, &command.panspeed, error));
  PH_TRY(ph_to_float(device, tilt_speed, &command.tiltspeed, error));
  return ph_device_command(&mount->device, PH_PTZ_CMD_STATE, &command, error);
}

ph_status ph_ptz_set_velocity_control(ph_ptz *mount, bool on, ph_error *error) {
  const ph_ptz_req_control_mode body = {on ? PH_PTZ_VELOCITY_CONTROL : PH_PTZ_POSITION_CONTROL};
  return ph_device_tell(&mount->device, PH_PTZ_REQ_CONTROL_MODE, &body, error);
}

ph_status ph_ptz_geometry(ph_ptz *mount, ph_geometry *geometry, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&mount->device, PH_PTZ_REQ_GEOM, NULL, &answer, error));
  const ph_ptz_geom *geom = answer->data;
  *geometry = ph_geometry_of(geom->pos, geom->size);
  ph_value_free(answer);
  return PH_OK;
}
