#pragma once

/// The words about the mesh of a model: mesh_pose, mesh_scale and mesh_fit.

#include "playhouse/mesh/placement.h"
#include "playhouse/scene/properties.h"
#include "playhouse/scene/text/write_word.h"

namespace playhouse::scene {

/// Errors of scales that are 0 or out of range; a warning of a place that has no effect.
mesh::Placement read_placement(const Properties& properties);
/// Those that are not the default.
void write_placement(const mesh::Placement& at, Words& words);

/// Warns of these words in a model without a mesh, unless they say what is so without them.
void warn_without_mesh(const Properties& properties);

/// Warns of an extent that is that of a file in millimetres or inches, unless the file says what is meant.
void warn_of_extent(const Properties& properties, const std::string& path, const geom::Vec3& extent);

}  // namespace playhouse::scene
