#include "playhouse/bridge/simulated/properties.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "playhouse/base/formats.h"
#include "playhouse/base/version.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

static_assert(std::endian::native == std::endian::little, "property values travel in a PC's byte order");

template <typename T>
std::string raw(const T& value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

bool is_color(std::string_view property) {
  return property == "color" || property == "_mp_color";
}

}  // namespace

std::optional<std::string> get_property(const world::World& world, std::string_view model,
                                        std::string_view property) {
  if (model.empty() && property == "build") return wire::c_string(build());
  if (model.empty() && property == "wire_format") return raw(formats::kWireExtensions);
  if (model.empty() && property == "robot_format") return raw(formats::kRobots);
  if (property == "time") return raw(static_cast<std::uint64_t>(std::llround(world.time() * 1e6)));
  const world::ModelRow row = world.find(model);
  if (!row) return std::nullopt;
  if (is_color(property)) {
    const scene::Color& color = world.models.color[row];
    return raw(std::array<float, 4>{color.r, color.g, color.b, color.a});
  }
  if (property == "name") return wire::c_string(world.name(row));
  if (property == "model") return wire::c_string(world.desc(row).type);
  return std::nullopt;
}

bool set_property(world::Journal& journal, std::string_view model, std::string_view property,
                  std::string_view value) {
  std::array<float, 4> rgba{};
  if (!is_color(property) || value.size() != sizeof(rgba)) return false;
  const world::World& world = journal.world();
  const world::ModelRow row = world.find(model);
  if (!row) return false;
  std::memcpy(rgba.data(), value.data(), sizeof(rgba));
  for (float& part : rgba) {
    if (!std::isfinite(part)) return false;
    part = std::clamp(part, 0.0f, 1.0f);
  }
  return journal.apply(world::changes::SetColor{world.id(row), {rgba[0], rgba[1], rgba[2], rgba[3]}});
}

}  // namespace playhouse::drivers
