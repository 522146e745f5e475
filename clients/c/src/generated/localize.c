/** Generated from interfaces/025_localize.toml by codegen; do not edit. */
#include "playhouse/c/generated/localize.h"

#include <stddef.h>

static const ph_field ph_localize_hypoth_fields[3] = {
    {"mean", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_hypoth, mean), 0, &ph_common_pose2d_type},
    {"cov", PH_TYPE_FLOAT64, PH_SHAPE_FIXED, 0, 0, 6, offsetof(ph_localize_hypoth, cov), 0, NULL},
    {"alpha", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_hypoth, alpha), 0, NULL},
};
const ph_struct_type ph_localize_hypoth_type = {"localize.Hypoth", ph_localize_hypoth_fields, 3, 80, sizeof(ph_localize_hypoth)};

static const ph_field ph_localize_data_fields[3] = {
    {"pending_count", PH_TYPE_UINT32, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_data, pending_count), 0, NULL},
    {"pending_time", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_data, pending_time), 0, NULL},
    {"hypoths", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 419429, offsetof(ph_localize_data, hypoths), offsetof(ph_localize_data, hypoths_count), &ph_localize_hypoth_type},
};
const ph_struct_type ph_localize_data_type = {"localize.Data", ph_localize_data_fields, 3, 20, sizeof(ph_localize_data)};

static const ph_field ph_localize_set_pose_fields[2] = {
    {"mean", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_set_pose, mean), 0, &ph_common_pose2d_type},
    {"cov", PH_TYPE_FLOAT64, PH_SHAPE_FIXED, 0, 0, 6, offsetof(ph_localize_set_pose, cov), 0, NULL},
};
const ph_struct_type ph_localize_set_pose_type = {"localize.SetPose", ph_localize_set_pose_fields, 2, 72, sizeof(ph_localize_set_pose)};

static const ph_field ph_localize_particle_fields[2] = {
    {"pose", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_particle, pose), 0, &ph_common_pose2d_type},
    {"alpha", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_particle, alpha), 0, NULL},
};
const ph_struct_type ph_localize_particle_type = {"localize.Particle", ph_localize_particle_fields, 2, 32, sizeof(ph_localize_particle)};

static const ph_field ph_localize_get_particles_fields[3] = {
    {"mean", PH_TYPE_STRUCT, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_get_particles, mean), 0, &ph_common_pose2d_type},
    {"variance", PH_TYPE_FLOAT64, PH_SHAPE_ONE, 0, 0, 1, offsetof(ph_localize_get_particles, variance), 0, NULL},
    {"particles", PH_TYPE_STRUCT, PH_SHAPE_DYNAMIC, 0, 0, 1048574, offsetof(ph_localize_get_particles, particles), offsetof(ph_localize_get_particles, particles_count), &ph_localize_particle_type},
};
const ph_struct_type ph_localize_get_particles_type = {"localize.GetParticles", ph_localize_get_particles_fields, 3, 40, sizeof(ph_localize_get_particles)};

const ph_message_type ph_localize_messages[3] = {
    {25, PH_KIND_DATA, 1, "localize.data.hypoths", &ph_localize_data_type},
    {25, PH_KIND_REQ, 1, "localize.req.set_pose", &ph_localize_set_pose_type},
    {25, PH_KIND_REQ, 2, "localize.req.get_particles", &ph_localize_get_particles_type},
};
