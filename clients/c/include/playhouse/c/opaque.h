#ifndef PLAYHOUSE_C_OPAQUE_H
#define PLAYHOUSE_C_OPAQUE_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Byte messages: those between robots for a simulated radio, driver-specific for other drivers. */
PH_PROXY(opaque)

/** Sends to the driver; a radio broadcasts it to all radios in range. */
ph_status ph_opaque_send(ph_opaque *radio, const void *bytes, size_t size, ph_error *error);
/** For a radio: sends to the radio with this network address, "" to broadcast. Returns when the message is
 * queued. PH_REQUEST_REFUSED for an unknown address, a message that is too long, or a full queue. */
ph_status ph_opaque_send_to(ph_opaque *radio, const char *address, const void *bytes, size_t size,
                            ph_error *error);
/** The oldest message of the reads so far that was not taken yet; false if there is none. A device keeps the
 * last 1024. The bytes are valid until the next call for this device. */
bool ph_opaque_take_message(ph_opaque *radio, const uint8_t **bytes, size_t *size);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_OPAQUE_H */
