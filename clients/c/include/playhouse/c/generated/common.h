/** What every interface shares. Types shared by several interfaces, and requests to any device. Generated
 * from interfaces/000_common.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_COMMON_H
#define PLAYHOUSE_C_GENERATED_COMMON_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Limits shared by all implementations of the protocol. */
enum {
  PH_COMMON_MAX_MESSAGE_SIZE = 8388608,
  PH_COMMON_MAX_DRIVER_STRING_LEN = 64,
  PH_COMMON_MAX_DEVICES = 4096,
  PH_COMMON_MSGQUEUE_DEFAULT_MAXLEN = 1024,
  PH_COMMON_IDENT_STRLEN = 32,
  PH_COMMON_KEYLEN = 32,
};

/** Address of a device. (player_devaddr_t) */
typedef struct ph_common_devaddr {
  /** Host of the device's server; receivers compare only interf and index. */
  uint32_t host;
  /** TCP port of the device's server: its name space. */
  uint32_t robot;
  /** Interface code. */
  uint16_t interf;
  /** Index of the device within its interface. */
  uint16_t index;
} ph_common_devaddr;
PH_CODEC(ph_common_devaddr)

/** A point or vector in the plane. (player_point_2d_t) */
typedef struct ph_common_point2d {
  /** In m. */
  double px;
  /** In m. */
  double py;
} ph_common_point2d;
PH_CODEC(ph_common_point2d)

/** A point or vector in space. (player_point_3d_t) */
typedef struct ph_common_point3d {
  /** In m. */
  double px;
  /** In m. */
  double py;
  /** In m. */
  double pz;
} ph_common_point3d;
PH_CODEC(ph_common_point3d)

/** An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
 * (player_orientation_3d_t) */
typedef struct ph_common_orientation3d {
  /** About x (in rad). */
  double proll;
  /** About y (in rad). */
  double ppitch;
  /** About z (in rad). */
  double pyaw;
} ph_common_orientation3d;
PH_CODEC(ph_common_orientation3d)

/** A pose in the plane, or, if the message says so, a velocity with the same three components.
 * (player_pose2d_t) */
typedef struct ph_common_pose2d {
  /** In m. */
  double px;
  /** In m. */
  double py;
  /** Heading, counter-clockwise from x (in rad). */
  double pa;
} ph_common_pose2d;
PH_CODEC(ph_common_pose2d)

/** A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
 * (player_pose3d_t) */
typedef struct ph_common_pose3d {
  /** In m. */
  double px;
  /** In m. */
  double py;
  /** In m. */
  double pz;
  /** About x (in rad). */
  double proll;
  /** About y (in rad). */
  double ppitch;
  /** About z (in rad). */
  double pyaw;
} ph_common_pose3d;
PH_CODEC(ph_common_pose3d)

/** Size of a bounding rectangle. (player_bbox2d_t) */
typedef struct ph_common_bbox2d {
  /** Width, along y (in m). */
  double sw;
  /** Length, along x (in m). */
  double sl;
} ph_common_bbox2d;
PH_CODEC(ph_common_bbox2d)

/** Size of a bounding box. (player_bbox3d_t) */
typedef struct ph_common_bbox3d {
  /** Width, along y (in m). */
  double sw;
  /** Length, along x (in m). */
  double sl;
  /** Height, along z (in m). */
  double sh;
} ph_common_bbox3d;
PH_CODEC(ph_common_bbox3d)

/** One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t) */
typedef struct ph_common_blackboard_entry {
  /** Name of the entry within its group. */
  const char *key;
  uint32_t key_count;
  /** Name of the group, a namespace of keys. */
  const char *group;
  uint32_t group_count;
  /** Category of `data`: simple values or types of other interfaces. */
  uint16_t type;
  /** Exact type of `data`; of simple values: string, integer or floating-point number. */
  uint16_t subtype;
  /** Bytes of the value, opaque to the blackboard. */
  const uint8_t *data;
  uint32_t data_count;
  /** Time at which the value was set: whole seconds (in s). */
  uint32_t timestamp_sec;
  /** Time at which the value was set: microseconds of the second (in us). */
  uint32_t timestamp_usec;
} ph_common_blackboard_entry;
PH_CODEC(ph_common_blackboard_entry)

