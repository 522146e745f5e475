/** Interface simulation, code 31. A simulator: reads and moves its models, pauses and resets it. Generated
 * from interfaces/031_simulation.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_SIMULATION_H
#define PLAYHOUSE_C_GENERATED_SIMULATION_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_SIMULATION_CODE 31

/** Not sent by any message. (player_simulation_data_t) */
typedef struct ph_simulation_data {
  /** Without meaning. */
  uint8_t data;
} ph_simulation_data;
PH_CODEC(ph_simulation_data)

/** Not sent by any message. (player_simulation_cmd_t) */
typedef struct ph_simulation_cmd {
  /** Without meaning. */
  uint8_t cmd;
} ph_simulation_cmd;
PH_CODEC(ph_simulation_cmd)

/** A model and its pose. (player_simulation_pose2d_req_t) */
typedef struct ph_simulation_pose2d_req {
  /** Of the model, NUL-terminated. */
  const char *name;
  uint32_t name_count;
  /** Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m,
   * rad, frame X_PT). */
  ph_common_pose2d pose;
} ph_simulation_pose2d_req;
PH_CODEC(ph_simulation_pose2d_req)

/** A model, its pose and the time. (player_simulation_pose3d_req_t) */
typedef struct ph_simulation_pose3d_req {
  /** Of the model, NUL-terminated. */
  const char *name;
  uint32_t name_count;
  /** Pose of the model in its parent (the world for a top-level model); ignored in a request (in m, m, m,
   * rad, rad, rad, frame X_PT). */
  ph_common_pose3d pose;
  /** Simulated time of the pose, as counted by Stage; set in answers only (in us). */
  double simtime;
} ph_simulation_pose3d_req;
PH_CODEC(ph_simulation_pose3d_req)

/** A property of a model. (player_simulation_property_req_t) */
typedef struct ph_simulation_property_req {
  /** Name of the model, NUL-terminated; empty for a property of the world. */
  const char *name;
  uint32_t name_count;
  /** Name of the property, NUL-terminated. */
  const char *prop;
  uint32_t prop_count;
  /** Element of a list property: in a request the first one requested, in an answer the first of the next
   * request, 0 at the end of the list. */
  uint32_t index;
  /** Bytes of the property, in a simulator-specific format; empty in a request. */
  const char *value;
  uint32_t value_count;
} ph_simulation_property_req;
PH_CODEC(ph_simulation_property_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_simulation_messages[9];
/** Pauses or resumes the simulated clock. */
#define PH_SIMULATION_CMD_PAUSE (&ph_simulation_messages[0])
/** Resets the world to its start. */
#define PH_SIMULATION_CMD_RESET (&ph_simulation_messages[1])
/** Saves the current world. */
#define PH_SIMULATION_CMD_SAVE (&ph_simulation_messages[2])
/** Requests the pose of a model by name. */
#define PH_SIMULATION_REQ_GET_POSE2D (&ph_simulation_messages[3])
/** Moves a model by name. */
#define PH_SIMULATION_REQ_SET_POSE2D (&ph_simulation_messages[4])
/** Requests the pose of a model by name, and the time. */
#define PH_SIMULATION_REQ_GET_POSE3D (&ph_simulation_messages[5])
/** Moves a model by name. */
#define PH_SIMULATION_REQ_SET_POSE3D (&ph_simulation_messages[6])
/** Requests a property of a model by name; without a name, for "models", the list of all with their
 * devices (docs/drivers.md). */
#define PH_SIMULATION_REQ_GET_PROPERTY (&ph_simulation_messages[7])
/** Sets a property of a model by name. */
#define PH_SIMULATION_REQ_SET_PROPERTY (&ph_simulation_messages[8])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_SIMULATION_H */
