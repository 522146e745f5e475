/** Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images. Generated from
 * interfaces/007_blobfinder.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_BLOBFINDER_H
#define PLAYHOUSE_C_GENERATED_BLOBFINDER_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_BLOBFINDER_CODE 7

/** A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t) */
typedef struct ph_blobfinder_blob {
  /** Channel that detected it. */
  uint32_t id;
  /** 0xRRGGBB, for display. */
  uint32_t color;
  /** Area in pixels (in px). */
  uint32_t area;
  /** Column of its centre (in px). */
  uint32_t x;
  /** Row of its centre (in px). */
  uint32_t y;
  /** First column (in px). */
  uint32_t left;
  /** Last column (in px). */
  uint32_t right;
  /** First row (in px). */
  uint32_t top;
  /** Last row (in px). */
  uint32_t bottom;
  /** Distance; 0 if unknown (in m). */
  float range;
} ph_blobfinder_blob;
PH_CODEC(ph_blobfinder_blob)

/** The blobs of one image. (player_blobfinder_data_t) */
typedef struct ph_blobfinder_data {
  /** Of the image (in px). */
  uint32_t width;
  /** Of the image (in px). */
  uint32_t height;
  const ph_blobfinder_blob *blobs;
  uint32_t blobs_count;
} ph_blobfinder_data;
PH_CODEC(ph_blobfinder_data)

/** The colors that a channel detects, as ranges of red, green and blue. (player_blobfinder_color_config_t) */
typedef struct ph_blobfinder_color_config {
  /** Channel; -1 means all (signed). */
  int32_t channel;
  uint32_t rmin;
  uint32_t rmax;
  uint32_t gmin;
  uint32_t gmax;
  uint32_t bmin;
  uint32_t bmax;
} ph_blobfinder_color_config;
PH_CODEC(ph_blobfinder_color_config)

/** Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t) */
typedef struct ph_blobfinder_imager_config {
  /** 0 to 255. */
  int32_t brightness;
  /** 0 to 255. */
  int32_t contrast;
  /** 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance. */
  int32_t colormode;
  /** 0 off, 1 on. */
  int32_t autogain;
} ph_blobfinder_imager_config;
PH_CODEC(ph_blobfinder_imager_config)

/** The messages, each under its name below. */
extern const ph_message_type ph_blobfinder_messages[4];
/** The blobs of one image. */
#define PH_BLOBFINDER_DATA_BLOBS (&ph_blobfinder_messages[0])
/** Sets the colors that a channel detects. */
#define PH_BLOBFINDER_REQ_SET_COLOR (&ph_blobfinder_messages[1])
/** Sets brightness, contrast and other settings of the camera. */
#define PH_BLOBFINDER_REQ_SET_IMAGER_PARAMS (&ph_blobfinder_messages[2])
/** Requests the colors that a channel detects. */
#define PH_BLOBFINDER_REQ_GET_COLOR (&ph_blobfinder_messages[3])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_BLOBFINDER_H */
