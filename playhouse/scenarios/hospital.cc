#include "playhouse/scenarios/hospital.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "playhouse/base/assert.h"
#include "playhouse/scenarios/start_poses.h"

namespace playhouse::scenarios {
namespace {

constexpr double kWall = 0.1;         // m
constexpr double kStartX[] = {1, 3};  // m, in a ward
constexpr double kStartY[] = {1.2, 3.6, 5.4, 6.6, 8.4, 10.8};
constexpr double kStartJitter = 0.25;  // m
constexpr std::size_t kRobotsOfWard = std::size(kStartX) * std::size(kStartY);

/// Walls of a ward [dm]: outer ones, those shared with the ward on the left,
/// and those of the corridor, 2.4 m wide, with a door of 1 m to each room.
struct Wall {
  int x, y, x_end, y_end;
};
constexpr Wall kWalls[] = {{0, 0, 40, 1},   {0, 119, 40, 120}, {0, 1, 1, 47},   {0, 73, 1, 119},
                           {0, 47, 15, 48}, {25, 47, 40, 48},  {0, 72, 15, 73}, {25, 72, 40, 73}};

std::string ward() {
  std::string text = fmt::format("model\n(\n  name \"room\"\n  color \"DimGray\"\n  size [{} {} 2.5]\n",
                                 kWardWidth, kWardDepth);
  for (const auto& [x, y, x_end, y_end] : kWalls)
    fmt::format_to(std::back_inserter(text),
                   "  block( points 4 point[0] [{0} {1}] point[1] [{2} {1}] point[2] [{2} {3}] point[3] [{0} "
                   "{3}] z [0 1] )\n",
                   x, y, x_end, y_end);
  return text + ")\n";
}

/// The lower left corner of a ward. [m]
geom::Vec2 corner(const Wards& wards, std::size_t column, std::size_t row) {
  return {(static_cast<double>(column) - static_cast<double>(wards.columns) / 2) * kWardWidth,
          (static_cast<double>(row) - static_cast<double>(wards.rows) / 2) * kWardDepth};
}

}  // namespace

Wards wards_for(std::size_t robots) {
  const std::size_t wards = (robots + kRobotsOfWard - 1) / kRobotsOfWard;
  const double side = std::sqrt(static_cast<double>(wards) * kWardWidth * kWardDepth);
  const std::size_t rows = std::max<std::size_t>(1, static_cast<std::size_t>(side / kWardDepth));
  return {(wards + rows - 1) / rows, rows};
}

std::vector<geom::Pose> places_of(const Wards& wards) {
  std::vector<geom::Pose> places;
  for (std::size_t row = 0; row < wards.rows; ++row)
    for (std::size_t column = 0; column < wards.columns; ++column) {
      const geom::Vec2 at = corner(wards, column, row);
      places.push_back({at.x + kWardWidth / 2, at.y + kWardDepth / 2, 0, 0});
    }
  return places;
}

std::string walls_of(const Wards& wards) {
  std::string text;
  const double x = corner(wards, wards.columns, 0).x + kWall / 2;
  const double depth = static_cast<double>(wards.rows) * kWardDepth;
  for (const double end : {-x, x})
    fmt::format_to(std::back_inserter(text), "model( color \"DimGray\" pose [{} 0 0 0] size [{} {} 2.5] )\n",
                   end, kWall, depth);
  return text + ward();
}

std::vector<geom::Pose> in_wards(std::size_t robots, const Wards& wards) {
  PLAYHOUSE_ASSERT(robots <= wards.columns * wards.rows * kRobotsOfWard);
  std::vector<geom::Vec2> spots;
  spots.reserve(robots);
  for (std::size_t k = 0; k < robots; ++k) {
    const std::size_t ward = k / kRobotsOfWard, spot = k % kRobotsOfWard;
    const geom::Vec2 at = corner(wards, ward % wards.columns, ward / wards.columns);
    spots.push_back({at.x + kStartX[spot % std::size(kStartX)], at.y + kStartY[spot / std::size(kStartX)]});
  }
  return about(spots, kStartJitter);
}

}  // namespace playhouse::scenarios
