/** How functions of this library fail. */
#ifndef PLAYHOUSE_C_FAIL_H
#define PLAYHOUSE_C_FAIL_H

#include "playhouse/c/error.h"

#if defined(__GNUC__)
#define PH_FORMAT(TEXT, FIRST) __attribute__((format(printf, TEXT, FIRST)))
#else
#define PH_FORMAT(TEXT, FIRST)
#endif

/** Sets the error, unless it is NULL, and returns its status. The text may have parts of the error's own old
 * text. */
ph_status ph_fail(ph_error *error, ph_status status, const char *format, ...) PH_FORMAT(3, 4);
ph_status ph_fail_no_memory(ph_error *error);

/** Hands over an error that a function kept to itself first; returns its status. */
ph_status ph_fail_as(ph_error *error, const ph_error *why);

/** Returns the status of an expression from the function if it is not PH_OK. */
#define PH_TRY(EXPRESSION)                \
  do {                                    \
    const ph_status tried = (EXPRESSION); \
    if (tried != PH_OK) return tried;     \
  } while (0)

#endif /* PLAYHOUSE_C_FAIL_H */
