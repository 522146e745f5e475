#include "playhouse/c/image.h"

#include "fail.h"

/** Bytes of a pixel, 0 of formats that are not told apart by channels. */
static size_t pixel_bytes(const ph_image *image) {
  if (image->is_jpeg) return 0;
  switch (image->format) {
    case PH_CAMERA_FORMAT_MONO8:
      return 1;
    case PH_CAMERA_FORMAT_MONO16:
      return 2;
    case PH_CAMERA_FORMAT_RGB888:
      return 3;
    default:
      return 0;
  }
}

ph_status ph_image_pixel(const ph_image *image, uint32_t column, uint32_t row, uint16_t channels[3],
                         size_t *count, ph_error *error) {
  const size_t size = pixel_bytes(image);
  if (size == 0) {
    return ph_fail(error, PH_INVALID_VALUE, "pixels can be told of raw MONO8, MONO16 and RGB888 alone");
  }
  if (column >= image->width || row >= image->height) {
    return ph_fail(error, PH_INVALID_VALUE, "pixel %lu, %lu is outside the %lu x %lu picture",
                   (unsigned long)column, (unsigned long)row, (unsigned long)image->width,
                   (unsigned long)image->height);
  }
  const uint64_t first = ((uint64_t)row * image->width + column);
  if (first > (SIZE_MAX - size) / size || first * size + size > image->size) {
    return ph_fail(error, PH_INVALID_VALUE, "the picture has fewer bytes than pixels: %zu", image->size);
  }
  const uint8_t *at = image->data + first * size;
  *count = size == 3 ? 3 : 1;
  for (size_t i = 0; i < *count; ++i) channels[i] = at[i];
  if (size == 2) channels[0] = (uint16_t)(at[0] | at[1] << 8);
  return PH_OK;
}

ph_status ph_image_model_id(const ph_image *image, uint32_t column, uint32_t row, int32_t *id,
                            ph_error *error) {
  uint16_t channels[3];
  size_t count = 0;
  PH_TRY(ph_image_pixel(image, column, row, channels, &count, error));
  if (count != 3)
    return ph_fail(error, PH_INVALID_VALUE, "which model a pixel shows is told by RGB888 alone");
  *id = (int32_t)channels[0] << 16 | (int32_t)channels[1] << 8 | (int32_t)channels[2];
  --*id;  // 0 is none
  return PH_OK;
}
