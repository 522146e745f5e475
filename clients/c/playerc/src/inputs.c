/** Inputs and outputs: aio, dio, joystick, blinkenlight. */
#include <string.h>

#include "inside.h"

// --- aio

static void put_aio(void *proxy, char *header, char *body) {
  playerc_aio_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_AIO_DATA_STATE) return;
  const player_aio_data_t *data = message;
  const uint8_t count = data->voltages_count < UINT8_MAX ? (uint8_t)data->voltages_count : UINT8_MAX;
  if (playerc_keep(&device->voltages, data->voltages, count, sizeof *data->voltages))
    device->voltages_count = count;
}

static void release_aio(playerc_aio_t *device) {
  free(device->voltages);
}

PLAYERC_PROXY(aio, PLAYER_AIO_CODE, put_aio, release_aio)

int playerc_aio_set_output(playerc_aio_t *device, uint8_t id, float volt) {
  const player_aio_cmd_t command = {id, volt};
  return playerc_command(&device->info, PLAYER_AIO_CMD_STATE, &command);
}

float playerc_aio_get_data(playerc_aio_t *device, uint32_t index) {
  return index < device->voltages_count ? device->voltages[index] : 0.0F;
}

// --- dio

static void put_dio(void *proxy, char *header, char *body) {
  playerc_dio_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_DIO_DATA_VALUES) return;
  const player_dio_data_t *data = message;
  device->count = (uint8_t)data->count;
  device->digin = data->bits;
}

PLAYERC_PROXY(dio, PLAYER_DIO_CODE, put_dio, PLAYERC_NO_LISTS)

int playerc_dio_set_output(playerc_dio_t *device, uint8_t output_count, uint32_t digout) {
  const player_dio_cmd_t command = {output_count, digout};
  return playerc_command(&device->info, PLAYER_DIO_CMD_VALUES, &command);
}

// --- joystick

static void put_joystick(void *proxy, char *header, char *body) {
  playerc_joystick_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_JOYSTICK_DATA_STATE) return;
  const player_joystick_data_t *data = message;
  device->axes_count = (int32_t)data->axes_count;
  memcpy(device->pos, data->pos, sizeof device->pos);
  device->buttons = data->buttons;
}

PLAYERC_PROXY(joystick, PLAYER_JOYSTICK_CODE, put_joystick, PLAYERC_NO_LISTS)

// --- blinkenlight

static void put_light(void *proxy, char *header, char *body) {
  playerc_blinkenlight_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_BLINKENLIGHT_DATA_STATE) return;
  const player_blinkenlight_data_t *data = message;
  device->enabled = data->enable;
  device->duty_cycle = (double)data->dutycycle;
  device->period = (double)data->period;
  device->red = data->color.red;
  device->green = data->color.green;
  device->blue = data->color.blue;
}

PLAYERC_PROXY(blinkenlight, PLAYER_BLINKENLIGHT_CODE, put_light, PLAYERC_NO_LISTS)

int playerc_blinkenlight_enable(playerc_blinkenlight_t *device, uint32_t enable) {
  const player_blinkenlight_cmd_power_t command = {.enable = (uint8_t)(enable != 0)};
  return playerc_command(&device->info, PLAYER_BLINKENLIGHT_CMD_POWER, &command);
}

int playerc_blinkenlight_color(playerc_blinkenlight_t *device, uint32_t id, uint8_t red, uint8_t green,
                               uint8_t blue) {
  const player_blinkenlight_cmd_color_t command = {(uint16_t)id, {.red = red, .green = green, .blue = blue}};
  return playerc_command(&device->info, PLAYER_BLINKENLIGHT_CMD_COLOR, &command);
}

int playerc_blinkenlight_blink(playerc_blinkenlight_t *device, uint32_t id, float period, float duty_cycle) {
  const player_blinkenlight_cmd_flash_t command = {(uint16_t)id, period, duty_cycle};
  return playerc_command(&device->info, PLAYER_BLINKENLIGHT_CMD_FLASH, &command);
}
