/** Generated from interfaces/040_camera.toml by codegen; do not edit. */
#include "playhouse/c/generated/camera.h"

#include <stddef.h>

static const ph_field ph_camera_data_fields[7] = {
    {"width", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, width), 0, NULL},
    {"height", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, height), 0, NULL},
    {"bpp", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, bpp), 0, NULL},
    {"format", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, format), 0, NULL},
    {"fdiv", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, fdiv), 0, NULL},
    {"compression", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_data, compression), 0, NULL},
    {"image", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_camera_data, image), offsetof(ph_camera_data, image_count), NULL},
};
const ph_struct_type ph_camera_data_type = {"camera.Data", ph_camera_data_fields, 7, 32, sizeof(ph_camera_data)};

static const ph_field ph_camera_source_fields[2] = {
    {"norm", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_camera_source, norm), offsetof(ph_camera_source, norm_count), NULL},
    {"source", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_camera_source, source), 0, NULL},
};
const ph_struct_type ph_camera_source_type = {"camera.Source", ph_camera_source_fields, 2, 12, sizeof(ph_camera_source)};

const ph_message_type ph_camera_messages[4] = {
    {40, PH_KIND_DATA, 1, "camera.data.state", &ph_camera_data_type},
    {40, PH_KIND_REQ, 1, "camera.req.get_source", &ph_camera_source_type},
    {40, PH_KIND_REQ, 2, "camera.req.set_source", &ph_camera_source_type},
    {40, PH_KIND_REQ, 3, "camera.req.get_image", &ph_camera_data_type},
};
