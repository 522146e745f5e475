// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Writes the words in which a description differs from `unsaid`, that of an entity that says nothing, so
/// that read() of read_kinds.h gives it back.

#include "playhouse/scene/generated/kind_descs.h"
#include "playhouse/scene/text/write_word.h"

namespace playhouse::scene {

/// `z` is the height, in the frame of the pose, from which the file counts: that of a parent on which the
/// model stands. [m]
void write(const PlainDesc& from, const PlainDesc& unsaid, double z, Words& to);
void write(const WindowDesc& from, const WindowDesc& unsaid, Words& to);
void write(const WorldDesc& from, const WorldDesc& unsaid, Words& to);

/// Writes what models say beyond PlainDesc, and the entities that are parts of them.
void write_kind(const KindDescs& from, const Units& units, Entity& to);

}  // namespace playhouse::scene
