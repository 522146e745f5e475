// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Reads the words of an entity into its description, which has what counts where a word is not there. Faults
/// are kept in the state of the load. `row` is the model's: it decides what color "random" is.

#include <cstddef>

#include "playhouse/scene/generated/kind_descs.h"
#include "playhouse/scene/properties.h"

namespace playhouse::scene {

void read(const Properties& properties, std::size_t row, PlainDesc& to);
void read(const Properties& properties, std::size_t row, RangerSensorDesc& to);
void read(const Properties& properties, WindowDesc& to);
void read(const Properties& properties, WorldDesc& to);

/// Reads what models of a kind say beyond PlainDesc.
void read_kind(const Properties& properties, ModelKind kind, KindDescs& to);

/// False for a model without the description of its kind: impossible from files, possible from code.
bool is_described(ModelKind kind, const KindDescs& by);

}  // namespace playhouse::scene
