#include <stdarg.h>
#include <string.h>

#include "inside.h"

static _Thread_local char text[PH_ERROR_BYTES];

const char *playerc_error_str(void) {
  return text;
}

int playerc_fail(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return -1;
}

int playerc_fail_as(const ph_error *error) {
  memcpy(text, error->text, sizeof text);
  return error->status == PH_REQUEST_REFUSED ? -2 : -1;
}

int playerc_fail_no_memory(void) {
  return playerc_fail("there is no memory left");
}
