#pragma once

/// March: many rays from about one place through the cells of the walls, all a step at a time, so that no ray
/// waits for another's memory and the arithmetic is done in vectors. Visits what Walls::along would.

#include "playhouse/stage/walls.h"

namespace playhouse::stage {

/// Up to kRays rays in lanes; lengths in cells, relative to a base cell.
struct March {
  static constexpr std::size_t kRays = 64;
  static constexpr double kFarthest = 30000;  // cells; rays that reach further go one by one (Walls::along)

  double x[kRays], y[kRays];            // origins
  double step_x[kRays], step_y[kRays];  // per metre along the ray
  double per_x[kRays], per_y[kRays];    // metres along the ray per cell; huge for a ray across that axis
  double cell_x[kRays], cell_y[kRays];  // whole numbers: where the rays are
  double t[kRays];                      // m, where they entered those cells
  double hop[kRays];                    // cells that they may cross at once
  std::uint32_t ray[kRays];             // whose lane it is
  std::uint32_t quadrant[kRays];        // it goes to

  void move(std::size_t from, std::size_t to);
};

/// Puts the rays at their origins. The base cell's corner is at `base`.
void begin_march(March& march, std::size_t count, const Vec2& base, double per_metre, const double* px,
                 const double* py, const double* dx, const double* dy);

/// Moves the rays to where they leave the square of their hop.
void advance(March& march, std::size_t lanes);

/// Calls visit(k, edges) for the edges of each cell along the rays, each until its range[k] is passed; visit
/// may shorten it.
template <typename Visit>
void march_along(const Walls& walls, std::size_t count, Vec2 about, const double* px, const double* py,
                 const double* dx, const double* dy, const double* range, const Visit& visit) {
  const Torus& torus = walls.torus();
  const std::int64_t base_x = torus.along(about.x), base_y = torus.along(about.y);
  March march;
  begin_march(march, count,
              {static_cast<double>(base_x) * torus.cell(), static_cast<double>(base_y) * torus.cell()},
              1.0 / torus.cell(), px, py, dx, dy);
  for (std::size_t lanes = count; lanes > 0;) {
    std::size_t on = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::uint32_t k = march.ray[lane];
      if (march.t[lane] > range[k]) continue;
      const std::size_t index = torus.index(base_x + static_cast<std::int64_t>(march.cell_x[lane]),
                                            base_y + static_cast<std::int64_t>(march.cell_y[lane]));
      const int clearance = walls.clearance(march.quadrant[lane], index);
      march.hop[lane] = clearance > 1 ? clearance : 1;
      if (clearance == 0) visit(k, walls.in_cell(index));
      if (on < lane) march.move(lane, on);
      ++on;
    }
    lanes = on;
    advance(march, lanes);
  }
}

}  // namespace playhouse::stage
