/** Generated from interfaces/059_health.toml by codegen; do not edit. */
#include "playhouse/c/generated/health.h"

#include <stddef.h>

static const ph_field ph_health_cpu_fields[3] = {
    {"idle", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_cpu, idle), 0, NULL},
    {"system", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_cpu, system), 0, NULL},
    {"user", PH_TYPE_FLOAT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_cpu, user), 0, NULL},
};
const ph_struct_type ph_health_cpu_type = {"health.Cpu", ph_health_cpu_fields, 3, 12, sizeof(ph_health_cpu)};

static const ph_field ph_health_memory_fields[3] = {
    {"total", PH_TYPE_INT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_memory, total), 0, NULL},
    {"used", PH_TYPE_INT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_memory, used), 0, NULL},
    {"free", PH_TYPE_INT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_memory, free), 0, NULL},
};
const ph_struct_type ph_health_memory_type = {"health.Memory", ph_health_memory_fields, 3, 24, sizeof(ph_health_memory)};

static const ph_field ph_health_data_fields[3] = {
    {"cpu_usage", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_data, cpu_usage), 0, &ph_health_cpu_type},
    {"mem", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_data, mem), 0, &ph_health_memory_type},
    {"swap", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_health_data, swap), 0, &ph_health_memory_type},
};
const ph_struct_type ph_health_data_type = {"health.Data", ph_health_data_fields, 3, 60, sizeof(ph_health_data)};

const ph_message_type ph_health_messages[1] = {
    {59, PH_KIND_DATA, 1, "health.data.state", &ph_health_data_type},
};
