/** Copies of decoded messages whose lists are allocated one by one, as old programs release them. */
#ifndef LIBPLAYERC_VALUES_H
#define LIBPLAYERC_VALUES_H

#include <stdbool.h>

#include "playhouse/c/wire.h"

/** Makes `to`, of the same type, a copy of `from`; false without memory, `to` is then all zeros. */
bool playerc_value_copy(const ph_struct_type *type, void *to, const void *from);
/** Releases the lists of a value, which then has none. */
void playerc_value_cleanup(const ph_struct_type *type, void *value);
/** An allocated copy; NULL without memory. */
void *playerc_value_clone(const ph_struct_type *type, const void *value);
/** Releases it; NULL has no effect. */
void playerc_value_free(const ph_struct_type *type, void *value);

/** The functions of a struct of player_interfaces.h. */
#define PLAYER_STRUCT_FUNCTIONS(T)                                                 \
  unsigned int T##_copy(T *to, const T *from) {                                    \
    return playerc_value_copy(&T##_type, to, from) ? (unsigned int)sizeof *to : 0; \
  }                                                                                \
  void T##_cleanup(const T *value) {                                               \
    playerc_value_cleanup(&T##_type, (void *)(uintptr_t)value);                    \
  }                                                                                \
  T *T##_clone(const T *value) {                                                   \
    return playerc_value_clone(&T##_type, value);                                  \
  }                                                                                \
  void T##_free(T *value) {                                                        \
    playerc_value_free(&T##_type, value);                                          \
  }

#endif /* LIBPLAYERC_VALUES_H */
