/** Generated from interfaces/045_log.toml by codegen; do not edit. */
#include "playhouse/c/generated/log.h"

#include <stddef.h>

static const ph_field ph_log_set_write_state_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_log_set_write_state, state), 0, NULL},
};
const ph_struct_type ph_log_set_write_state_type = {"log.SetWriteState", ph_log_set_write_state_fields, 1, 4, sizeof(ph_log_set_write_state)};

static const ph_field ph_log_set_read_state_fields[1] = {
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_log_set_read_state, state), 0, NULL},
};
const ph_struct_type ph_log_set_read_state_type = {"log.SetReadState", ph_log_set_read_state_fields, 1, 4, sizeof(ph_log_set_read_state)};

static const ph_field ph_log_get_state_fields[2] = {
    {"type", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_log_get_state, type), 0, NULL},
    {"state", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_log_get_state, state), 0, NULL},
};
const ph_struct_type ph_log_get_state_type = {"log.GetState", ph_log_get_state_fields, 2, 8, sizeof(ph_log_get_state)};

static const ph_field ph_log_set_filename_fields[1] = {
    {"filename", PH_TYPE_CHAR, PH_SHAPE_COUNTED, 0, 0, 256, offsetof(ph_log_set_filename, filename), offsetof(ph_log_set_filename, filename_count), NULL},
};
const ph_struct_type ph_log_set_filename_type = {"log.SetFilename", ph_log_set_filename_fields, 1, 8, sizeof(ph_log_set_filename)};

const ph_message_type ph_log_messages[5] = {
    {45, PH_KIND_REQ, 1, "log.req.set_write_state", &ph_log_set_write_state_type},
    {45, PH_KIND_REQ, 2, "log.req.set_read_state", &ph_log_set_read_state_type},
    {45, PH_KIND_REQ, 3, "log.req.get_state", &ph_log_get_state_type},
    {45, PH_KIND_REQ, 4, "log.req.set_read_rewind", NULL},
    {45, PH_KIND_REQ, 5, "log.req.set_filename", &ph_log_set_filename_type},
};
