/** The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]]. */
#ifndef PLAYHOUSE_C_EXAMPLES_PROGRAM_H
#define PLAYHOUSE_C_EXAMPLES_PROGRAM_H

#include <playhouse/c.h>

enum { MOST_MORE = 2 };

/** What the command line says. */
typedef struct program {
  int index;
  double end;          /**< when the time is up, s of the system's clock; INFINITY: never */
  int more[MOST_MORE]; /**< the numbers after SECONDS */
  int more_count;
} program;

typedef ph_status (*behaviour)(ph_client *client, const program *self, ph_error *error);

/** Connects, behaves, and returns the exit code: 0 when done, 1 on an error, 2 on wrong arguments, and 128
 * and its number on a signal (130 on Ctrl-C). */
int run(int argc, char **argv, behaviour behave, const char *usage);

/** Whether the time is up, or a signal asks the program to end. */
bool is_up(const program *self);

/** Waits for new data of a device. False when the time is up, then `status` is PH_OK, or on an error. */
bool next_data(ph_device *device, const program *self, ph_status *status, ph_error *error);

/** The nearest number from `low` to `high`. */
double clamp(double value, double low, double high);

#endif /* PLAYHOUSE_C_EXAMPLES_PROGRAM_H */
