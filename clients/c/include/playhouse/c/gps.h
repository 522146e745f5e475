#ifndef PLAYHOUSE_C_GPS_H
#define PLAYHOUSE_C_GPS_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A satellite receiver. */
PH_PROXY(gps)

/** A fix of a satellite receiver: latitude and longitude in degrees, altitude in m above the ellipsoid
 * (WGS84), UTM easting and northing in m; speed in m/s, course in rad, clockwise from north; expected errors
 * in m. `quality` is 0 without a fix, and then the rest is invalid. `time` is the server's, in s. */
typedef struct ph_fix {
  double latitude, longitude, altitude;
  double easting, northing;
  double speed, course;
  uint32_t quality, satellites;
  double horizontal_error, vertical_error;
  double time;
} ph_fix;

ph_status ph_gps_fix(ph_gps *receiver, ph_fix *fix, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_GPS_H */
