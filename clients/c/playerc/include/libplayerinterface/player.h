/** Player's messages: their header, and through player_interfaces.h the bodies. */
#ifndef LIBPLAYERINTERFACE_PLAYER_H
#define LIBPLAYERINTERFACE_PLAYER_H

#include <libplayercommon/playercommon.h>
#include <libplayerinterface/player_interfaces.h>
#include <playerconfig.h>
#include <stdint.h>

/** Kinds of messages: player_msghdr_t.type. */
#define PLAYER_MSGTYPE_DATA 1
#define PLAYER_MSGTYPE_CMD 2
#define PLAYER_MSGTYPE_REQ 3
#define PLAYER_MSGTYPE_RESP_ACK 4
#define PLAYER_MSGTYPE_SYNCH 5
#define PLAYER_MSGTYPE_RESP_NACK 6

/** The same request by its misspelt name, which programs use as well. */
#define PLAYER_CAPABILTIES_REQ PLAYER_CAPABILITIES_REQ

/** How a server's greeting begins. */
#define PLAYER_IDENT_STRING "Player v."

/** How points are joined to shapes: the PLAYER_DRAW_ constants. */
typedef uint32_t player_graphics3d_draw_mode_t;

/** What precedes the body of a message. */
typedef struct player_msghdr {
  player_devaddr_t addr;
  uint8_t type;
  uint8_t subtype;
  /** In s. */
  double timestamp;
  uint32_t seq;
  /** Of the encoded body, in bytes. */
  uint32_t size;
} player_msghdr_t;

#define PLAYER_MAX_PAYLOAD_SIZE (PLAYER_MAX_MESSAGE_SIZE - sizeof(player_msghdr_t))

#endif /* LIBPLAYERINTERFACE_PLAYER_H */
