#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "playhouse/c/wire.h"

static const double kNear = 0.6;  // likeness from which a word is near
enum { LONGEST_WORD = 100 };      // compared; longer words are not near

const char *ph_number_text(double value, char text[PH_NUMBER_BYTES]) {
  if (isnan(value)) return strcpy(text, "nan");
  for (int digits = 1; digits <= 17; ++digits) {
    snprintf(text, PH_NUMBER_BYTES, "%.*g", digits, value);
    if (isinf(value) || strtod(text, NULL) == value) break;
  }
  return text;
}

const char *ph_device_text(uint16_t code, int index, char text[PH_NAME_BYTES]) {
  const char *name = ph_interface_name(code);
  if (name != NULL) {
    snprintf(text, PH_NAME_BYTES, "%.30s:%d", name, index);
  } else {
    snprintf(text, PH_NAME_BYTES, "%u:%d", (unsigned)code, index);
  }
  return text;
}

/** The characters that two words have in common: of the longest common part, and of what is left and right of
 * it. */
static size_t common_characters(const char *a, size_t a_length, const char *b, size_t b_length) {
  size_t best = 0, at_a = 0, at_b = 0;
  for (size_t i = 0; i < a_length; ++i) {
    for (size_t j = 0; j < b_length; ++j) {
      size_t length = 0;
      while (i + length < a_length && j + length < b_length && a[i + length] == b[j + length]) ++length;
      if (length > best) {
        best = length;
        at_a = i;
        at_b = j;
      }
    }
  }
  if (best == 0) return 0;
  return best + common_characters(a, at_a, b, at_b) +
         common_characters(a + at_a + best, a_length - at_a - best, b + at_b + best, b_length - at_b - best);
}

const char *ph_did_you_mean(const char *word, const char *const *known, size_t count,
                            char text[PH_NEAR_BYTES]) {
  const char *nearest = NULL;
  double best = kNear;
  const size_t length = strlen(word);
  for (size_t i = 0; i < count; ++i) {
    const size_t its_length = strlen(known[i]);
    if (length > LONGEST_WORD || its_length > LONGEST_WORD || length + its_length == 0) continue;
    const double alike =
        2.0 * (double)common_characters(known[i], its_length, word, length) / (double)(length + its_length);
    if (alike > best || (alike == best && (nearest == NULL || strcmp(known[i], nearest) > 0))) {
      best = alike;
      nearest = known[i];
    }
  }
  text[0] = '\0';
  if (nearest != NULL) snprintf(text, PH_NEAR_BYTES, " (did you mean \"%s\"?)", nearest);
  return text;
}
