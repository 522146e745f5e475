#include "fail.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void one_line(char *text) {
  for (; *text != '\0'; ++text) {
    if (*text == '\n' || *text == '\r') *text = ' ';
  }
}

ph_status ph_fail(ph_error *error, ph_status status, const char *format, ...) {
  if (error == NULL) return status;
  char text[PH_ERROR_BYTES];
  va_list arguments;
  va_start(arguments, format);
  const int length = vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (length >= (int)sizeof text) memcpy(text + sizeof text - 4, "...", 4);
  one_line(text);
  error->status = status;
  memcpy(error->text, text, sizeof text);
  return status;
}

ph_status ph_fail_no_memory(ph_error *error) {
  return ph_fail(error, PH_NO_MEMORY, "the system has no memory left");
}

ph_status ph_fail_as(ph_error *error, const ph_error *why) {
  return ph_fail(error, why->status, "%s", why->text);
}
