/** Generated from interfaces/055_graphics2d.toml by codegen; do not edit. */
#include "playhouse/c/generated/graphics2d.h"

#include <stddef.h>

static const ph_field ph_graphics2d_cmd_points_fields[2] = {
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2097149, offsetof(ph_graphics2d_cmd_points, points), offsetof(ph_graphics2d_cmd_points, points_count), &ph_common_point2d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_points, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_graphics2d_cmd_points_type = {"graphics2d.CmdPoints", ph_graphics2d_cmd_points_fields, 2, 24, sizeof(ph_graphics2d_cmd_points)};

static const ph_field ph_graphics2d_cmd_polyline_fields[2] = {
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2097149, offsetof(ph_graphics2d_cmd_polyline, points), offsetof(ph_graphics2d_cmd_polyline, points_count), &ph_common_point2d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_polyline, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_graphics2d_cmd_polyline_type = {"graphics2d.CmdPolyline", ph_graphics2d_cmd_polyline_fields, 2, 24, sizeof(ph_graphics2d_cmd_polyline)};

static const ph_field ph_graphics2d_cmd_polygon_fields[4] = {
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2097149, offsetof(ph_graphics2d_cmd_polygon, points), offsetof(ph_graphics2d_cmd_polygon, points_count), &ph_common_point2d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_polygon, color), 0, &ph_common_color_type},
    {"fill_color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_polygon, fill_color), 0, &ph_common_color_type},
    {"filled", PH_TYPE_UINT8, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_polygon, filled), 0, NULL},
};
const ph_struct_type ph_graphics2d_cmd_polygon_type = {"graphics2d.CmdPolygon", ph_graphics2d_cmd_polygon_fields, 4, 44, sizeof(ph_graphics2d_cmd_polygon)};

static const ph_field ph_graphics2d_cmd_multiline_fields[2] = {
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 2097149, offsetof(ph_graphics2d_cmd_multiline, points), offsetof(ph_graphics2d_cmd_multiline, points_count), &ph_common_point2d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics2d_cmd_multiline, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_graphics2d_cmd_multiline_type = {"graphics2d.CmdMultiline", ph_graphics2d_cmd_multiline_fields, 2, 24, sizeof(ph_graphics2d_cmd_multiline)};

const ph_message_type ph_graphics2d_messages[5] = {
    {55, PH_KIND_CMD, 1, "graphics2d.cmd.clear", NULL},
    {55, PH_KIND_CMD, 2, "graphics2d.cmd.points", &ph_graphics2d_cmd_points_type},
    {55, PH_KIND_CMD, 3, "graphics2d.cmd.polyline", &ph_graphics2d_cmd_polyline_type},
    {55, PH_KIND_CMD, 4, "graphics2d.cmd.polygon", &ph_graphics2d_cmd_polygon_type},
    {55, PH_KIND_CMD, 5, "graphics2d.cmd.multiline", &ph_graphics2d_cmd_multiline_type},
};
