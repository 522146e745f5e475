/** Generated from interfaces/063_vectormap.toml by codegen; do not edit. */
#include "playhouse/c/generated/vectormap.h"

#include <stddef.h>

static const ph_field ph_vectormap_feature_data_fields[3] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_vectormap_feature_data, name), offsetof(ph_vectormap_feature_data, name_count), NULL},
    {"wkb", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_vectormap_feature_data, wkb), offsetof(ph_vectormap_feature_data, wkb_count), NULL},
    {"attrib", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_vectormap_feature_data, attrib), offsetof(ph_vectormap_feature_data, attrib_count), NULL},
};
const ph_struct_type ph_vectormap_feature_data_type = {"vectormap.FeatureData", ph_vectormap_feature_data_fields, 3, 24, sizeof(ph_vectormap_feature_data)};

static const ph_field ph_vectormap_layer_info_fields[2] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_vectormap_layer_info, name), offsetof(ph_vectormap_layer_info, name_count), NULL},
    {"extent", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_vectormap_layer_info, extent), 0, &ph_common_extent2d_type},
};
const ph_struct_type ph_vectormap_layer_info_type = {"vectormap.LayerInfo", ph_vectormap_layer_info_fields, 2, 40, sizeof(ph_vectormap_layer_info)};

static const ph_field ph_vectormap_layer_data_fields[2] = {
    {"name", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_vectormap_layer_data, name), offsetof(ph_vectormap_layer_data, name_count), NULL},
    {"features", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1398099, offsetof(ph_vectormap_layer_data, features), offsetof(ph_vectormap_layer_data, features_count), &ph_vectormap_feature_data_type},
};
const ph_struct_type ph_vectormap_layer_data_type = {"vectormap.LayerData", ph_vectormap_layer_data_fields, 2, 16, sizeof(ph_vectormap_layer_data)};

static const ph_field ph_vectormap_info_fields[3] = {
    {"srid", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_vectormap_info, srid), 0, NULL},
    {"layers", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 838859, offsetof(ph_vectormap_info, layers), offsetof(ph_vectormap_info, layers_count), &ph_vectormap_layer_info_type},
    {"extent", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_vectormap_info, extent), 0, &ph_common_extent2d_type},
};
const ph_struct_type ph_vectormap_info_type = {"vectormap.Info", ph_vectormap_info_fields, 3, 44, sizeof(ph_vectormap_info)};

const ph_message_type ph_vectormap_messages[3] = {
    {63, PH_KIND_REQ, 1, "vectormap.req.get_map_info", &ph_vectormap_info_type},
    {63, PH_KIND_REQ, 3, "vectormap.req.get_layer_data", &ph_vectormap_layer_data_type},
    {63, PH_KIND_REQ, 4, "vectormap.req.write_layer", &ph_vectormap_layer_data_type},
};
