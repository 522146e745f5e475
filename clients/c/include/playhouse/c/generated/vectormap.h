/** Interface vectormap, code 63. Maps of points, lines and areas in layers. Generated from
 * interfaces/063_vectormap.toml by codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_VECTORMAP_H
#define PLAYHOUSE_C_GENERATED_VECTORMAP_H

#include "playhouse/c/generated/common.h"
#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_VECTORMAP_CODE 63

/** One feature. (player_vectormap_feature_data_t) */
typedef struct ph_vectormap_feature_data {
  const char *name;
  uint32_t name_count;
  /** Its shape, as OGC well-known binary, in map coordinates. */
  const uint8_t *wkb;
  uint32_t wkb_count;
  /** Free text. */
  const char *attrib;
  uint32_t attrib_count;
} ph_vectormap_feature_data;
PH_CODEC(ph_vectormap_feature_data)

/** Description of a layer. (player_vectormap_layer_info_t) */
typedef struct ph_vectormap_layer_info {
  const char *name;
  uint32_t name_count;
  /** Bounding box of all its features (in m, frame p_MP). */
  ph_common_extent2d extent;
} ph_vectormap_layer_info;
PH_CODEC(ph_vectormap_layer_info)

/** A layer's features. (player_vectormap_layer_data_t) */
typedef struct ph_vectormap_layer_data {
  const char *name;
  uint32_t name_count;
  const ph_vectormap_feature_data *features;
  uint32_t features_count;
} ph_vectormap_layer_data;
PH_CODEC(ph_vectormap_layer_data)

/** List of layers. (player_vectormap_info_t) */
typedef struct ph_vectormap_info {
  /** Id of the spatial reference system; 0: none. */
  uint32_t srid;
  const ph_vectormap_layer_info *layers;
  uint32_t layers_count;
  /** Bounding box of all layers (in m, frame p_MP). */
  ph_common_extent2d extent;
} ph_vectormap_info;
PH_CODEC(ph_vectormap_info)

/** The messages, each under its name below. */
extern const ph_message_type ph_vectormap_messages[3];
/** Requests the list of layers. */
#define PH_VECTORMAP_REQ_GET_MAP_INFO (&ph_vectormap_messages[0])
/** Requests the features of a layer. */
#define PH_VECTORMAP_REQ_GET_LAYER_DATA (&ph_vectormap_messages[1])
/** Replaces the features of a layer. */
#define PH_VECTORMAP_REQ_WRITE_LAYER (&ph_vectormap_messages[2])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_VECTORMAP_H */
