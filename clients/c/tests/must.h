/** For test programs: the first failure prints a line and exits. */
#ifndef PLAYHOUSE_C_TESTS_MUST_H
#define PLAYHOUSE_C_TESTS_MUST_H

#include <playhouse/c.h>
#include <stdio.h>
#include <stdlib.h>

/** The error of all calls in a test program. */
static ph_error error;

_Noreturn static inline void fail(const char *what) {
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static inline void must(ph_status status) {
  if (status != PH_OK) fail(error.text);
}

/** Ends unless a call returned a pointer, which is returned. */
static inline void *must_have(void *made) {
  if (made == NULL) fail(error.text);
  return made;
}

static inline void must_be(bool fact, const char *what) {
  if (fact) return;
  fprintf(stderr, "it is not true that %s\n", what);
  exit(1);
}

static inline void must_refuse(ph_status status, const char *what) {
  if (status == PH_REQUEST_REFUSED) return;
  fprintf(stderr, "the server should have refused %s\n", what);
  exit(1);
}

#endif /* PLAYHOUSE_C_TESTS_MUST_H */
