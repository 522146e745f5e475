/** Generated from interfaces/042_map.toml by codegen; do not edit. */
#include "playhouse/c/generated/map.h"

#include <stddef.h>

static const ph_field ph_map_info_fields[4] = {
    {"scale", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_info, scale), 0, NULL},
    {"width", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_info, width), 0, NULL},
    {"height", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_info, height), 0, NULL},
    {"origin", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_info, origin), 0, &ph_common_pose2d_type},
};
const ph_struct_type ph_map_info_type = {"map.Info", ph_map_info_fields, 4, 36, sizeof(ph_map_info)};

static const ph_field ph_map_data_fields[6] = {
    {"col", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data, col), 0, NULL},
    {"row", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data, row), 0, NULL},
    {"width", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data, width), 0, NULL},
    {"height", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data, height), 0, NULL},
    {"data_range", PH_TYPE_INT8, PH_SHAPE_ONE, 6, 0, 1, offsetof(ph_map_data, data_range), 0, NULL},
    {"data", PH_TYPE_INT8, PH_SHAPE_DYNAMIC, 0, 1, 33554392, offsetof(ph_map_data, data), offsetof(ph_map_data, data_count), NULL},
};
const ph_struct_type ph_map_data_type = {"map.Data", ph_map_data_fields, 6, 28, sizeof(ph_map_data)};

static const ph_field ph_map_data_vector_fields[5] = {
    {"minx", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data_vector, minx), 0, NULL},
    {"maxx", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data_vector, maxx), 0, NULL},
    {"miny", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data_vector, miny), 0, NULL},
    {"maxy", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_map_data_vector, maxy), 0, NULL},
    {"segments", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1048574, offsetof(ph_map_data_vector, segments), offsetof(ph_map_data_vector, segments_count), &ph_common_segment_type},
};
const ph_struct_type ph_map_data_vector_type = {"map.DataVector", ph_map_data_vector_fields, 5, 24, sizeof(ph_map_data_vector)};

const ph_message_type ph_map_messages[4] = {
    {42, PH_KIND_DATA, 1, "map.data.info", &ph_map_info_type},
    {42, PH_KIND_REQ, 1, "map.req.get_info", &ph_map_info_type},
    {42, PH_KIND_REQ, 2, "map.req.get_data", &ph_map_data_type},
    {42, PH_KIND_REQ, 3, "map.req.get_vector", &ph_map_data_vector_type},
};
