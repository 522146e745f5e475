/** Interface camera, code 40. Images. Generated from interfaces/040_camera.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_CAMERA_H
#define PLAYHOUSE_C_GENERATED_CAMERA_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_CAMERA_CODE 40

/** Values of Data.format. */
enum {
  PH_CAMERA_FORMAT_MONO8 = 1,
  PH_CAMERA_FORMAT_MONO16 = 2,
  PH_CAMERA_FORMAT_RGB565 = 4,
  PH_CAMERA_FORMAT_RGB888 = 5,
};

/** Values of Data.compression. */
enum {
  PH_CAMERA_COMPRESS_RAW = 0,
  PH_CAMERA_COMPRESS_JPEG = 1,
};

/** One image. (player_camera_data_t) */
typedef struct ph_camera_data {
  /** In px. */
  uint32_t width;
  /** In px. */
  uint32_t height;
  /** Per pixel (in bit). */
  uint32_t bpp;
  /** Order and size of the colors. */
  uint32_t format;
  /** Divides the values of a disparity image; 1 otherwise. */
  uint32_t fdiv;
  /** Raw or JPEG. */
  uint32_t compression;
  /** Rows from the top, pixels from the left, or a JPEG file. */
  const uint8_t *image;
  uint32_t image_count;
} ph_camera_data;
PH_CODEC(ph_camera_data)

/** An input of the camera. (player_camera_source_t) */
typedef struct ph_camera_source {
  /** Video norm, such as PAL or NTSC, NUL-terminated. */
  const char *norm;
  uint32_t norm_count;
  /** Index of the input. */
  int32_t source;
} ph_camera_source;
PH_CODEC(ph_camera_source)

/** The messages, each under its name below. */
extern const ph_message_type ph_camera_messages[4];
/** One image. */
#define PH_CAMERA_DATA_STATE (&ph_camera_messages[0])
/** Requests the camera's input and norm. */
#define PH_CAMERA_REQ_GET_SOURCE (&ph_camera_messages[1])
/** Selects the input and norm. */
#define PH_CAMERA_REQ_SET_SOURCE (&ph_camera_messages[2])
/** Requests one image now. */
#define PH_CAMERA_REQ_GET_IMAGE (&ph_camera_messages[3])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_CAMERA_H */
