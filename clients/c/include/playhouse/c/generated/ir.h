/** Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface.
 * Generated from interfaces/022_ir.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_IR_H
#define PLAYHOUSE_C_GENERATED_IR_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_IR_CODE 22

/** Measurements of the sensors. (player_ir_data_t) */
typedef struct ph_ir_data {
  /** One per sensor, as measured (in V). */
  const float *voltages;
  uint32_t voltages_count;
  /** One per sensor, computed from the voltage (in m). */
  const float *ranges;
  uint32_t ranges_count;
} ph_ir_data;
PH_CODEC(ph_ir_data)

/** Poses of the sensors. (player_ir_pose_t) */
typedef struct ph_ir_pose {
  /** One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS). */
  const ph_common_pose3d *poses;
  uint32_t poses_count;
} ph_ir_pose;
PH_CODEC(ph_ir_pose)

/** The sensors' switch. (player_ir_power_req_t) */
typedef struct ph_ir_power_req {
  /** 1: on, 0: off. */
  uint8_t state;
} ph_ir_power_req;
PH_CODEC(ph_ir_power_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_ir_messages[3];
/** Voltages and ranges. */
#define PH_IR_DATA_RANGES (&ph_ir_messages[0])
/** Requests the poses of the sensors. */
#define PH_IR_REQ_POSE (&ph_ir_messages[1])
/** Switches the sensors on or off. */
#define PH_IR_REQ_POWER (&ph_ir_messages[2])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_IR_H */
