/** Texts of errors: numbers, names, and what a misspelt word may have meant. */
#ifndef PLAYHOUSE_C_TEXT_H
#define PLAYHOUSE_C_TEXT_H

#include <stddef.h>
#include <stdint.h>

enum { PH_NUMBER_BYTES = 32, PH_NAME_BYTES = 48, PH_NEAR_BYTES = 256 };

/** The number with the fewest digits that mean it: "0.1", "nan", "-inf". Returns `text`. */
const char *ph_number_text(double value, char text[PH_NUMBER_BYTES]);

/** For instance "position2d:0"; with a number if the interface has no known name. Returns `text`. */
const char *ph_device_text(uint16_t code, int index, char text[PH_NAME_BYTES]);

/** ` (did you mean "laser"?)` for the nearest of the known words, "" if none is near. Returns `text`. */
const char *ph_did_you_mean(const char *word, const char *const *known, size_t count,
                            char text[PH_NEAR_BYTES]);

#endif /* PLAYHOUSE_C_TEXT_H */
