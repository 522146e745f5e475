/** Generated from interfaces/023_wifi.toml by codegen; do not edit. */
#include "playhouse/c/generated/wifi.h"

#include <stddef.h>

static const ph_field ph_wifi_link_fields[9] = {
    {"mac", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 32, offsetof(ph_wifi_link, mac), offsetof(ph_wifi_link, mac_count), NULL},
    {"ip", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 32, offsetof(ph_wifi_link, ip), offsetof(ph_wifi_link, ip_count), NULL},
    {"essid", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 32, offsetof(ph_wifi_link, essid), offsetof(ph_wifi_link, essid_count), NULL},
    {"mode", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, mode), 0, NULL},
    {"freq", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, freq), 0, NULL},
    {"encrypt", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, encrypt), 0, NULL},
    {"qual", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, qual), 0, NULL},
    {"level", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, level), 0, NULL},
    {"noise", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_link, noise), 0, NULL},
};
const ph_struct_type ph_wifi_link_type = {"wifi.Link", ph_wifi_link_fields, 9, 48, sizeof(ph_wifi_link)};

static const ph_field ph_wifi_data_fields[9] = {
    {"links", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 699049, offsetof(ph_wifi_data, links), offsetof(ph_wifi_data, links_count), &ph_wifi_link_type},
    {"throughput", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, throughput), 0, NULL},
    {"bitrate", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, bitrate), 0, NULL},
    {"mode", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, mode), 0, NULL},
    {"qual_type", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, qual_type), 0, NULL},
    {"maxqual", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, maxqual), 0, NULL},
    {"maxlevel", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, maxlevel), 0, NULL},
    {"maxnoise", PH_TYPE_INT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_wifi_data, maxnoise), 0, NULL},
    {"ap", PH_TYPE_CHAR, PH_SHAPE_FIXED, 0, 0, 32, offsetof(ph_wifi_data, ap), 0, NULL},
};
const ph_struct_type ph_wifi_data_type = {"wifi.Data", ph_wifi_data_fields, 9, 68, sizeof(ph_wifi_data)};

static const ph_field ph_wifi_mac_req_fields[1] = {
    {"mac", PH_TYPE_UINT8, PH_SHAPE_COUNTED, 0, 0, 32, offsetof(ph_wifi_mac_req, mac), offsetof(ph_wifi_mac_req, mac_count), NULL},
};
const ph_struct_type ph_wifi_mac_req_type = {"wifi.MacReq", ph_wifi_mac_req_fields, 1, 8, sizeof(ph_wifi_mac_req)};

static const ph_field ph_wifi_iwspy_addr_req_fields[1] = {
    {"address", PH_TYPE_CHAR, PH_SHAPE_FIXED, 0, 0, 32, offsetof(ph_wifi_iwspy_addr_req, address), 0, NULL},
};
const ph_struct_type ph_wifi_iwspy_addr_req_type = {"wifi.IwspyAddrReq", ph_wifi_iwspy_addr_req_fields, 1, 32, sizeof(ph_wifi_iwspy_addr_req)};

const ph_message_type ph_wifi_messages[5] = {
    {23, PH_KIND_DATA, 1, "wifi.data.state", &ph_wifi_data_type},
    {23, PH_KIND_REQ, 1, "wifi.req.mac", &ph_wifi_mac_req_type},
    {23, PH_KIND_REQ, 2, "wifi.req.iwspy_add", &ph_wifi_iwspy_addr_req_type},
    {23, PH_KIND_REQ, 3, "wifi.req.iwspy_del", &ph_wifi_iwspy_addr_req_type},
    {23, PH_KIND_REQ, 4, "wifi.req.iwspy_ping", &ph_wifi_iwspy_addr_req_type},
};
