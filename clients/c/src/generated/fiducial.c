/** Generated from interfaces/010_fiducial.toml by codegen; do not edit. */
#include "playhouse/c/generated/fiducial.h"

#include <stddef.h>

static const ph_field ph_fiducial_item_fields[3] = {
    {"id", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_item, id), 0, NULL},
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_item, pose), 0, &ph_common_pose3d_type},
    {"upose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_item, upose), 0, &ph_common_pose3d_type},
};
const ph_struct_type ph_fiducial_item_type = {"fiducial.Item", ph_fiducial_item_fields, 3, 100, sizeof(ph_fiducial_item)};

static const ph_field ph_fiducial_data_fields[1] = {
    {"fiducials", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 335543, offsetof(ph_fiducial_data, fiducials), offsetof(ph_fiducial_data, fiducials_count), &ph_fiducial_item_type},
};
const ph_struct_type ph_fiducial_data_type = {"fiducial.Data", ph_fiducial_data_fields, 1, 8, sizeof(ph_fiducial_data)};

static const ph_field ph_fiducial_geom_fields[3] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_geom, size), 0, &ph_common_bbox3d_type},
    {"fiducial_size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_geom, fiducial_size), 0, &ph_common_bbox2d_type},
};
const ph_struct_type ph_fiducial_geom_type = {"fiducial.Geom", ph_fiducial_geom_fields, 3, 88, sizeof(ph_fiducial_geom)};

static const ph_field ph_fiducial_fov_fields[3] = {
    {"min_range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_fov, min_range), 0, NULL},
    {"max_range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_fov, max_range), 0, NULL},
    {"view_angle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_fov, view_angle), 0, NULL},
};
const ph_struct_type ph_fiducial_fov_type = {"fiducial.Fov", ph_fiducial_fov_fields, 3, 12, sizeof(ph_fiducial_fov)};

static const ph_field ph_fiducial_id_fields[1] = {
    {"id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_fiducial_id, id), 0, NULL},
};
const ph_struct_type ph_fiducial_id_type = {"fiducial.Id", ph_fiducial_id_fields, 1, 4, sizeof(ph_fiducial_id)};

const ph_message_type ph_fiducial_messages[6] = {
    {10, PH_KIND_DATA, 1, "fiducial.data.scan", &ph_fiducial_data_type},
    {10, PH_KIND_REQ, 1, "fiducial.req.get_geom", &ph_fiducial_geom_type},
    {10, PH_KIND_REQ, 2, "fiducial.req.get_fov", &ph_fiducial_fov_type},
    {10, PH_KIND_REQ, 3, "fiducial.req.set_fov", &ph_fiducial_fov_type},
    {10, PH_KIND_REQ, 7, "fiducial.req.get_id", &ph_fiducial_id_type},
    {10, PH_KIND_REQ, 8, "fiducial.req.set_id", &ph_fiducial_id_type},
};
