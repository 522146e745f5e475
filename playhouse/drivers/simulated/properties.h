#pragma once

/// Properties of models that clients of interface simulation read and write by name. Values are raw bytes,
/// numbers in the order of bytes of a PC (little-endian), as existing clients put them there from memory.

#include <optional>
#include <string>
#include <string_view>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// The value of a property; none if there is no such property or model.
///   "color"  four float32: red, green, blue, alpha in 0..1     "time"   uint64: simulated time [us]; of any
///   model "name"   text, with its NUL                                "model"  its type as the world file
///   says, with its NUL
std::optional<std::string> get_property(const world::World& world, std::string_view model,
                                        std::string_view property);

/// Only "color" can be set. False: no such property or model, or the value has the wrong size.
bool set_property(world::World& world, std::string_view model, std::string_view property,
                  std::string_view value);

}  // namespace playhouse::drivers
