/** Generated from interfaces/056_rfid.toml by codegen; do not edit. */
#include "playhouse/c/generated/rfid.h"

#include <stddef.h>

static const ph_field ph_rfid_tag_fields[2] = {
    {"type", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_rfid_tag, type), 0, NULL},
    {"guid", PH_TYPE_CHAR, PH_SHAPE_DYNAMIC, 0, 0, 33554392, offsetof(ph_rfid_tag, guid), offsetof(ph_rfid_tag, guid_count), NULL},
};
const ph_struct_type ph_rfid_tag_type = {"rfid.Tag", ph_rfid_tag_fields, 2, 12, sizeof(ph_rfid_tag)};

static const ph_field ph_rfid_data_fields[1] = {
    {"tags", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2796199, offsetof(ph_rfid_data, tags), offsetof(ph_rfid_data, tags_count), &ph_rfid_tag_type},
};
const ph_struct_type ph_rfid_data_type = {"rfid.Data", ph_rfid_data_fields, 1, 8, sizeof(ph_rfid_data)};

const ph_message_type ph_rfid_messages[5] = {
    {56, PH_KIND_DATA, 1, "rfid.data.tags", &ph_rfid_data_type},
    {56, PH_KIND_REQ, 1, "rfid.req.power", NULL},
    {56, PH_KIND_REQ, 2, "rfid.req.readtag", NULL},
    {56, PH_KIND_REQ, 3, "rfid.req.writetag", NULL},
    {56, PH_KIND_REQ, 4, "rfid.req.locktag", NULL},
};
