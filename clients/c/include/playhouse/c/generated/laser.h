/** Interface laser, code 6. A scanning range finder. New drivers use the ranger interface. Generated from
 * interfaces/006_laser.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_LASER_H
#define PLAYHOUSE_C_GENERATED_LASER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_LASER_CODE 6

/** Largest number of filter parameters. */
enum {
  PH_LASER_MAX_FILTER_PARAMS = 8,
};

/** Values of SetFilterConfig.filter_type. */
enum {
  PH_LASER_FILTER_MEDIAN = 1,
  PH_LASER_FILTER_EDGE = 2,
  PH_LASER_FILTER_RANGE = 3,
  PH_LASER_FILTER_MEAN = 4,
};

/** One scan at equal angles. (player_laser_data_t) */
typedef struct ph_laser_data {
  /** Of the first beam, counter-clockwise from x (in rad). */
  float min_angle;
  /** Of the last beam (in rad). */
  float max_angle;
  /** Angle between neighbouring beams (in rad). */
  float resolution;
  /** Reported range of a beam without a hit (in m). */
  float max_range;
  /** From right to left (in m). */
  const float *ranges;
  uint32_t ranges_count;
  /** Intensity of the echo per beam; empty if the device has none. */
  const uint8_t *intensity;
  uint32_t intensity_count;
  /** Increases from scan to scan, by one or more. */
  uint32_t id;
} ph_laser_data;
PH_CODEC(ph_laser_data)

/** One scan and the pose at which it was measured. (player_laser_data_scanpose_t) */
typedef struct ph_laser_data_scanpose {
  ph_laser_data scan;
  /** Of the robot at the time of the scan (in m, m, rad, frame X_OR). */
  ph_common_pose2d pose;
} ph_laser_data_scanpose;
PH_CODEC(ph_laser_data_scanpose)

/** One scan with an angle per beam. (player_laser_data_scanangle_t) */
typedef struct ph_laser_data_scanangle {
  /** Reported range of a beam without a hit (in m). */
  float max_range;
  /** One per beam (in m). */
  const float *ranges;
  uint32_t ranges_count;
  /** One per beam, counter-clockwise from x (in rad). */
  const float *angles;
  uint32_t angles_count;
  /** Intensity of the echo per beam; empty if the device has none. */
  const uint8_t *intensity;
  uint32_t intensity_count;
  /** Increases from scan to scan, by one or more. */
  uint32_t id;
} ph_laser_data_scanangle;
PH_CODEC(ph_laser_data_scanangle)

/** The device's size and pose. (player_laser_geom_t) */
typedef struct ph_laser_geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the device (in m, m, m). */
  ph_common_bbox3d size;
} ph_laser_geom;
PH_CODEC(ph_laser_geom)

/** Angles, resolution and rate. (player_laser_config_t) */
typedef struct ph_laser_config {
  /** Of the first beam (in rad). */
  float min_angle;
  /** Of the last beam (in rad). */
  float max_angle;
  /** Angle between neighbouring beams (in rad). */
  float resolution;
  /** Maximum range (in m). */
  float max_range;
  /** Range resolution (in m). */
  float range_res;
  /** 1: send intensities, too. */
  uint8_t intensity;
  /** Scans per second (in Hz). */
  float scanning_frequency;
} ph_laser_config;
PH_CODEC(ph_laser_config)

/** The device's switch. (player_laser_power_config_t) */
typedef struct ph_laser_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_laser_power_config;
PH_CODEC(ph_laser_power_config)

/** A serial number. (player_laser_get_id_config_t) */
typedef struct ph_laser_get_id_config {
  /** 0 in the request. */
  uint32_t serial_number;
} ph_laser_get_id_config;
PH_CODEC(ph_laser_get_id_config)

/** A filter. (player_laser_set_filter_config_t) */
typedef struct ph_laser_set_filter_config {
  /** Type of filter. */
  uint8_t filter_type;
  /** Filter-specific. At most 8. */
  const float *parameters;
  uint32_t parameters_count;
} ph_laser_set_filter_config;
PH_CODEC(ph_laser_set_filter_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_laser_messages[9];
/** One scan at equal angles. */
#define PH_LASER_DATA_SCAN (&ph_laser_messages[0])
/** One scan and the pose at which it was measured. */
#define PH_LASER_DATA_SCANPOSE (&ph_laser_messages[1])
/** One scan with an angle per beam. */
#define PH_LASER_DATA_SCANANGLE (&ph_laser_messages[2])
/** Requests the device's size and pose. */
#define PH_LASER_REQ_GET_GEOM (&ph_laser_messages[3])
/** Sets angles, resolution and rate; the answer has the values in effect. */
#define PH_LASER_REQ_SET_CONFIG (&ph_laser_messages[4])
/** Requests angles, resolution and rate. */
#define PH_LASER_REQ_GET_CONFIG (&ph_laser_messages[5])
/** Switches the device on or off. */
#define PH_LASER_REQ_POWER (&ph_laser_messages[6])
/** Requests the serial number. */
#define PH_LASER_REQ_GET_ID (&ph_laser_messages[7])
/** Selects a filter for the ranges. */
#define PH_LASER_REQ_SET_FILTER (&ph_laser_messages[8])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_LASER_H */
