#include <string.h>

#include "inside.h"

PLAYERC_PROXY(log, PLAYER_LOG_CODE, NULL, PLAYERC_NO_LISTS)

int playerc_log_set_write_state(playerc_log_t *device, int state) {
  const player_log_set_write_state_t wanted = {(uint8_t)state};
  return playerc_tell(&device->info, PLAYER_LOG_REQ_SET_WRITE_STATE, &wanted);
}

int playerc_log_set_read_state(playerc_log_t *device, int state) {
  const player_log_set_read_state_t wanted = {(uint8_t)state};
  return playerc_tell(&device->info, PLAYER_LOG_REQ_SET_READ_STATE, &wanted);
}

int playerc_log_set_read_rewind(playerc_log_t *device) {
  return playerc_tell(&device->info, PLAYER_LOG_REQ_SET_READ_REWIND, NULL);
}

int playerc_log_get_state(playerc_log_t *device) {
  player_log_get_state_t *told = NULL;
  const int result = playerc_ask(&device->info, PLAYER_LOG_REQ_GET_STATE, NULL, &told);
  if (result != 0) return result;
  device->type = told->type;
  device->state = told->state;
  player_log_get_state_t_free(told);
  return 0;
}

int playerc_log_set_filename(playerc_log_t *device, const char *fname) {
  player_log_set_filename_t wanted = {.filename_count = playerc_text_count(fname)};
  if (wanted.filename_count > sizeof wanted.filename)
    return playerc_fail("a file name has %zu letters at most", sizeof wanted.filename - 1);
  memcpy(wanted.filename, fname, wanted.filename_count);
  return playerc_tell(&device->info, PLAYER_LOG_REQ_SET_FILENAME, &wanted);
}
