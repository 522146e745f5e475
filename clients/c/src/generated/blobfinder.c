/** Generated from interfaces/007_blobfinder.toml by codegen; do not edit. */
#include "playhouse/c/generated/blobfinder.h"

#include <stddef.h>

static const ph_field ph_blobfinder_blob_fields[10] = {
    {"id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, id), 0, NULL},
    {"color", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, color), 0, NULL},
    {"area", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, area), 0, NULL},
    {"x", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, x), 0, NULL},
    {"y", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, y), 0, NULL},
    {"left", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, left), 0, NULL},
    {"right", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, right), 0, NULL},
    {"top", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, top), 0, NULL},
    {"bottom", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, bottom), 0, NULL},
    {"range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_blob, range), 0, NULL},
};
const ph_struct_type ph_blobfinder_blob_type = {"blobfinder.Blob", ph_blobfinder_blob_fields, 10, 40, sizeof(ph_blobfinder_blob)};

static const ph_field ph_blobfinder_data_fields[3] = {
    {"width", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_data, width), 0, NULL},
    {"height", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_data, height), 0, NULL},
    {"blobs", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 838859, offsetof(ph_blobfinder_data, blobs), offsetof(ph_blobfinder_data, blobs_count), &ph_blobfinder_blob_type},
};
const ph_struct_type ph_blobfinder_data_type = {"blobfinder.Data", ph_blobfinder_data_fields, 3, 16, sizeof(ph_blobfinder_data)};

static const ph_field ph_blobfinder_color_config_fields[7] = {
    {"channel", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, channel), 0, NULL},
    {"rmin", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, rmin), 0, NULL},
    {"rmax", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, rmax), 0, NULL},
    {"gmin", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, gmin), 0, NULL},
    {"gmax", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, gmax), 0, NULL},
    {"bmin", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, bmin), 0, NULL},
    {"bmax", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_color_config, bmax), 0, NULL},
};
const ph_struct_type ph_blobfinder_color_config_type = {"blobfinder.ColorConfig", ph_blobfinder_color_config_fields, 7, 28, sizeof(ph_blobfinder_color_config)};

static const ph_field ph_blobfinder_imager_config_fields[4] = {
    {"brightness", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_imager_config, brightness), 0, NULL},
    {"contrast", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_imager_config, contrast), 0, NULL},
    {"colormode", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_imager_config, colormode), 0, NULL},
    {"autogain", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_blobfinder_imager_config, autogain), 0, NULL},
};
const ph_struct_type ph_blobfinder_imager_config_type = {"blobfinder.ImagerConfig", ph_blobfinder_imager_config_fields, 4, 16, sizeof(ph_blobfinder_imager_config)};

const ph_message_type ph_blobfinder_messages[4] = {
    {7, PH_KIND_DATA, 1, "blobfinder.data.blobs", &ph_blobfinder_data_type},
    {7, PH_KIND_REQ, 1, "blobfinder.req.set_color", &ph_blobfinder_color_config_type},
    {7, PH_KIND_REQ, 2, "blobfinder.req.set_imager_params", &ph_blobfinder_imager_config_type},
    {7, PH_KIND_REQ, 3, "blobfinder.req.get_color", &ph_blobfinder_color_config_type},
};
