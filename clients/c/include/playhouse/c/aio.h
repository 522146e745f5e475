#ifndef PLAYHOUSE_C_AIO_H
#define PLAYHOUSE_C_AIO_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands outputs. */
PH_PROXY(aio)

/** One per input, in V. */
ph_status ph_aio_voltages(ph_aio *aio, const float **voltages, size_t *count, ph_error *error);
/** Sets one output, in V. */
ph_status ph_aio_set(ph_aio *aio, uint32_t output, double voltage, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_AIO_H */
