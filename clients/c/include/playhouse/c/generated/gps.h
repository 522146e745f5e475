/** Interface gps, code 13. A satellite receiver. Generated from interfaces/013_gps.toml by codegen; do not
 * edit. */
#ifndef PLAYHOUSE_C_GENERATED_GPS_H
#define PLAYHOUSE_C_GENERATED_GPS_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_GPS_CODE 13

/** A fix. (player_gps_data_t) */
typedef struct ph_gps_data {
  /** Time of the fix since 1970: whole seconds (in s). */
  uint32_t time_sec;
  /** Time of the fix: microseconds of the second (in us). */
  uint32_t time_usec;
  /** Positive north, WGS84 (in 1e-7 deg). */
  int32_t latitude;
  /** Positive east, WGS84 (in 1e-7 deg). */
  int32_t longitude;
  /** Above the ellipsoid (in mm). */
  int32_t altitude;
  /** Over ground (in m/s). */
  double speed;
  /** Direction of travel, clockwise from north (in rad). */
  double course;
  /** UTM easting (in m). */
  double utm_e;
  /** UTM northing (in m). */
  double utm_n;
  /** 0: no fix, 1: plain, 2: differential. */
  uint32_t quality;
  /** Satellites used. */
  uint32_t num_sats;
  /** Horizontal dilution of precision (in 0.1). */
  uint32_t hdop;
  /** Vertical dilution of precision (in 0.1). */
  uint32_t vdop;
  /** Expected horizontal error (in m). */
  double err_horz;
  /** Expected vertical error (in m). */
  double err_vert;
} ph_gps_data;
PH_CODEC(ph_gps_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_gps_messages[1];
/** The newest fix. */
#define PH_GPS_DATA_STATE (&ph_gps_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_GPS_H */
