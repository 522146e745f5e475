/** Interface wsn, code 57. A network of wireless sensor nodes. Generated from interfaces/057_wsn.toml by
 * codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_WSN_H
#define PLAYHOUSE_C_GENERATED_WSN_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_WSN_CODE 57

/** Readings, raw or converted as selected by DATATYPE. (player_wsn_node_data_t) */
typedef struct ph_wsn_node_data {
  /** In 1 or lx. */
  float light;
  float mic;
  /** In 1 or m/s^2. */
  float accel_x;
  /** In 1 or m/s^2. */
  float accel_y;
  /** In 1 or m/s^2. */
  float accel_z;
  /** In 1 or G. */
  float magn_x;
  /** In 1 or G. */
  float magn_y;
  /** In 1 or G. */
  float magn_z;
  /** In 1 or degC. */
  float temperature;
  /** In 1 or V. */
  float battery;
} ph_wsn_node_data;
PH_CODEC(ph_wsn_node_data)

/** Readings of one node. (player_wsn_data_t) */
typedef struct ph_wsn_data {
  /** Type of node. */
  uint32_t node_type;
  /** Id of the node. */
  uint32_t node_id;
  /** Node that relayed the readings. */
  uint32_t node_parent_id;
  ph_wsn_node_data data_packet;
} ph_wsn_data;
PH_CODEC(ph_wsn_data)

/** Switch of an actuator of a node. (player_wsn_cmd_t) */
typedef struct ph_wsn_cmd {
  /** Id of the node; -1: all. */
  int32_t node_id;
  /** Group of the node; -1: all. */
  int32_t group_id;
  /** Actuator, such as a light or a buzzer. */
  uint32_t device;
  /** 1: on, 0: off. */
  uint8_t enable;
} ph_wsn_cmd;
PH_CODEC(ph_wsn_cmd)

/** Sleep mode of nodes. (player_wsn_power_config_t) */
typedef struct ph_wsn_power_config {
  /** Id of the node; -1: all. */
  int32_t node_id;
  /** Group of the node; -1: all. */
  int32_t group_id;
  /** 0: asleep, 1: awake, 2: driver-specific. */
  uint8_t value;
} ph_wsn_power_config;
PH_CODEC(ph_wsn_power_config)

/** Format of readings. (player_wsn_datatype_config_t) */
typedef struct ph_wsn_datatype_config {
  /** 0: raw, 1: converted. */
  uint8_t value;
} ph_wsn_datatype_config;
PH_CODEC(ph_wsn_datatype_config)

/** Rate of reports. (player_wsn_datafreq_config_t) */
typedef struct ph_wsn_datafreq_config {
  /** Id of the node; -1: all. */
  int32_t node_id;
  /** Group of the node; -1: all. */
  int32_t group_id;
  /** In Hz. */
  double frequency;
} ph_wsn_datafreq_config;
PH_CODEC(ph_wsn_datafreq_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_wsn_messages[5];
/** Readings of one node. */
#define PH_WSN_DATA_STATE (&ph_wsn_messages[0])
/** Switches an actuator of a node. */
#define PH_WSN_CMD_DEVSTATE (&ph_wsn_messages[1])
/** Puts nodes to sleep or wakes them. */
#define PH_WSN_REQ_POWER (&ph_wsn_messages[2])
/** Selects between raw and converted readings. */
#define PH_WSN_REQ_DATATYPE (&ph_wsn_messages[3])
/** Sets the reporting rate of nodes. */
#define PH_WSN_REQ_DATAFREQ (&ph_wsn_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_WSN_H */
