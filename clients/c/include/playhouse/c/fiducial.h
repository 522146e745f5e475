#ifndef PLAYHOUSE_C_FIDUCIAL_H
#define PLAYHOUSE_C_FIDUCIAL_H

#include "playhouse/c/generated/fiducial.h"
#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A fiducial finder. */
PH_PROXY(fiducial)

/** A marker in view: its id, and its pose in the sensor's frame. */
typedef struct ph_marker {
  int32_t id;
  ph_pose3d pose;
} ph_marker;

/** In m, and in rad, counter-clockwise from the sensor's x axis. */
double ph_marker_distance(const ph_marker *marker);
double ph_marker_bearing(const ph_marker *marker);

/** Markers in view. */
ph_status ph_fiducial_markers(ph_fiducial *finder, const ph_marker **markers, size_t *count, ph_error *error);
ph_status ph_fiducial_field_of_view(ph_fiducial *finder, ph_fiducial_fov *view, ph_error *error);
/** Ranges in m, the full field of view in rad. */
ph_status ph_fiducial_set_field_of_view(ph_fiducial *finder, double min_range, double max_range,
                                        double view_angle, ph_error *error);
ph_status ph_fiducial_geometry(ph_fiducial *finder, ph_geometry *geometry, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_FIDUCIAL_H */
