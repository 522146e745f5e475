/** Generated from interfaces/058_graphics3d.toml by codegen; do not edit. */
#include "playhouse/c/generated/graphics3d.h"

#include <stddef.h>

static const ph_field ph_graphics3d_cmd_draw_fields[3] = {
    {"draw_mode", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_draw, draw_mode), 0, NULL},
    {"points", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1398099, offsetof(ph_graphics3d_cmd_draw, points), offsetof(ph_graphics3d_cmd_draw, points_count), &ph_common_point3d_type},
    {"color", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_draw, color), 0, &ph_common_color_type},
};
const ph_struct_type ph_graphics3d_cmd_draw_type = {"graphics3d.CmdDraw", ph_graphics3d_cmd_draw_fields, 3, 28, sizeof(ph_graphics3d_cmd_draw)};

static const ph_field ph_graphics3d_cmd_translate_fields[3] = {
    {"x", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_translate, x), 0, NULL},
    {"y", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_translate, y), 0, NULL},
    {"z", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_translate, z), 0, NULL},
};
const ph_struct_type ph_graphics3d_cmd_translate_type = {"graphics3d.CmdTranslate", ph_graphics3d_cmd_translate_fields, 3, 24, sizeof(ph_graphics3d_cmd_translate)};

static const ph_field ph_graphics3d_cmd_rotate_fields[4] = {
    {"a", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_rotate, a), 0, NULL},
    {"x", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_rotate, x), 0, NULL},
    {"y", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_rotate, y), 0, NULL},
    {"z", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_graphics3d_cmd_rotate, z), 0, NULL},
};
const ph_struct_type ph_graphics3d_cmd_rotate_type = {"graphics3d.CmdRotate", ph_graphics3d_cmd_rotate_fields, 4, 32, sizeof(ph_graphics3d_cmd_rotate)};

const ph_message_type ph_graphics3d_messages[6] = {
    {58, PH_KIND_CMD, 1, "graphics3d.cmd.clear", NULL},
    {58, PH_KIND_CMD, 2, "graphics3d.cmd.draw", &ph_graphics3d_cmd_draw_type},
    {58, PH_KIND_CMD, 3, "graphics3d.cmd.translate", &ph_graphics3d_cmd_translate_type},
    {58, PH_KIND_CMD, 4, "graphics3d.cmd.rotate", &ph_graphics3d_cmd_rotate_type},
    {58, PH_KIND_CMD, 5, "graphics3d.cmd.push", NULL},
    {58, PH_KIND_CMD, 6, "graphics3d.cmd.pop", NULL},
};
