/** Interface ptz, code 8. A camera mount that pans, tilts and zooms. Generated from
 * interfaces/008_ptz.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_PTZ_H
#define PLAYHOUSE_C_GENERATED_PTZ_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_PTZ_CODE 8

/** Values of ReqControlMode.mode. */
enum {
  PH_PTZ_VELOCITY_CONTROL = 0,
  PH_PTZ_POSITION_CONTROL = 1,
};

/** Direction of the mount. (player_ptz_data_t) */
typedef struct ph_ptz_data {
  /** Positive to the left (in rad). */
  float pan;
  /** Positive upwards (in rad). */
  float tilt;
  /** Field of view (in rad). */
  float zoom;
  /** Positive to the left (in rad/s). */
  float panspeed;
  /** Positive upwards (in rad/s). */
  float tiltspeed;
  /** Driver-specific. */
  uint32_t status;
} ph_ptz_data;
PH_CODEC(ph_ptz_data)

/** Commanded direction or velocity of the mount. (player_ptz_cmd_t) */
typedef struct ph_ptz_cmd {
  /** Positive to the left (in rad). */
  float pan;
  /** Positive upwards (in rad). */
  float tilt;
  /** Field of view (in rad). */
  float zoom;
  /** Used by velocity control (in rad/s). */
  float panspeed;
  /** Used by velocity control (in rad/s). */
  float tiltspeed;
} ph_ptz_cmd;
PH_CODEC(ph_ptz_cmd)

/** The mount's status. (player_ptz_req_status_t) */
typedef struct ph_ptz_req_status {
  /** Driver-specific. */
  uint32_t status;
} ph_ptz_req_status;
PH_CODEC(ph_ptz_req_status)

/** The mount's size and pose. (player_ptz_geom_t) */
typedef struct ph_ptz_geom {
  /** Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS). */
  ph_common_pose3d pos;
  /** Bounding box of the mount (in m, m, m). */
  ph_common_bbox3d size;
} ph_ptz_geom;
PH_CODEC(ph_ptz_geom)

/** Driver-specific words. (player_ptz_req_generic_t) */
typedef struct ph_ptz_req_generic {
  /** Driver-specific. */
  const uint32_t *config;
  uint32_t config_count;
} ph_ptz_req_generic;
PH_CODEC(ph_ptz_req_generic)

/** A control mode. (player_ptz_req_control_mode_t) */
typedef struct ph_ptz_req_control_mode {
  /** Velocity or position. */
  uint32_t mode;
} ph_ptz_req_control_mode;
PH_CODEC(ph_ptz_req_control_mode)

/** The messages, each under its name below. */
extern const ph_message_type ph_ptz_messages[7];
/** Direction of the mount. */
#define PH_PTZ_DATA_STATE (&ph_ptz_messages[0])
/** Size and pose, sent on change. */
#define PH_PTZ_DATA_GEOM (&ph_ptz_messages[1])
/** Commanded direction of the mount. */
#define PH_PTZ_CMD_STATE (&ph_ptz_messages[2])
/** Exchanges driver-specific words with the mount. */
#define PH_PTZ_REQ_GENERIC (&ph_ptz_messages[3])
/** Selects between velocity and position control. */
#define PH_PTZ_REQ_CONTROL_MODE (&ph_ptz_messages[4])
/** Requests size and pose. */
#define PH_PTZ_REQ_GEOM (&ph_ptz_messages[5])
/** Requests the mount's status. */
#define PH_PTZ_REQ_STATUS (&ph_ptz_messages[6])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_PTZ_H */
