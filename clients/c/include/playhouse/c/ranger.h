#ifndef PLAYHOUSE_C_RANGER_H
#define PLAYHOUSE_C_RANGER_H

#include "playhouse/c/generated/ranger.h"
#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration. */
PH_PROXY(ranger)

/** In m, in the order of measurement. */
ph_status ph_ranger_ranges(ph_ranger *ranger, const double **ranges, size_t *count, ph_error *error);
/** One per range, in the device's unit. PH_NO_DATA also for a device without intensities. */
ph_status ph_ranger_intensities(ph_ranger *ranger, const double **intensities, size_t *count,
                                ph_error *error);
/** Ranges with directions: those of the elements if there is one per range, else spread over the field of
 * view. */
ph_status ph_ranger_scan(ph_ranger *ranger, ph_scan *scan, ph_error *error);
ph_geometry ph_ranger_geometry(const ph_ranger *ranger);
/** The configuration and the geometry with its elements, as of opening or of ph_ranger_set_config(); zero for
 * a device that refused to tell them. Valid until the release of the device; the configuration until
 * ph_ranger_set_config(). */
const ph_ranger_config *ph_ranger_get_config(const ph_ranger *ranger);
const ph_ranger_geom *ph_ranger_get_geom(const ph_ranger *ranger);
/** Requests another configuration; ph_ranger_get_config() then has the values in effect. */
ph_status ph_ranger_set_config(ph_ranger *ranger, const ph_ranger_config *config, ph_error *error);
ph_status ph_ranger_set_power(ph_ranger *ranger, bool on, ph_error *error);
/** Enables or disables intensities. */
ph_status ph_ranger_set_intensities(ph_ranger *ranger, bool on, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_RANGER_H */
