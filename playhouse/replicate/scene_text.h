#pragma once

#include <string>
#include <vector>

#include "playhouse/replicate/layout.h"

namespace playhouse::replicate {

/// Per model row, the devices that show it to Player clients, as a person writes them; may end early.
using DeviceNames = std::vector<std::vector<std::string>>;

/// The scene as the JSON text that every viewer gets first: models with their names, types, parents, colours,
/// devices, shapes, sensors and start state (the very numbers of `layout.start`, the first baseline). Equal shapes and
/// equal sets of sensors are written once and named by their place in a list, so that a thousand robots stay
/// small. docs/viewer-protocol.md shows the fields.
std::string scene_text(const world::World& world, const Layout& layout, const DeviceNames& devices);

}  // namespace playhouse::replicate
