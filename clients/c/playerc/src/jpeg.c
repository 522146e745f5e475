/** Compressed images, by libjpeg-turbo if this library was built with it. */
#include "inside.h"

#ifdef PLAYERC_TURBOJPEG
#include <turbojpeg.h>

/** A small image may have thousands of progressive scans, each of which takes as long as a whole one. */
#ifdef TJFLAG_LIMITSCANS
#define SCAN_LIMIT TJFLAG_LIMITSCANS
#else
#define SCAN_LIMIT 0
#endif

enum { MOST_BYTES = 32 << 20 /**< of an image: what a message could have carried without compression */ };

/** The image is then uncompressed, and `bytes` become the proxy's. */
static void put_pixels(playerc_camera_t *device, uint8_t *bytes, int width, int height) {
  free(device->image);
  device->image = bytes;
  device->image_count = width * height * 3;
  device->width = width;
  device->height = height;
  device->bpp = 24;
  device->format = PLAYER_CAMERA_FORMAT_RGB888;
  device->compression = PLAYER_CAMERA_COMPRESS_RAW;
}

/** An image that is damaged or cut off is shown as far as it goes. */
static bool read_pixels(tjhandle reader, const playerc_camera_t *device, uint8_t *to, int width, int height) {
  const int failed = tjDecompress2(reader, device->image, (unsigned long)device->image_count, to, width, 0,
                                   height, TJPF_RGB, TJFLAG_ACCURATEDCT | SCAN_LIMIT);
  return failed == 0 || tjGetErrorCode(reader) == TJERR_WARNING;
}

static void decompress(tjhandle reader, playerc_camera_t *device) {
  int width = 0, height = 0, subsampling = 0, colors = 0;
  if (tjDecompressHeader3(reader, device->image, (unsigned long)device->image_count, &width, &height,
                          &subsampling, &colors) != 0) {
    playerc_fail("the image is no JPEG: %s", tjGetErrorStr2(reader));
    return;
  }
  if (width <= 0 || height <= 0 || (size_t)width > MOST_BYTES / 3 / (size_t)height) {
    playerc_fail("an image of %d x %d pixels is too large", width, height);
    return;
  }
  uint8_t *bytes = calloc((size_t)width * (size_t)height, 3);
  if (bytes == NULL) {
    playerc_fail_no_memory();
    return;
  }
  if (read_pixels(reader, device, bytes, width, height)) {
    put_pixels(device, bytes, width, height);
  } else {
    playerc_fail("the image is no JPEG that can be read: %s", tjGetErrorStr2(reader));
    free(bytes);
  }
}

void playerc_camera_decompress(playerc_camera_t *device) {
  if (device->compression == PLAYER_CAMERA_COMPRESS_RAW) return;
  if (device->compression != PLAYER_CAMERA_COMPRESS_JPEG || device->image_count <= 0) {
    playerc_fail("the image has no compression that is known: %d", device->compression);
    return;
  }
  tjhandle reader = tjInitDecompress();
  if (reader == NULL) {
    playerc_fail_no_memory();
    return;
  }
  decompress(reader, device);
  tjDestroy(reader);
}

#else

void playerc_camera_decompress(playerc_camera_t *device) {
  if (device->compression == PLAYER_CAMERA_COMPRESS_RAW) return;
  playerc_fail("this library was built without libjpeg-turbo");
}

#endif
