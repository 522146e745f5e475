#ifndef PLAYHOUSE_C_PTZ_H
#define PLAYHOUSE_C_PTZ_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A pan-tilt-zoom mount of a camera. */
PH_PROXY(ptz)

/** State of a camera mount: pan to the left, tilt upwards and horizontal field of view, in rad; speeds in
 * rad/s. */
typedef struct ph_view {
  double pan, tilt, zoom;
  double pan_speed, tilt_speed;
} ph_view;

/** The current direction and field of view. */
ph_status ph_ptz_view(ph_ptz *mount, ph_view *view, ph_error *error);
/** Turns to these angles, in position control; a zoom of 0 keeps the field of view. */
ph_status ph_ptz_look(ph_ptz *mount, double pan, double tilt, double zoom, ph_error *error);
/** Turns at these speeds; requires ph_ptz_set_velocity_control(). */
ph_status ph_ptz_turn(ph_ptz *mount, double pan_speed, double tilt_speed, ph_error *error);
/** Selects velocity control, or position control. */
ph_status ph_ptz_set_velocity_control(ph_ptz *mount, bool on, ph_error *error);
ph_status ph_ptz_geometry(ph_ptz *mount, ph_geometry *geometry, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_PTZ_H */
