#include "playhouse/bridge/interfaces/talk/radio_address.h"

#include <fmt/format.h>

#include <algorithm>

namespace playhouse::drivers {

std::string mac_of(const world::World& world, world::ModelRow radio) {
  const std::string& given = world.desc(radio).wifi->mac;
  if (!given.empty()) return given;
  const std::uint32_t id = world.id(radio).value;
  return fmt::format("02:00:00:{:02x}:{:02x}:{:02x}", id >> 16 & 0xff, id >> 8 & 0xff, id & 0xff);
}

std::string ip_of(const world::World& world, world::ModelRow radio) {
  const std::string& given = world.desc(radio).wifi->ip;
  if (!given.empty()) return given;
  const std::uint32_t id = world.id(radio).value;
  return fmt::format("10.{}.{}.{}", id >> 16 & 0xff, id >> 8 & 0xff, id & 0xff);
}

world::ModelId radio_with_ip(const world::World& world, std::string_view ip) {
  const auto found = std::ranges::find_if(world.wifis.model,
                                          [&](world::ModelRow radio) { return ip_of(world, radio) == ip; });
  return found == world.wifis.model.end() ? world::ModelId{} : world.id(*found);
}

}  // namespace playhouse::drivers
