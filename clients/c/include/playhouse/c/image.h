#ifndef PLAYHOUSE_C_IMAGE_H
#define PLAYHOUSE_C_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "playhouse/c/error.h"
#include "playhouse/c/generated/camera.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An image: rows from the top, pixels from the left. `format` is one of PH_CAMERA_FORMAT_MONO8,
 * FORMAT_MONO16 (of Playhouse: depth in mm, little-endian, 0 if nothing is in range), FORMAT_RGB565 and
 * FORMAT_RGB888. `data` is the pixels, or a JPEG file if `is_jpeg`. `time` is the server's, in s. */
typedef struct ph_image {
  uint32_t width, height;
  uint32_t format;
  bool is_jpeg;
  const uint8_t *data;
  size_t size;
  double time;
} ph_image;

/** The channels of a pixel and their number: red, green and blue, or brightness, or depth in mm.
 * PH_INVALID_VALUE for a JPEG file, for other formats, outside the image, and if the data are shorter than
 * the image. */
ph_status ph_image_pixel(const ph_image *image, uint32_t column, uint32_t row, uint16_t channels[3],
                         size_t *count, ph_error *error);
/** For images of a camera with `image "segmentation"`: the id of the model at the pixel, as in
 * ph_client_models(), up to 24 bits; -1 without a model. PH_INVALID_VALUE as ph_image_pixel(), and for other
 * formats. */
ph_status ph_image_model_id(const ph_image *image, uint32_t column, uint32_t row, int32_t *id,
                            ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_IMAGE_H */
