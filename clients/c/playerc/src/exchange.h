/** How proxies and clients exchange messages with the server. */
#ifndef LIBPLAYERC_EXCHANGE_H
#define LIBPLAYERC_EXCHANGE_H

#include "inside.h"
#include "session.h"

struct playerc_session {
  ph_session wire;
  uint64_t overflow_seen; /**< what overflow_count has of wire.overflow_count */
};

/** The message of a kind and subtype with the struct of its body; NULL if the interface has none. */
const ph_message_type *playerc_find_message(uint16_t code, uint8_t kind, uint8_t subtype);

/** Sends a request and waits for its answer, whose body is decoded as `*reply`, an allocated value, unless
 * `reply` is NULL. */
int playerc_request(playerc_client_t *client, uint16_t code, uint16_t index, uint8_t subtype,
                    const void *payload, void **reply);

#endif /* LIBPLAYERC_EXCHANGE_H */
