/** Making decoded messages. */
#ifndef PLAYHOUSE_C_SRC_VALUE_H
#define PLAYHOUSE_C_SRC_VALUE_H

#include "playhouse/c/value.h"

/** Decodes a body as the payload of a message. The caller owns the value. */
ph_status ph_value_decode(const ph_message_type *message, const void *body, size_t size, double timestamp,
                          ph_value **value, ph_error *error);

#endif /* PLAYHOUSE_C_SRC_VALUE_H */
