/** Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery
 * of data. Always open as player:0. Generated from interfaces/001_player.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_PLAYER_H
#define PLAYHOUSE_C_GENERATED_PLAYER_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_PLAYER_CODE 1

/** Values of DeviceReq.access. */
enum {
  PH_PLAYER_OPEN_MODE = 1,
  PH_PLAYER_CLOSE_MODE = 2,
  PH_PLAYER_ERROR_MODE = 3,
};

/** Values of DeviceDatamodeReq.mode. */
enum {
  PH_PLAYER_DATAMODE_PUSH = 1,
  PH_PLAYER_DATAMODE_PULL = 2,
};

/** Values of AddReplaceRuleReq.replace. */
enum {
  PH_PLAYER_MSG_REPLACE_RULE_ACCEPT = 0,
  PH_PLAYER_MSG_REPLACE_RULE_REPLACE = 1,
  PH_PLAYER_MSG_REPLACE_RULE_IGNORE = 2,
};

/** The devices of a server. (player_device_devlist_t) */
typedef struct ph_player_device_devlist {
  /** In the order of creation, without player:0. At most 4096. */
  const ph_common_devaddr *devices;
  uint32_t devices_count;
} ph_player_device_devlist;
PH_CODEC(ph_player_device_devlist)

/** A device and the driver behind it. (player_device_driverinfo_t) */
typedef struct ph_player_device_driverinfo {
  /** The queried device. */
  ph_common_devaddr addr;
  /** NUL-terminated; empty in the request. At most 64. */
  const char *driver_name;
  uint32_t driver_name_count;
} ph_player_device_driverinfo;
PH_CODEC(ph_player_device_driverinfo)

/** Request to open or close a device, and its answer. (player_device_req_t) */
typedef struct ph_player_device_req {
  /** The device; in the answer, completed with host and robot. */
  ph_common_devaddr addr;
  /** Requested or granted access. */
  uint8_t access;
  /** NUL-terminated; empty in the request. At most 64. */
  const char *driver_name;
  uint32_t driver_name_count;
} ph_player_device_req;
PH_CODEC(ph_player_device_req)

/** A delivery mode. (player_device_datamode_req_t) */
typedef struct ph_player_device_datamode_req {
  /** Push or pull. */
  uint8_t mode;
} ph_player_device_datamode_req;
PH_CODEC(ph_player_device_datamode_req)

/** A key. (player_device_auth_req_t) */
typedef struct ph_player_device_auth_req {
  /** At most 32. */
  const uint8_t *auth_key;
  uint32_t auth_key_count;
} ph_player_device_auth_req;
PH_CODEC(ph_player_device_auth_req)

/** A robot's name and its port. (player_device_nameservice_req_t) */
typedef struct ph_player_device_nameservice_req {
  /** At most 64. */
  const uint8_t *name;
  uint32_t name_count;
  /** 0 in the request. */
  uint16_t port;
} ph_player_device_nameservice_req;
PH_CODEC(ph_player_device_nameservice_req)

/** Messages to which a rule applies, and its effect; -1 matches anything. (player_add_replace_rule_req_t) */
typedef struct ph_player_add_replace_rule_req {
  /** Interface code, or -1. */
  int32_t interf;
  /** Device index, or -1. */
  int32_t index;
  /** Message type, or -1. */
  int32_t type;
  /** Message subtype, or -1. */
  int32_t subtype;
  /** Keep all, keep the newest, or drop. */
  int32_t replace;
} ph_player_add_replace_rule_req;
PH_CODEC(ph_player_add_replace_rule_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_player_messages[10];
/** Lists the devices that this connection can open. */
#define PH_PLAYER_REQ_DEVLIST (&ph_player_messages[0])
/** Requests the name of the driver behind a device. */
#define PH_PLAYER_REQ_DRIVERINFO (&ph_player_messages[1])
/** Opens or closes a device; the answer has the granted access. */
#define PH_PLAYER_REQ_DEV (&ph_player_messages[2])
/** Requests one round of data, in pull mode; a synch ends the round. */
#define PH_PLAYER_REQ_DATA (&ph_player_messages[3])
/** Selects the delivery mode: immediately (push) or on request (pull). */
#define PH_PLAYER_REQ_DATAMODE (&ph_player_messages[4])
/** Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
 * admits nobody. */
#define PH_PLAYER_REQ_AUTH (&ph_player_messages[5])
/** Requests the port of a named robot; unused, answered by NACK. */
#define PH_PLAYER_REQ_NAMESERVICE (&ph_player_messages[6])
/** Adds a replace rule: which queued messages a newer one replaces. */
#define PH_PLAYER_REQ_ADD_REPLACE_RULE (&ph_player_messages[7])
/** Ends a round of data; no message was dropped since the previous one. */
#define PH_PLAYER_SYNCH_OK (&ph_player_messages[8])
/** Ends a round of data; the body is the number of messages dropped since the previous one. */
#define PH_PLAYER_SYNCH_OVERFLOW (&ph_player_messages[9])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_PLAYER_H */
