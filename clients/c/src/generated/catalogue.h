/** The interfaces and their messages, by code. Generated from interfaces/ by codegen; do not edit. */
#ifndef PLAYHOUSE_C_CATALOGUE_H
#define PLAYHOUSE_C_CATALOGUE_H

#include "playhouse/c/wire.h"

typedef struct ph_interface {
  uint16_t code;
  uint16_t message_count;
  const char *name;
  const ph_message_type *messages;
} ph_interface;

/** The shared messages first, with code 0. */
enum { PH_INTERFACE_COUNT = 44 };
extern const ph_interface ph_interfaces[PH_INTERFACE_COUNT];

#endif  /* PLAYHOUSE_C_CATALOGUE_H */
