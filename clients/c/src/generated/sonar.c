/** Generated from interfaces/005_sonar.toml by codegen; do not edit. */
#include "playhouse/c/generated/sonar.h"

#include <stddef.h>

static const ph_field ph_sonar_data_fields[1] = {
    {"ranges", PH_TYPE_FLOAT32, PH_SHAPE_DYNAMIC, 0, 0, 8388598, offsetof(ph_sonar_data, ranges), offsetof(ph_sonar_data, ranges_count), NULL},
};
const ph_struct_type ph_sonar_data_type = {"sonar.Data", ph_sonar_data_fields, 1, 8, sizeof(ph_sonar_data)};

static const ph_field ph_sonar_geom_fields[1] = {
    {"poses", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 699049, offsetof(ph_sonar_geom, poses), offsetof(ph_sonar_geom, poses_count), &ph_common_pose3d_type},
};
const ph_struct_type ph_sonar_geom_type = {"sonar.Geom", ph_sonar_geom_fields, 1, 8, sizeof(ph_sonar_geom)};

static const ph_field ph_sonar_power_config_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_sonar_power_config, state), 0, NULL},
};
const ph_struct_type ph_sonar_power_config_type = {"sonar.PowerConfig", ph_sonar_power_config_fields, 1, 4, sizeof(ph_sonar_power_config)};

const ph_message_type ph_sonar_messages[4] = {
    {5, PH_KIND_DATA, 1, "sonar.data.ranges", &ph_sonar_data_type},
    {5, PH_KIND_DATA, 2, "sonar.data.geom", &ph_sonar_geom_type},
    {5, PH_KIND_REQ, 1, "sonar.req.get_geom", &ph_sonar_geom_type},
    {5, PH_KIND_REQ, 2, "sonar.req.power", &ph_sonar_power_config_type},
};
