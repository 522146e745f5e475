/** Interface coopobject, code 66. Cooperating objects: fixed and moving sensor nodes and robots that
 * report to each other. Generated from interfaces/066_coopobject.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_COOPOBJECT_H
#define PLAYHOUSE_C_GENERATED_COOPOBJECT_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_COOPOBJECT_CODE 66

/** Values of Header.origin. */
enum {
  PH_COOPOBJECT_ORIGIN_STATICBASE = 0,
  PH_COOPOBJECT_ORIGIN_MOBILEBASE = 1,
  PH_COOPOBJECT_ORIGIN_MOTE = 2,
  PH_COOPOBJECT_ORIGIN_ROBOT = 3,
};

/** Types of messages between nodes. */
enum {
  PH_COOPOBJECT_MSG_NONE = -1,
  PH_COOPOBJECT_MSG_HEALTH = 0,
  PH_COOPOBJECT_MSG_POSITION = 1,
  PH_COOPOBJECT_MSG_RSSI = 2,
  PH_COOPOBJECT_MSG_SENSOR = 3,
  PH_COOPOBJECT_MSG_ALARM = 4,
  PH_COOPOBJECT_MSG_REQUEST = 5,
  PH_COOPOBJECT_MSG_COMMAND = 6,
};

/** Values of Sensor.type. */
enum {
  PH_COOPOBJECT_TEMPERATURE = 0,
  PH_COOPOBJECT_HUMIDITY = 1,
  PH_COOPOBJECT_PRESSURE = 2,
  PH_COOPOBJECT_LIGHT_1 = 3,
  PH_COOPOBJECT_LIGHT_2 = 4,
  PH_COOPOBJECT_ACCEL_X = 5,
  PH_COOPOBJECT_ACCEL_Y = 6,
  PH_COOPOBJECT_ACCEL_Z = 7,
  PH_COOPOBJECT_MAGNETOMETER_X = 8,
  PH_COOPOBJECT_MAGNETOMETER_Y = 9,
  PH_COOPOBJECT_MAGNETOMETER_Z = 10,
  PH_COOPOBJECT_COMPASS = 11,
  PH_COOPOBJECT_CO = 12,
  PH_COOPOBJECT_CO2 = 13,
  PH_COOPOBJECT_H2 = 14,
  PH_COOPOBJECT_SMOKE = 15,
  PH_COOPOBJECT_OPTSWITCH = 16,
};

/** Id of the node. (player_coopobject_header_t) */
typedef struct ph_coopobject_header {
  /** Type of node. */
  uint8_t origin;
  uint16_t id;
  /** Node that relayed the message. */
  uint16_t parent_id;
} ph_coopobject_header;
PH_CODEC(ph_coopobject_header)

/** Radio signal strength. (player_coopobject_rssi_t) */
typedef struct ph_coopobject_rssi {
  ph_coopobject_header header;
  /** Node that sent the signal. */
  uint16_t sender_id;
  /** As the radio reports it. */
  uint16_t rssi;
  /** Counter of measurements. */
  uint16_t stamp;
  /** Clock of the node: upper half. */
  uint32_t nodeTimeHigh;
  /** Clock of the node: lower half. */
  uint32_t nodeTimeLow;
  /** Position of the receiver (in m, frame p_WS). */
  float x;
  /** In m, frame p_WS. */
  float y;
  /** In m, frame p_WS. */
  float z;
} ph_coopobject_rssi;
PH_CODEC(ph_coopobject_rssi)

/** Position of a node. (player_coopobject_position_t) */
typedef struct ph_coopobject_position {
  ph_coopobject_header header;
  /** In m, frame p_WS. */
  float x;
  /** In m, frame p_WS. */
  float y;
  /** In m, frame p_WS. */
  float z;
  /** Driver-specific. */
  uint8_t status;
} ph_coopobject_position;
PH_CODEC(ph_coopobject_position)

/** One reading. (player_coopobject_sensor_t) */
typedef struct ph_coopobject_sensor {
  /** Measured quantity. */
  uint8_t type;
  /** As the sensor reports it. */
  int16_t value;
} ph_coopobject_sensor;
PH_CODEC(ph_coopobject_sensor)

/** Readings of a node. (player_coopobject_data_sensor_t) */
typedef struct ph_coopobject_data_sensor {
  ph_coopobject_header header;
  const ph_coopobject_sensor *data;
  uint32_t data_count;
} ph_coopobject_data_sensor;
PH_CODEC(ph_coopobject_data_sensor)

/** Bytes from or to a node. (player_coopobject_data_userdefined_t) */
typedef struct ph_coopobject_data_userdefined {
  ph_coopobject_header header;
  /** User-specific. */
  uint8_t type;
  const uint8_t *data;
  uint32_t data_count;
} ph_coopobject_data_userdefined;
PH_CODEC(ph_coopobject_data_userdefined)

/** A request. (player_coopobject_req_t) */
typedef struct ph_coopobject_req {
  ph_coopobject_header header;
  /** Which. */
  uint8_t request;
  /** Request-specific. */
  const uint8_t *parameters;
  uint32_t parameters_count;
} ph_coopobject_req;
PH_CODEC(ph_coopobject_req)

/** A command. (player_coopobject_cmd_t) */
typedef struct ph_coopobject_cmd {
  ph_coopobject_header header;
  /** Which. */
  uint8_t command;
  /** Command-specific. */
  const uint8_t *parameters;
  uint32_t parameters_count;
} ph_coopobject_cmd;
PH_CODEC(ph_coopobject_cmd)

/** The messages, each under its name below. */
extern const ph_message_type ph_coopobject_messages[12];
/** A node is alive. */
#define PH_COOPOBJECT_DATA_HEALTH (&ph_coopobject_messages[0])
/** Signal strength received by a node. */
#define PH_COOPOBJECT_DATA_RSSI (&ph_coopobject_messages[1])
/** Readings of a node. */
#define PH_COOPOBJECT_DATA_SENSOR (&ph_coopobject_messages[2])
/** Readings of a node that crossed a threshold. */
#define PH_COOPOBJECT_DATA_ALARM (&ph_coopobject_messages[3])
/** Bytes from a node. */
#define PH_COOPOBJECT_DATA_USERDEFINED (&ph_coopobject_messages[4])
/** A request of a node. */
#define PH_COOPOBJECT_DATA_REQUEST (&ph_coopobject_messages[5])
/** A command of a node. */
#define PH_COOPOBJECT_DATA_COMMAND (&ph_coopobject_messages[6])
/** Position of a node. */
#define PH_COOPOBJECT_DATA_POSITION (&ph_coopobject_messages[7])
/** Sends a command to a node. */
#define PH_COOPOBJECT_CMD_STANDARD (&ph_coopobject_messages[8])
/** Sends bytes to a node. */
#define PH_COOPOBJECT_CMD_DATA (&ph_coopobject_messages[9])
/** Sends the position of a node to a node. */
#define PH_COOPOBJECT_CMD_POSITION (&ph_coopobject_messages[10])
/** Sends a request to a node. */
#define PH_COOPOBJECT_REQ_STANDARD (&ph_coopobject_messages[11])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_COOPOBJECT_H */
