/** Names of interfaces and of kinds of messages. */
#ifndef LIBPLAYERINTERFACE_INTERFACE_UTIL_H
#define LIBPLAYERINTERFACE_INTERFACE_UTIL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The name of an interface, "unknown" if no interface has that code. */
const char *interf_to_str(uint16_t code);
/** The same, NULL if no interface has that code; `start` has no meaning here. */
const char *lookup_interface_name(unsigned int start, int code);
/** The code of an interface, 0xFFFF if there is none of that name. */
uint16_t str_to_interf(const char *name);
/** The name of a PLAYER_MSGTYPE_ constant, "unknown" of any other number. */
const char *msgtype_to_str(uint8_t type);

#ifdef __cplusplus
}
#endif

#endif /* LIBPLAYERINTERFACE_INTERFACE_UTIL_H */
