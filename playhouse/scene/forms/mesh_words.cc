#include "playhouse/scene/forms/mesh_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/text/read_word.h"

namespace playhouse::scene {
namespace {

constexpr std::string_view kPose = "mesh_pose", kScale = "mesh_scale", kFit = "mesh_fit";
constexpr double kLeastScale = 1e-6, kMostScale = 1e6;
constexpr double kSmall = 1e-3, kLarge = 100;  // m; extents of no mesh for robots

/// One number for all axes, or three.
geom::Vec3 read_scale(const Properties& properties) {
  double scale[3] = {1, 1, 1};
  const config::Field* const field = properties.fields().find(kScale);
  if (field && field->values.size() == 1) {
    std::ranges::fill(scale, properties.number(kScale, 1));
  } else {
    properties.tuple(kScale, "NNN", scale, "a number or [x y z]");
  }
  const auto is_good = [](double s) { return std::fabs(s) >= kLeastScale && std::fabs(s) <= kMostScale; };
  require(std::ranges::all_of(scale, is_good), properties, kScale,
          "takes numbers from 0.000001 to 1000000, below 0 for what is mirrored");
  return {scale[0], scale[1], scale[2]};
}

}  // namespace

mesh::Placement read_placement(const Properties& properties) {
  double pose[6] = {};
  properties.tuple(kPose, "LLLAAA", pose, "[x y z roll pitch yaw]");
  const mesh::Placement at{{pose[0], pose[1], pose[2]},
                           {pose[3], pose[4], pose[5]},
                           read_scale(properties),
                           properties.flag(kFit, true)};
  if (at.is_fitted && at.p != geom::Vec3())
    properties.state().warnings.add(
        config::Warning::kNoEffect, properties.where(kPose),
        "the place in \"mesh_pose\" has no effect on a fitted mesh, which is in the middle of its body: "
        "mesh_fit 0 keeps it");
  return at;
}

void write_placement(const mesh::Placement& at, Words& words) {
  const mesh::Placement plain;
  if (at.p != plain.p || at.turn != plain.turn)
    words.tuple(kPose, "LLLAAA", std::array{at.p.x, at.p.y, at.p.z, at.turn.x, at.turn.y, at.turn.z});
  if (at.scale != plain.scale) words.tuple(kScale, "NNN", std::array{at.scale.x, at.scale.y, at.scale.z});
  if (at.is_fitted != plain.is_fitted) words.flag(kFit, at.is_fitted);
}

void warn_without_mesh(const Properties& properties) {
  if (read_placement(properties) == mesh::Placement()) return;
  for (const std::string_view key : {kPose, kScale, kFit})
    if (properties.has(key))
      properties.state().warnings.add(config::Warning::kNoEffect, properties.where(key),
                                      in_quotes(key) + " has no effect without \"mesh\"");
}

void warn_of_extent(const Properties& properties, const std::string& path, const geom::Vec3& extent) {
  const double most = std::max({extent.x, extent.y, extent.z});
  if (properties.has(kScale) || (most >= kSmall && most <= kLarge)) return;
  properties.state().warnings.add(
      config::Warning::kShape, properties.where("mesh"),
      fmt::format("mesh {} is {:.4g} x {:.4g} x {:.4g} m large: mesh_scale says in which unit it is (0.001: "
                  "millimetres)",
                  in_quotes(path), extent.x, extent.y, extent.z));
}

}  // namespace playhouse::scene
