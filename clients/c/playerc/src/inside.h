/** What the proxies of this library are made of. */
#ifndef LIBPLAYERC_INSIDE_H
#define LIBPLAYERC_INSIDE_H

#include <stdbool.h>
#include <stdlib.h>

#include "libplayerc/playerc.h"
#include "playhouse/c/error.h"

#if defined(__GNUC__)
#define PLAYERC_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define PLAYERC_FORMAT
#endif

/** Sets the text of playerc_error_str(); returns -1. */
int playerc_fail(const char *format, ...) PLAYERC_FORMAT;
/** The same of an error of the C client library; returns -2 of a refusal. */
int playerc_fail_as(const ph_error *error);
int playerc_fail_no_memory(void);

/** A new proxy of `size` bytes that begins with its playerc_device_t; NULL without memory. */
void *playerc_proxy_create(size_t size, playerc_client_t *client, int code, int index,
                           playerc_putmsg_fn_t putmsg);
/** Ends it and releases its memory. */
void playerc_proxy_destroy(playerc_device_t *device);

/** The functions that all proxies have. PUTMSG, which may be NULL, takes data; RELEASE releases the lists of a proxy. */
#define PLAYERC_PROXY(NAME, CODE, PUTMSG, RELEASE)                                        \
  playerc_##NAME##_t *playerc_##NAME##_create(playerc_client_t *client, int index) {      \
    return playerc_proxy_create(sizeof(playerc_##NAME##_t), client, CODE, index, PUTMSG); \
  }                                                                                       \
  void playerc_##NAME##_destroy(playerc_##NAME##_t *device) {                             \
    if (device == NULL) return;                                                           \
    RELEASE(device);                                                                      \
    playerc_proxy_destroy(&device->info);                                                 \
  }                                                                                       \
  int playerc_##NAME##_subscribe(playerc_##NAME##_t *device, int access) {                \
    return playerc_device_subscribe(&device->info, access);                               \
  }                                                                                       \
  int playerc_##NAME##_unsubscribe(playerc_##NAME##_t *device) {                          \
    return playerc_device_unsubscribe(&device->info);                                     \
  }

/** RELEASE of a proxy without lists. */
#define PLAYERC_NO_LISTS(DEVICE) (void)(DEVICE)

/** The subtype of a message to a PUTMSG. */
static inline int playerc_subtype(const char *header) {
  return ((const player_msghdr_t *)(const void *)header)->subtype;
}

/** Makes `*list`, which may be NULL, a copy of `count` elements of `size` bytes; false without memory, it is then as
 * before. */
bool playerc_keep(void *list, const void *from, size_t count, size_t size);
/** Makes room for as many; what is in it then is not defined. */
bool playerc_room(void *list, size_t count, size_t size);

/** Sends a command. The payload may be NULL. */
int playerc_command(playerc_device_t *device, uint8_t subtype, const void *payload);
/** Sends a request that is answered without a body, or by one that says nothing. */
int playerc_tell(playerc_device_t *device, uint8_t subtype, const void *payload);
/** Sends a request whose answer must have a body: `*answer`, to be released by its T_free(). */
int playerc_ask(playerc_device_t *device, uint8_t subtype, const void *payload, void *answer);

/** The number of bytes of a text in a message, with its NUL. */
uint32_t playerc_text_count(const char *text);
/** A text as the member of a message, which does not write to it. */
static inline char *playerc_text(const char *text) {
  return (char *)(uintptr_t)text;
}

#endif /* LIBPLAYERC_INSIDE_H */
