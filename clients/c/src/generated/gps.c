/** Generated from interfaces/013_gps.toml by codegen; do not edit. */
#include "playhouse/c/generated/gps.h"

#include <stddef.h>

static const ph_field ph_gps_data_fields[15] = {
    {"time_sec", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, time_sec), 0, NULL},
    {"time_usec", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, time_usec), 0, NULL},
    {"latitude", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, latitude), 0, NULL},
    {"longitude", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, longitude), 0, NULL},
    {"altitude", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, altitude), 0, NULL},
    {"speed", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, speed), 0, NULL},
    {"course", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, course), 0, NULL},
    {"utm_e", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, utm_e), 0, NULL},
    {"utm_n", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, utm_n), 0, NULL},
    {"quality", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, quality), 0, NULL},
    {"num_sats", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, num_sats), 0, NULL},
    {"hdop", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, hdop), 0, NULL},
    {"vdop", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, vdop), 0, NULL},
    {"err_horz", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, err_horz), 0, NULL},
    {"err_vert", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_gps_data, err_vert), 0, NULL},
};
const ph_struct_type ph_gps_data_type = {"gps.Data", ph_gps_data_fields, 15, 84, sizeof(ph_gps_data)};

const ph_message_type ph_gps_messages[1] = {
    {13, PH_KIND_DATA, 1, "gps.data.state", &ph_gps_data_type},
};
