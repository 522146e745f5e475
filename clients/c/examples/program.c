#define _POSIX_C_SOURCE 200809L

#include "program.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double kPatience = 5.0;  // s without data, after which they do not come
static const double kGlance = 0.1;    // s between two looks at whether a signal came

static volatile sig_atomic_t interrupted = 0;  // the signal that asks the program to end; 0: none

static void remember(int number) {
  interrupted = number;
}

/** Ends by Ctrl-C, by SIGTERM, or because the terminal was closed (SIGHUP), after stopping the robot. What is
 * ignored, as by nohup, stays ignored. */
static void catch_signals(void) {
  static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction before, action;
  memset(&action, 0, sizeof action);
  action.sa_handler = remember;
  sigemptyset(&action.sa_mask);
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
    const bool ignored = sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler == SIG_IGN;
    if (!ignored) sigaction(numbers[i], &action, NULL);
  }
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

bool is_up(const program *self) {
  return interrupted != 0 || now() >= self->end;
}

bool next_data(ph_device *device, const program *self, ph_status *status, ph_error *error) {
  const double late = now() + kPatience;
  while (!is_up(self)) {
    *status = ph_device_next_data(device, kGlance, error);
    if (*status == PH_OK) return true;
    if (*status != PH_REQUEST_TIMEOUT || now() >= late) return false;
  }
  *status = PH_OK;
  return false;
}

double clamp(double value, double low, double high) {
  return fmax(low, fmin(high, value));
}

/** A number from 0 on; false if the word is not one. */
static bool parse_number(const char *word, double *number) {
  char *end = NULL;
  *number = strtod(word, &end);
  return end != word && *end == '\0' && isfinite(*number) && *number >= 0.0;
}

/** A whole number up to 65535. */
static bool parse_whole(const char *word, int *whole) {
  double number = 0.0;
  if (!parse_number(word, &number) || number > 65535.0 || number != floor(number)) return false;
  *whole = (int)number;
  return true;
}

static bool parse(int argc, char **argv, program *self) {
  double seconds = 0.0;
  int ignored = 0;
  if (argc > 2 && !parse_whole(argv[2], &self->index)) return false;
  if (argc > 3 && !parse_number(argv[3], &seconds)) return false;
  for (int i = 4; i < argc; ++i) {
    const bool fits = self->more_count < MOST_MORE;
    if (!parse_whole(argv[i], fits ? &self->more[self->more_count++] : &ignored)) return false;
  }
  self->end = seconds > 0.0 ? now() + seconds : (double)INFINITY;
  return true;
}

int run(int argc, char **argv, behaviour behave, const char *usage) {
  program self = {.index = 0};
  ph_error error;
  if (!parse(argc, argv, &self)) {
    fprintf(stderr, "usage: %s\n", usage);
    return 2;
  }
  ph_client *client = ph_connect(argc > 1 ? argv[1] : "127.0.0.1:6665", NULL, &error);
  if (client == NULL) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  catch_signals();
  const ph_status status = behave(client, &self, &error);
  ph_client_free(client);  // stops the robot
  if (interrupted != 0) return 128 + interrupted;
  if (status == PH_OK) return 0;
  fprintf(stderr, "%s\n", error.text);
  return 1;
}
