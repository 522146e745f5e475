#pragma once

/// Addresses of radios: what their file gives them, else what follows from their number.

#include <string>
#include <string_view>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// "02:00:00:xx:yy:zz", by its number, where the file gives none.
std::string mac_of(const world::World& world, world::ModelRow radio);

/// "10.x.y.z", by its number, where the file gives none.
std::string ip_of(const world::World& world, world::ModelRow radio);

/// The first radio of this network address; none if there is no such radio. Looks at all radios.
world::ModelId radio_with_ip(const world::World& world, std::string_view ip);

}  // namespace playhouse::drivers
