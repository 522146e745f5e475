#include "playhouse/stage/march.h"

#include "playhouse/stage/vectors.h"

namespace playhouse::stage {
namespace {

/// The whole number at or below v, |v| < 2 * kFarthest.
inline double floor_small(double v) {
  constexpr double kBias = 65536;
  return static_cast<double>(static_cast<std::int32_t>(v + kBias)) - kBias;
}

inline double within(double v, double low, double high) {
  return v < low ? low : v > high ? high : v;
}

}  // namespace

void March::move(std::size_t from, std::size_t to) {
  for (double* column : {x, y, step_x, step_y, per_x, per_y, cell_x, cell_y, t, hop})
    column[to] = column[from];
  ray[to] = ray[from];
  quadrant[to] = quadrant[from];
}

PLAYHOUSE_VECTORS void begin_march(March& march, std::size_t count, const Vec2& base, double per_metre,
                                   const double* px, const double* py, const double* dx, const double* dy) {
  constexpr double kNever = 1e300;
  const double cell = 1.0 / per_metre, base_x = base.x, base_y = base.y;
  for (std::size_t k = 0; k < count; ++k) {
    march.x[k] = (px[k] - base_x) * per_metre;
    march.y[k] = (py[k] - base_y) * per_metre;
    march.step_x[k] = dx[k] * per_metre;
    march.step_y[k] = dy[k] * per_metre;
    march.per_x[k] = dx[k] == 0 ? kNever : cell / dx[k];
    march.per_y[k] = dy[k] == 0 ? kNever : cell / dy[k];
    march.cell_x[k] = floor_small(march.x[k]);
    march.cell_y[k] = floor_small(march.y[k]);
    march.t[k] = 0;
  }
  for (std::size_t k = 0; k < count; ++k) {
    march.ray[k] = static_cast<std::uint32_t>(k);
    march.quadrant[k] = Walls::quadrant({dx[k], dy[k]});
  }
}

PLAYHOUSE_VECTORS void advance(March& march, std::size_t lanes) {
  const double* __restrict x = march.x, * __restrict y = march.y, * __restrict hops = march.hop;
  const double* __restrict step_x = march.step_x, * __restrict step_y = march.step_y;
  const double* __restrict per_x = march.per_x, * __restrict per_y = march.per_y;
  double* __restrict cell_x = march.cell_x, * __restrict cell_y = march.cell_y, * __restrict at = march.t;
  double next_x[March::kRays], next_y[March::kRays], beside_x[March::kRays], beside_y[March::kRays];
  double t_x[March::kRays], t_y[March::kRays];
  for (std::size_t k = 0; k < lanes; ++k) {
    const double hop = hops[k], cx = cell_x[k], cy = cell_y[k];
    // -1 where the ray goes left or down, else 0.
    const double left = step_x[k] < 0 ? -1.0 : 0.0, down = step_y[k] < 0 ? -1.0 : 0.0;
    const double low_x = cx + left * (hop - 1), low_y = cy + down * (hop - 1);  // the square's first cells
    next_x[k] = cx + hop + 2 * left * hop;
    next_y[k] = cy + hop + 2 * down * hop;
    t_x[k] = (next_x[k] - left - x[k]) * per_x[k];
    t_y[k] = (next_y[k] - down - y[k]) * per_y[k];
    at[k] = t_x[k] < t_y[k] ? t_x[k] : t_y[k];
    beside_x[k] = floor_small(within(x[k] + at[k] * step_x[k], low_x, low_x + hop - 1));
    beside_y[k] = floor_small(within(y[k] + at[k] * step_y[k], low_y, low_y + hop - 1));
  }
  // A loop of its own, or the compiler makes branches of the choices.
  for (std::size_t k = 0; k < lanes; ++k) {
    cell_x[k] = t_x[k] < t_y[k] ? next_x[k] : beside_x[k];
    cell_y[k] = t_x[k] < t_y[k] ? beside_y[k] : next_y[k];
  }
}

}  // namespace playhouse::stage
