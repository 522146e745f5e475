/** Generated from interfaces/061_pointcloud3d.toml by codegen; do not edit. */
#include "playhouse/c/generated/pointcloud3d.h"

#include <stddef.h>

static const ph_field ph_pointcloud3d_element_fields[2] = {
    {"point", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_pointcloud3d_element, point), 0, &ph_common_point3d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_pointcloud3d_element, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_pointcloud3d_element_type = {"pointcloud3d.Element", ph_pointcloud3d_element_fields, 2, 40, sizeof(ph_pointcloud3d_element)};

static const ph_field ph_pointcloud3d_data_fields[1] = {
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 838859, offsetof(ph_pointcloud3d_data, points), offsetof(ph_pointcloud3d_data, points_count), &ph_pointcloud3d_element_type},
};
const ph_struct_type ph_pointcloud3d_data_type = {"pointcloud3d.Data", ph_pointcloud3d_data_fields, 1, 8, sizeof(ph_pointcloud3d_data)};

const ph_message_type ph_pointcloud3d_messages[1] = {
    {61, PH_KIND_DATA, 1, "pointcloud3d.data.state", &ph_pointcloud3d_data_type},
};
