/** Generated from interfaces/014_bumper.toml by codegen; do not edit. */
#include "playhouse/c/generated/bumper.h"

#include <stddef.h>

static const ph_field ph_bumper_data_fields[1] = {
    {"bumpers", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_bumper_data, bumpers), offsetof(ph_bumper_data, bumpers_count), NULL},
};
const ph_struct_type ph_bumper_data_type = {"bumper.Data", ph_bumper_data_fields, 1, 8, sizeof(ph_bumper_data)};

static const ph_field ph_bumper_define_fields[3] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_bumper_define, pose), 0, &ph_common_pose3d_type},
    {"length", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_bumper_define, length), 0, NULL},
    {"radius", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_bumper_define, radius), 0, NULL},
};
const ph_struct_type ph_bumper_define_type = {"bumper.Define", ph_bumper_define_fields, 3, 56, sizeof(ph_bumper_define)};

static const ph_field ph_bumper_geom_fields[1] = {
    {"bumper_def", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 599185, offsetof(ph_bumper_geom, bumper_def), offsetof(ph_bumper_geom, bumper_def_count), &ph_bumper_define_type},
};
const ph_struct_type ph_bumper_geom_type = {"bumper.Geom", ph_bumper_geom_fields, 1, 8, sizeof(ph_bumper_geom)};

const ph_message_type ph_bumper_messages[3] = {
    {14, PH_KIND_DATA, 1, "bumper.data.state", &ph_bumper_data_type},
    {14, PH_KIND_DATA, 2, "bumper.data.geom", &ph_bumper_geom_type},
    {14, PH_KIND_REQ, 1, "bumper.req.get_geom", &ph_bumper_geom_type},
};
