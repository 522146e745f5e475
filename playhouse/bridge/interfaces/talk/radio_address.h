#pragma once

/// Network addresses of radios: from the world file, otherwise derived from the radio's number.

#include <string>
#include <string_view>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// "02:00:00:xx:yy:zz" unless the file gives an address.
std::string mac_of(const world::World& world, world::ModelRow radio);

/// "10.x.y.z" unless the file gives an address.
std::string ip_of(const world::World& world, world::ModelRow radio);

/// The first radio with this IP address; none if there is none. Linear in the number of radios.
world::ModelId radio_with_ip(const world::World& world, std::string_view ip);

}  // namespace playhouse::drivers
