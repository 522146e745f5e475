/** Generated from interfaces/065_stereo.toml by codegen; do not edit. */
#include "playhouse/c/generated/stereo.h"

#include <stddef.h>

static const ph_field ph_stereo_pointcloud3d_stereo_element_fields[6] = {
    {"px", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, px), 0, NULL},
    {"py", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, py), 0, NULL},
    {"pz", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, pz), 0, NULL},
    {"red", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, red), 0, NULL},
    {"green", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, green), 0, NULL},
    {"blue", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_pointcloud3d_stereo_element, blue), 0, NULL},
};
const ph_struct_type ph_stereo_pointcloud3d_stereo_element_type = {"stereo.Pointcloud3dStereoElement", ph_stereo_pointcloud3d_stereo_element_fields, 6, 24, sizeof(ph_stereo_pointcloud3d_stereo_element)};

static const ph_field ph_stereo_data_fields[5] = {
    {"left_channel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_data, left_channel), 0, &ph_camera_data_type},
    {"right_channel", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_data, right_channel), 0, &ph_camera_data_type},
    {"disparity", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_data, disparity), 0, &ph_camera_data_type},
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1398099, offsetof(ph_stereo_data, points), offsetof(ph_stereo_data, points_count), &ph_stereo_pointcloud3d_stereo_element_type},
    {"mode", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_stereo_data, mode), 0, NULL},
};
const ph_struct_type ph_stereo_data_type = {"stereo.Data", ph_stereo_data_fields, 5, 108, sizeof(ph_stereo_data)};

const ph_message_type ph_stereo_messages[1] = {
    {65, PH_KIND_DATA, 1, "stereo.data.state", &ph_stereo_data_type},
};