/** A line segment. (player_segment_t) */
typedef struct ph_common_segment {
  /** x of the start (in m). */
  double x0;
  /** y of the start (in m). */
  double y0;
  /** x of the end (in m). */
  double x1;
  /** y of the end (in m). */
  double y1;
} ph_common_segment;
PH_CODEC(ph_common_segment)

/** An axis-aligned rectangle, given by two corners. (player_extent2d_t) */
typedef struct ph_common_extent2d {
  /** Smallest x (in m). */
  double x0;
  /** Smallest y (in m). */
  double y0;
  /** Largest x (in m). */
  double x1;
  /** Largest y (in m). */
  double y1;
} ph_common_extent2d;
PH_CODEC(ph_common_extent2d)

/** A color with opacity, each component from 0 to 255. (player_color_t) */
typedef struct ph_common_color {
  /** 255 is opaque, 0 invisible. */
  uint8_t alpha;
  uint8_t red;
  uint8_t green;
  uint8_t blue;
} ph_common_color;
PH_CODEC(ph_common_color)

/** A switch. (player_bool_t) */
typedef struct ph_common_bool {
  /** 0: off, else on. */
  uint8_t state;
} ph_common_bool;
PH_CODEC(ph_common_bool)

/** One integer. (player_uint32_t) */
typedef struct ph_common_uint32 {
  uint32_t value;
} ph_common_uint32;
PH_CODEC(ph_common_uint32)

/** The queried message. (player_capabilities_req_t) */
typedef struct ph_common_capabilities_req {
  /** Type of the message, as in a header. */
  uint32_t type;
  /** Subtype of the message, as in a header. */
  uint32_t subtype;
} ph_common_capabilities_req;
PH_CODEC(ph_common_capabilities_req)

/** A named switch. (player_boolprop_req_t) */
typedef struct ph_common_boolprop_req {
  /** Name of the property, NUL-terminated. */
  const char *key;
  uint32_t key_count;
  /** 0 false, else true; ignored in a request. */
  char value;
} ph_common_boolprop_req;
PH_CODEC(ph_common_boolprop_req)

/** A named integer. (player_intprop_req_t) */
typedef struct ph_common_intprop_req {
  /** Name of the property, NUL-terminated. */
  const char *key;
  uint32_t key_count;
  /** Ignored in a question. */
  int32_t value;
} ph_common_intprop_req;
PH_CODEC(ph_common_intprop_req)

/** A named number. (player_dblprop_req_t) */
typedef struct ph_common_dblprop_req {
  /** Name of the property, NUL-terminated. */
  const char *key;
  uint32_t key_count;
  /** In the driver's unit for the property; ignored in a request. */
  double value;
} ph_common_dblprop_req;
PH_CODEC(ph_common_dblprop_req)

/** A named string. (player_strprop_req_t) */
typedef struct ph_common_strprop_req {
  /** Name of the property, NUL-terminated. */
  const char *key;
  uint32_t key_count;
  /** NUL-terminated; ignored in a request. */
  const char *value;
  uint32_t value_count;
} ph_common_strprop_req;
PH_CODEC(ph_common_strprop_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_common_messages[9];
/** Changes a named switch of the driver. */
#define PH_COMMON_REQ_SET_BOOLPROP (&ph_common_messages[0])
/** Reads a named switch of the driver; the answer repeats the key. */
#define PH_COMMON_REQ_GET_BOOLPROP (&ph_common_messages[1])
/** Changes a named string of the driver. */
#define PH_COMMON_REQ_SET_STRPROP (&ph_common_messages[2])
/** Reads a named string of the driver; the answer repeats the key. */
#define PH_COMMON_REQ_GET_STRPROP (&ph_common_messages[3])
/** Changes a named number of the driver. */
#define PH_COMMON_REQ_SET_DBLPROP (&ph_common_messages[4])
/** Reads a named number of the driver; the answer repeats the key. */
#define PH_COMMON_REQ_GET_DBLPROP (&ph_common_messages[5])
/** Changes a named integer of the driver. */
#define PH_COMMON_REQ_SET_INTPROP (&ph_common_messages[6])
/** Reads a named integer of the driver; the answer repeats the key. */
#define PH_COMMON_REQ_GET_INTPROP (&ph_common_messages[7])
/** Queries whether the device supports a message: an empty ACK means yes, NACK no. */
#define PH_COMMON_REQ_CAPABILITIES (&ph_common_messages[8])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_COMMON_H */
