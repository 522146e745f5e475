/** Images: camera, stereo. */
#include <string.h>

#include "inside.h"

static void put_image(playerc_camera_t *device, const player_camera_data_t *data) {
  if (!playerc_keep(&device->image, data->image, data->image_count, 1)) return;
  device->width = (int)data->width;
  device->height = (int)data->height;
  device->bpp = (int)data->bpp;
  device->format = (int)data->format;
  device->fdiv = (int)data->fdiv;
  device->compression = (int)data->compression;
  device->image_count = (int)data->image_count;
}

static void put_camera(void *proxy, char *header, char *body) {
  const void *message = body;
  if (playerc_subtype(header) == PLAYER_CAMERA_DATA_STATE) put_image(proxy, message);
}

static void release_camera(playerc_camera_t *device) {
  free(device->image);
}

PLAYERC_PROXY(camera, PLAYER_CAMERA_CODE, put_camera, release_camera)

int playerc_camera_set_source(playerc_camera_t *device, int source, const char *norm) {
  const player_camera_source_t wanted = {playerc_text_count(norm), playerc_text(norm), source};
  return playerc_tell(&device->info, PLAYER_CAMERA_REQ_SET_SOURCE, &wanted);
}

int playerc_camera_get_source(playerc_camera_t *device) {
  player_camera_source_t *told = NULL;
  const int result = playerc_ask(&device->info, PLAYER_CAMERA_REQ_GET_SOURCE, NULL, &told);
  if (result != 0) return result;
  snprintf(device->norm, sizeof device->norm, "%s", told->norm != NULL ? told->norm : "");
  device->source = told->source;
  player_camera_source_t_free(told);
  return 0;
}

int playerc_camera_get_image(playerc_camera_t *device) {
  player_camera_data_t *image = NULL;
  const int result = playerc_ask(&device->info, PLAYER_CAMERA_REQ_GET_IMAGE, NULL, &image);
  if (result == 0) put_image(device, image);
  player_camera_data_t_free(image);
  return result;
}

void playerc_camera_copy_image(playerc_camera_t *device, void *dst, size_t dst_size) {
  const size_t count = (size_t)device->image_count < dst_size ? (size_t)device->image_count : dst_size;
  if (count > 0) memcpy(dst, device->image, count);
}

unsigned playerc_camera_get_pixel_component(playerc_camera_t *device, unsigned int x, unsigned int y,
                                            int component) {
  const size_t parts = device->bpp == 8 ? 1 : device->bpp == 24 ? 3 : 0;
  if (device->compression != PLAYER_CAMERA_COMPRESS_RAW || x >= (unsigned)device->width ||
      y >= (unsigned)device->height || component < 0 || (size_t)component >= parts) {
    return 0;
  }
  const size_t at = ((size_t)y * (size_t)device->width + x) * parts + (size_t)component;
  return at < (size_t)device->image_count ? device->image[at] : 0;
}

static void write_image(playerc_camera_t *device, FILE *file) {
  fprintf(file, "P6\n%d %d\n255\n", device->width, device->height);
  for (unsigned y = 0; y < (unsigned)device->height; ++y) {
    for (unsigned x = 0; x < (unsigned)device->width; ++x) {
      for (int part = 0; part < 3; ++part)
        fputc((int)playerc_camera_get_pixel_component(device, x, y, device->bpp == 8 ? 0 : part), file);
    }
  }
}

void playerc_camera_save(playerc_camera_t *device, const char *filename) {
  FILE *file = fopen(filename, "wb");
  if (file == NULL) {
    playerc_fail("%s cannot be written", filename);
    return;
  }
  write_image(device, file);
  if (fclose(file) != 0) playerc_fail("%s cannot be written", filename);
}

// --- stereo

static void put_stereo(void *proxy, char *header, char *body) {
  playerc_stereo_t *device = proxy;
  const void *message = body;
  if (playerc_subtype(header) != PLAYER_STEREO_DATA_STATE) return;
  const player_stereo_data_t *data = message;
  put_image(&device->left_channel, &data->left_channel);
  put_image(&device->right_channel, &data->right_channel);
  put_image(&device->disparity, &data->disparity);
  if (playerc_keep(&device->points, data->points, data->points_count, sizeof *data->points))
    device->points_count = data->points_count;
}

static void release_stereo(playerc_stereo_t *device) {
  release_camera(&device->left_channel);
  release_camera(&device->right_channel);
  release_camera(&device->disparity);
  free(device->points);
}

PLAYERC_PROXY(stereo, PLAYER_STEREO_CODE, put_stereo, release_stereo)
