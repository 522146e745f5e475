/** Decoded messages. */
#ifndef PLAYHOUSE_C_VALUE_H
#define PLAYHOUSE_C_VALUE_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A decoded message. `data` is of the type of message->payload, for instance a ph_position2d_data; the lists
 * in it live as long as the value. `timestamp` is the server's time in s. */
typedef struct ph_value {
  const ph_message_type *message;
  const void *data;
  double timestamp;
} ph_value;

/** Another owner of a value, for as long as ph_value_free() is not called; the value itself is returned. */
ph_value *ph_value_keep(const ph_value *value);
/** Releases an owned value; NULL has no effect. */
void ph_value_free(ph_value *value);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_VALUE_H */
