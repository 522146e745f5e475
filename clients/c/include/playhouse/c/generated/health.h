/** Interface health, code 59. Load of a computer. Generated from interfaces/059_health.toml by codegen; do
 * not edit. */
#ifndef PLAYHOUSE_C_GENERATED_HEALTH_H
#define PLAYHOUSE_C_GENERATED_HEALTH_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_HEALTH_CODE 59

/** Processor load. (player_health_cpu_t) */
typedef struct ph_health_cpu {
  /** Idle time (in %). */
  float idle;
  /** Time in the operating system (in %). */
  float system;
  /** Time in programs (in %). */
  float user;
} ph_health_cpu;
PH_CODEC(ph_health_cpu)

/** Usage of a type of memory. (player_health_memory_t) */
typedef struct ph_health_memory {
  /** In byte. */
  int64_t total;
  /** In byte. */
  int64_t used;
  /** In byte. */
  int64_t free;
} ph_health_memory;
PH_CODEC(ph_health_memory)

/** Load of processor and memory. (player_health_data_t) */
typedef struct ph_health_data {
  ph_health_cpu cpu_usage;
  ph_health_memory mem;
  ph_health_memory swap;
} ph_health_data;
PH_CODEC(ph_health_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_health_messages[1];
/** Load of processor and memory. */
#define PH_HEALTH_DATA_STATE (&ph_health_messages[0])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_HEALTH_H */
