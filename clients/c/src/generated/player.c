/** Generated from interfaces/001_player.toml by codegen; do not edit. */
#include "playhouse/c/generated/player.h"

#include <stddef.h>

static const ph_field ph_player_device_devlist_fields[1] = {
    {"devices", PH_TYPE_STRUCT, PH_SHAPE_COUNTED, 0, 0, 4096, offsetof(ph_player_device_devlist, devices), offsetof(ph_player_device_devlist, devices_count), &ph_common_devaddr_type},
};
const ph_struct_type ph_player_device_devlist_type = {"player.DeviceDevlist", ph_player_device_devlist_fields, 1, 8, sizeof(ph_player_device_devlist)};

static const ph_field ph_player_device_driverinfo_fields[2] = {
    {"addr", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_device_driverinfo, addr), 0, &ph_common_devaddr_type},
    {"driver_name", PH_TYPE_CHAR, PH_SHAPE_COUNTED, 0, 0, 64, offsetof(ph_player_device_driverinfo, driver_name), offsetof(ph_player_device_driverinfo, driver_name_count), NULL},
};
const ph_struct_type ph_player_device_driverinfo_type = {"player.DeviceDriverinfo", ph_player_device_driverinfo_fields, 2, 24, sizeof(ph_player_device_driverinfo)};

static const ph_field ph_player_device_req_fields[3] = {
    {"addr", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_device_req, addr), 0, &ph_common_devaddr_type},
    {"access", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_device_req, access), 0, NULL},
    {"driver_name", PH_TYPE_CHAR, PH_SHAPE_COUNTED, 0, 0, 64, offsetof(ph_player_device_req, driver_name), offsetof(ph_player_device_req, driver_name_count), NULL},
};
const ph_struct_type ph_player_device_req_type = {"player.DeviceReq", ph_player_device_req_fields, 3, 28, sizeof(ph_player_device_req)};

static const ph_field ph_player_device_datamode_req_fields[1] = {
    {"mode", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_device_datamode_req, mode), 0, NULL},
};
const ph_struct_type ph_player_device_datamode_req_type = {"player.DeviceDatamodeReq", ph_player_device_datamode_req_fields, 1, 4, sizeof(ph_player_device_datamode_req)};

static const ph_field ph_player_device_auth_req_fields[1] = {
    {"auth_key", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 32, offsetof(ph_player_device_auth_req, auth_key), offsetof(ph_player_device_auth_req, auth_key_count), NULL},
};
const ph_struct_type ph_player_device_auth_req_type = {"player.DeviceAuthReq", ph_player_device_auth_req_fields, 1, 8, sizeof(ph_player_device_auth_req)};

static const ph_field ph_player_device_nameservice_req_fields[2] = {
    {"name", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 64, offsetof(ph_player_device_nameservice_req, name), offsetof(ph_player_device_nameservice_req, name_count), NULL},
    {"port", PH_TYPE_UINT16, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_device_nameservice_req, port), 0, NULL},
};
const ph_struct_type ph_player_device_nameservice_req_type = {"player.DeviceNameserviceReq", ph_player_device_nameservice_req_fields, 2, 12, sizeof(ph_player_device_nameservice_req)};

static const ph_field ph_player_add_replace_rule_req_fields[5] = {
    {"interf", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_add_replace_rule_req, interf), 0, NULL},
    {"index", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_add_replace_rule_req, index), 0, NULL},
    {"type", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_add_replace_rule_req, type), 0, NULL},
    {"subtype", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_add_replace_rule_req, subtype), 0, NULL},
    {"replace", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_player_add_replace_rule_req, replace), 0, NULL},
};
const ph_struct_type ph_player_add_replace_rule_req_type = {"player.AddReplaceRuleReq", ph_player_add_replace_rule_req_fields, 5, 20, sizeof(ph_player_add_replace_rule_req)};

const ph_message_type ph_player_messages[10] = {
    {1, PH_KIND_REQ, 1, "player.req.devlist", &ph_player_device_devlist_type},
    {1, PH_KIND_REQ, 2, "player.req.driverinfo", &ph_player_device_driverinfo_type},
    {1, PH_KIND_REQ, 3, "player.req.dev", &ph_player_device_req_type},
    {1, PH_KIND_REQ, 4, "player.req.data", NULL},
    {1, PH_KIND_REQ, 5, "player.req.datamode", &ph_player_device_datamode_req_type},
    {1, PH_KIND_REQ, 7, "player.req.auth", &ph_player_device_auth_req_type},
    {1, PH_KIND_REQ, 8, "player.req.nameservice", &ph_player_device_nameservice_req_type},
    {1, PH_KIND_REQ, 10, "player.req.add_replace_rule", &ph_player_add_replace_rule_req_type},
    {1, PH_KIND_SYNCH, 1, "player.synch.ok", NULL},
    {1, PH_KIND_SYNCH, 2, "player.synch.overflow", &ph_common_uint32_type},
};
