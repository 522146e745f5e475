#ifndef PLAYHOUSE_C_LASER_H
#define PLAYHOUSE_C_LASER_H

#include "playhouse/c/generated/laser.h"
#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A laser scanner; its data include the directions of the beams. */
PH_PROXY(laser)

ph_status ph_laser_scan(ph_laser *laser, ph_scan *scan, ph_error *error);
/** One per range, in the device's unit; none if it measures none. */
ph_status ph_laser_intensities(ph_laser *laser, const uint8_t **intensities, size_t *count, ph_error *error);
ph_status ph_laser_get_config(ph_laser *laser, ph_laser_config *config, ph_error *error);
ph_status ph_laser_set_config(ph_laser *laser, const ph_laser_config *config, ph_error *error);
ph_status ph_laser_geometry(ph_laser *laser, ph_geometry *geometry, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_LASER_H */
