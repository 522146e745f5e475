/** Generated from interfaces/006_laser.toml by codegen; do not edit. */
#include "playhouse/c/generated/laser.h"

#include <stddef.h>

static const ph_field ph_laser_data_fields[7] = {
    {"min_angle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data, min_angle), 0, NULL},
    {"max_angle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data, max_angle), 0, NULL},
    {"resolution", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data, resolution), 0, NULL},
    {"max_range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data, max_range), 0, NULL},
    {"ranges", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_laser_data, ranges), offsetof(ph_laser_data, ranges_count), NULL},
    {"intensity", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_laser_data, intensity), offsetof(ph_laser_data, intensity_count), NULL},
    {"id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data, id), 0, NULL},
};
const ph_struct_type ph_laser_data_type = {"laser.Data", ph_laser_data_fields, 7, 36, sizeof(ph_laser_data)};

static const ph_field ph_laser_data_scanpose_fields[2] = {
    {"scan", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data_scanpose, scan), 0, &ph_laser_data_type},
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data_scanpose, pose), 0, &ph_common_pose2d_type},
};
const ph_struct_type ph_laser_data_scanpose_type = {"laser.DataScanpose", ph_laser_data_scanpose_fields, 2, 60, sizeof(ph_laser_data_scanpose)};

static const ph_field ph_laser_data_scanangle_fields[5] = {
    {"max_range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data_scanangle, max_range), 0, NULL},
    {"ranges", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_laser_data_scanangle, ranges), offsetof(ph_laser_data_scanangle, ranges_count), NULL},
    {"angles", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_laser_data_scanangle, angles), offsetof(ph_laser_data_scanangle, angles_count), NULL},
    {"intensity", PH_TYPE_UINT8, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_laser_data_scanangle, intensity), offsetof(ph_laser_data_scanangle, intensity_count), NULL},
    {"id", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_data_scanangle, id), 0, NULL},
};
const ph_struct_type ph_laser_data_scanangle_type = {"laser.DataScanangle", ph_laser_data_scanangle_fields, 5, 32, sizeof(ph_laser_data_scanangle)};

static const ph_field ph_laser_geom_fields[2] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_geom, size), 0, &ph_common_bbox3d_type},
};
const ph_struct_type ph_laser_geom_type = {"laser.Geom", ph_laser_geom_fields, 2, 72, sizeof(ph_laser_geom)};

static const ph_field ph_laser_config_fields[7] = {
    {"min_angle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, min_angle), 0, NULL},
    {"max_angle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, max_angle), 0, NULL},
    {"resolution", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, resolution), 0, NULL},
    {"max_range", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, max_range), 0, NULL},
    {"range_res", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, range_res), 0, NULL},
    {"intensity", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, intensity), 0, NULL},
    {"scanning_frequency", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_config, scanning_frequency), 0, NULL},
};
const ph_struct_type ph_laser_config_type = {"laser.Config", ph_laser_config_fields, 7, 28, sizeof(ph_laser_config)};

static const ph_field ph_laser_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_power_config, state), 0, NULL},
};
const ph_struct_type ph_laser_power_config_type = {"laser.PowerConfig", ph_laser_power_config_fields, 1, 4, sizeof(ph_laser_power_config)};

static const ph_field ph_laser_get_id_config_fields[1] = {
    {"serial_number", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_get_id_config, serial_number), 0, NULL},
};
const ph_struct_type ph_laser_get_id_config_type = {"laser.GetIdConfig", ph_laser_get_id_config_fields, 1, 4, sizeof(ph_laser_get_id_config)};

static const ph_field ph_laser_set_filter_config_fields[2] = {
    {"filter_type", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_laser_set_filter_config, filter_type), 0, NULL},
    {"parameters", PH_TYPE_FLOAT32, PH_SHAPE_COUNTED, 0, 0, 8, offsetof(ph_laser_set_filter_config, parameters), offsetof(ph_laser_set_filter_config, parameters_count), NULL},
};
const ph_struct_type ph_laser_set_filter_config_type = {"laser.SetFilterConfig", ph_laser_set_filter_config_fields, 2, 12, sizeof(ph_laser_set_filter_config)};

const ph_message_type ph_laser_messages[9] = {
    {6, PH_KIND_DATA, 1, "laser.data.scan", &ph_laser_data_type},
    {6, PH_KIND_DATA, 2, "laser.data.scanpose", &ph_laser_data_scanpose_type},
    {6, PH_KIND_DATA, 3, "laser.data.scanangle", &ph_laser_data_scanangle_type},
    {6, PH_KIND_REQ, 1, "laser.req.get_geom", &ph_laser_geom_type},
    {6, PH_KIND_REQ, 2, "laser.req.set_config", &ph_laser_config_type},
    {6, PH_KIND_REQ, 3, "laser.req.get_config", &ph_laser_config_type},
    {6, PH_KIND_REQ, 4, "laser.req.power", &ph_laser_power_config_type},
    {6, PH_KIND_REQ, 5, "laser.req.get_id", &ph_laser_get_id_config_type},
    {6, PH_KIND_REQ, 6, "laser.req.set_filter", &ph_laser_set_filter_config_type},
};
