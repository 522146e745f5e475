#pragma once

/// Properties of models, read and written by name through interface simulation. Values
/// are raw bytes, numbers little-endian, as existing clients copy them from memory.

#include <optional>
#include <string>
#include <string_view>

#include "playhouse/world/changes/journal.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// The value of a property, as bytes; none if the property or model does not exist.
///   "color"          four float32: red, green, blue, alpha in 0..1; "_mp_color" is the same, as programs for Stage 3
///                    and the manual of Player have it
///   "time"           uint64: simulated time [us]; `model` is ignored
///   without a model: "build", NUL-terminated text: version and commit of the program (base/version.h);
///   "wire_format", "robot_format", uint32: formats::kWireExtensions and kRobots
///   "name", "model"  NUL-terminated text: the model's name; its type as in the world file
std::optional<std::string> get_property(const world::World& world, std::string_view model,
                                        std::string_view property);

/// Only "color" is writable. False if the property or model does not exist, or the size is wrong.
bool set_property(world::Journal& journal, std::string_view model, std::string_view property,
                  std::string_view value);

}  // namespace playhouse::drivers
