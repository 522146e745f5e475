/** Generated from interfaces/062_ranger.toml by codegen; do not edit. */
#include "playhouse/c/generated/ranger.h"

#include <stddef.h>

static const ph_field ph_ranger_config_fields[7] = {
    {"min_angle", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, min_angle), 0, NULL},
    {"max_angle", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, max_angle), 0, NULL},
    {"angular_res", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, angular_res), 0, NULL},
    {"min_range", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, min_range), 0, NULL},
    {"max_range", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, max_range), 0, NULL},
    {"range_res", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, range_res), 0, NULL},
    {"frequency", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_config, frequency), 0, NULL},
};
const ph_struct_type ph_ranger_config_type = {"ranger.Config", ph_ranger_config_fields, 7, 56, sizeof(ph_ranger_config)};

static const ph_field ph_ranger_geom_fields[4] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_geom, pose), 0, &ph_common_pose3d_type},
    {"size", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_geom, size), 0, &ph_common_bbox3d_type},
    {"element_poses", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 699049, offsetof(ph_ranger_geom, element_poses), offsetof(ph_ranger_geom, element_poses_count), &ph_common_pose3d_type},
    {"element_sizes", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1398099, offsetof(ph_ranger_geom, element_sizes), offsetof(ph_ranger_geom, element_sizes_count), &ph_common_bbox3d_type},
};
const ph_struct_type ph_ranger_geom_type = {"ranger.Geom", ph_ranger_geom_fields, 4, 88, sizeof(ph_ranger_geom)};

static const ph_field ph_ranger_data_range_fields[1] = {
    {"ranges", PH_TYPE_FLOAT64, PH_SHAPE_DYNAMIC, 0, 0, 4194299, offsetof(ph_ranger_data_range, ranges), offsetof(ph_ranger_data_range, ranges_count), NULL},
};
const ph_struct_type ph_ranger_data_range_type = {"ranger.DataRange", ph_ranger_data_range_fields, 1, 8, sizeof(ph_ranger_data_range)};

static const ph_field ph_ranger_data_rangestamped_fields[5] = {
    {"data", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_rangestamped, data), 0, &ph_ranger_data_range_type},
    {"have_geom", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_rangestamped, have_geom), 0, NULL},
    {"geom", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_rangestamped, geom), 0, &ph_ranger_geom_type},
    {"have_config", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_rangestamped, have_config), 0, NULL},
    {"config", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_rangestamped, config), 0, &ph_ranger_config_type},
};
const ph_struct_type ph_ranger_data_rangestamped_type = {"ranger.DataRangestamped", ph_ranger_data_rangestamped_fields, 5, 160, sizeof(ph_ranger_data_rangestamped)};

static const ph_field ph_ranger_data_intns_fields[1] = {
    {"intensities", PH_TYPE_FLOAT64, PH_SHAPE_DYNAMIC, 0, 0, 4194299, offsetof(ph_ranger_data_intns, intensities), offsetof(ph_ranger_data_intns, intensities_count), NULL},
};
const ph_struct_type ph_ranger_data_intns_type = {"ranger.DataIntns", ph_ranger_data_intns_fields, 1, 8, sizeof(ph_ranger_data_intns)};

static const ph_field ph_ranger_data_intnsstamped_fields[5] = {
    {"data", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_intnsstamped, data), 0, &ph_ranger_data_intns_type},
    {"have_geom", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_intnsstamped, have_geom), 0, NULL},
    {"geom", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_intnsstamped, geom), 0, &ph_ranger_geom_type},
    {"have_config", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_intnsstamped, have_config), 0, NULL},
    {"config", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_data_intnsstamped, config), 0, &ph_ranger_config_type},
};
const ph_struct_type ph_ranger_data_intnsstamped_type = {"ranger.DataIntnsstamped", ph_ranger_data_intnsstamped_fields, 5, 160, sizeof(ph_ranger_data_intnsstamped)};

static const ph_field ph_ranger_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_power_config, state), 0, NULL},
};
const ph_struct_type ph_ranger_power_config_type = {"ranger.PowerConfig", ph_ranger_power_config_fields, 1, 4, sizeof(ph_ranger_power_config)};

static const ph_field ph_ranger_intns_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_ranger_intns_config, state), 0, NULL},
};
const ph_struct_type ph_ranger_intns_config_type = {"ranger.IntnsConfig", ph_ranger_intns_config_fields, 1, 4, sizeof(ph_ranger_intns_config)};

const ph_message_type ph_ranger_messages[10] = {
    {62, PH_KIND_DATA, 1, "ranger.data.range", &ph_ranger_data_range_type},
    {62, PH_KIND_DATA, 2, "ranger.data.rangestamped", &ph_ranger_data_rangestamped_type},
    {62, PH_KIND_DATA, 3, "ranger.data.intns", &ph_ranger_data_intns_type},
    {62, PH_KIND_DATA, 4, "ranger.data.intnsstamped", &ph_ranger_data_intnsstamped_type},
    {62, PH_KIND_DATA, 5, "ranger.data.geom", &ph_ranger_geom_type},
    {62, PH_KIND_REQ, 1, "ranger.req.get_geom", &ph_ranger_geom_type},
    {62, PH_KIND_REQ, 2, "ranger.req.power", &ph_ranger_power_config_type},
    {62, PH_KIND_REQ, 3, "ranger.req.intns", &ph_ranger_intns_config_type},
    {62, PH_KIND_REQ, 4, "ranger.req.set_config", &ph_ranger_config_type},
    {62, PH_KIND_REQ, 5, "ranger.req.get_config", &ph_ranger_config_type},
};
