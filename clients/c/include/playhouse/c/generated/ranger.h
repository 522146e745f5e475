/** Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays.
 * Generated from interfaces/062_ranger.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_RANGER_H
#define PLAYHOUSE_C_GENERATED_RANGER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_RANGER_CODE 62

/** Angles, ranges and rate. (player_ranger_config_t) */
typedef struct ph_ranger_config {
  /** Of the first beam, counter-clockwise from x (in rad). */
  double min_angle;
  /** Of the last beam (in rad). */
  double max_angle;
  /** Angle between neighbouring beams (in rad). */
  double angular_res;
  /** Minimum range (in m). */
  double min_range;
  /** Maximum range, and reported range of a beam without a hit (in m). */
  double max_range;
  /** Range resolution (in m). */
  double range_res;
  /** Scans per second (in Hz). */
  double frequency;
} ph_ranger_config;
PH_CODEC(ph_ranger_config)

/** Size and pose of the device and its elements. (player_ranger_geom_t) */
typedef struct ph_ranger_geom {
  /** Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pose;
  /** Bounding box of the device (in m, m, m). */
  ph_common_bbox3d size;
  /** One per element; x points along its beam, or along the middle of its scan (in m, m, m, rad, rad, rad,
   * frame X_SE). */
  const ph_common_pose3d *element_poses;
  uint32_t element_poses_count;
  /** One per element (in m, m, m). */
  const ph_common_bbox3d *element_sizes;
  uint32_t element_sizes_count;
} ph_ranger_geom;
PH_CODEC(ph_ranger_geom)

/** Ranges. (player_ranger_data_range_t) */
typedef struct ph_ranger_data_range {
  /** Beam by beam from right to left, element by element (in m). */
  const double *ranges;
  uint32_t ranges_count;
} ph_ranger_data_range;
PH_CODEC(ph_ranger_data_range)

/** Ranges with geometry and configuration. (player_ranger_data_rangestamped_t) */
typedef struct ph_ranger_data_rangestamped {
  ph_ranger_data_range data;
  /** 1 if `geom` is valid. */
  uint8_t have_geom;
  ph_ranger_geom geom;
  /** 1 if `config` is valid. */
  uint8_t have_config;
  ph_ranger_config config;
} ph_ranger_data_rangestamped;
PH_CODEC(ph_ranger_data_rangestamped)

/** Intensities. (player_ranger_data_intns_t) */
typedef struct ph_ranger_data_intns {
  /** In the order of the ranges; driver-specific scale. */
  const double *intensities;
  uint32_t intensities_count;
} ph_ranger_data_intns;
PH_CODEC(ph_ranger_data_intns)

/** Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t) */
typedef struct ph_ranger_data_intnsstamped {
  ph_ranger_data_intns data;
  /** 1 if `geom` is valid. */
  uint8_t have_geom;
  ph_ranger_geom geom;
  /** 1 if `config` is valid. */
  uint8_t have_config;
  ph_ranger_config config;
} ph_ranger_data_intnsstamped;
PH_CODEC(ph_ranger_data_intnsstamped)

/** The device's switch. (player_ranger_power_config_t) */
typedef struct ph_ranger_power_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_ranger_power_config;
PH_CODEC(ph_ranger_power_config)

/** The switch of intensities. (player_ranger_intns_config_t) */
typedef struct ph_ranger_intns_config {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_ranger_intns_config;
PH_CODEC(ph_ranger_intns_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_ranger_messages[10];
/** Ranges. */
#define PH_RANGER_DATA_RANGE (&ph_ranger_messages[0])
/** Ranges with the geometry and configuration of the measurement. */
#define PH_RANGER_DATA_RANGESTAMPED (&ph_ranger_messages[1])
/** Intensities. */
#define PH_RANGER_DATA_INTNS (&ph_ranger_messages[2])
/** Intensities with the geometry and configuration of the measurement. */
#define PH_RANGER_DATA_INTNSSTAMPED (&ph_ranger_messages[3])
/** Size and pose, sent on change. */
#define PH_RANGER_DATA_GEOM (&ph_ranger_messages[4])
/** Requests size and pose. */
#define PH_RANGER_REQ_GET_GEOM (&ph_ranger_messages[5])
/** Switches the device on or off. */
#define PH_RANGER_REQ_POWER (&ph_ranger_messages[6])
/** Switches intensities on or off. */
#define PH_RANGER_REQ_INTNS (&ph_ranger_messages[7])
/** Sets angles, ranges and rate; the answer has the values in effect. */
#define PH_RANGER_REQ_SET_CONFIG (&ph_ranger_messages[8])
/** Requests angles, ranges and rate. */
#define PH_RANGER_REQ_GET_CONFIG (&ph_ranger_messages[9])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_RANGER_H */
