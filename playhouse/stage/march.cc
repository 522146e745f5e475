#include "playhouse/stage/march.h"

#include "playhouse/stage/space.h"

namespace playhouse::stage {
namespace {

using Cells = FourInts;

/// The whole numbers at or below v.
PLAYHOUSE_INLINE void floor_of(Four& v) {
  double lane[kFour];
  store(lane, v);
  for (std::size_t i = 0; i < kFour; ++i) lane[i] = __builtin_floor(lane[i]);
  load(v, lane);
}

/// Rays in lanes: lengths in cells from a base cell, mirrored so that every ray goes right and up.
struct Lanes {
  static constexpr std::size_t kMost = Rays::kMost;

  double x[kMost], y[kMost];            // origins
  double step_x[kMost], step_y[kMost];  // per metre along the ray
  double per_x[kMost], per_y[kMost];    // metres along the ray per cell; huge for a ray across that axis
  double cell_x[kMost], cell_y[kMost];  // whole numbers: where the rays are
  double t[kMost];                      // m, where they entered those cells
  std::int32_t flip_x[kMost], flip_y[kMost];  // -1 where mirrored: ~c is the cell that c was
  std::int32_t base_x[kMost], base_y[kMost];  // of the torus
  std::int32_t quadrant[kMost];
  std::int32_t place[kMost];  // 4 * index of the cell + quadrant
  std::int32_t hop[kMost];    // cells that they may cross at once
  std::uint32_t ray[kMost];   // whose lane it is

  void copy(std::size_t from, std::size_t to) {
    for (double* column : {x, y, step_x, step_y, per_x, per_y, cell_x, cell_y}) column[to] = column[from];
    for (std::int32_t* column : {flip_x, flip_y, base_x, base_y, quadrant, hop}) column[to] = column[from];
    ray[to] = ray[from];
  }
};

PLAYHOUSE_INLINE void put(const Rays& rays, const Torus& torus, Lanes& lanes) {
  constexpr double kNever = 1e300;
  const double cell = torus.cell(), per_metre = 1.0 / cell;
  for (std::size_t i = 0; i < rays.part_count; ++i) {
    const Rays::Part& part = rays.parts[i];
    const std::int64_t base_x = torus.along(part.about.x), base_y = torus.along(part.about.y);
    const auto x0 = static_cast<double>(base_x) * cell, y0 = static_cast<double>(base_y) * cell;
    const auto wrapped_x = static_cast<std::int32_t>(torus.wrap(base_x)),
               wrapped_y = static_cast<std::int32_t>(torus.wrap(base_y));
    for (std::size_t k = part.begin; k < part.end; ++k) {
      const bool left = rays.dx[k] < 0, down = rays.dy[k] < 0;
      const double dx = left ? -rays.dx[k] : rays.dx[k], dy = down ? -rays.dy[k] : rays.dy[k];
      const double x = (rays.px[k] - x0) * per_metre, y = (rays.py[k] - y0) * per_metre;
      lanes.x[k] = left ? -x : x;
      lanes.y[k] = down ? -y : y;
      lanes.step_x[k] = dx * per_metre;
      lanes.step_y[k] = dy * per_metre;
      lanes.per_x[k] = dx == 0 ? kNever : cell / dx;
      lanes.per_y[k] = dy == 0 ? kNever : cell / dy;
      lanes.t[k] = 0;
      lanes.flip_x[k] = left ? -1 : 0;
      lanes.flip_y[k] = down ? -1 : 0;
      lanes.base_x[k] = wrapped_x;
      lanes.base_y[k] = wrapped_y;
      lanes.quadrant[k] = (left ? 1 : 0) + (down ? 2 : 0);
      lanes.ray[k] = static_cast<std::uint32_t>(k);
    }
  }
}

/// Finds the place of four rays from their cells.
PLAYHOUSE_INLINE void find_place(const Torus& torus, std::size_t k, const Four& cell_x, const Four& cell_y,
                                 Lanes& lanes) {
  const auto mask = static_cast<std::int32_t>(torus.side() - 1);
  Cells flip_x, flip_y, base_x, base_y, quadrant;
  load(flip_x, lanes.flip_x + k);
  load(flip_y, lanes.flip_y + k);
  load(base_x, lanes.base_x + k);
  load(base_y, lanes.base_y + k);
  load(quadrant, lanes.quadrant + k);
  const Cells x = ((__builtin_convertvector(cell_x, Cells) ^ flip_x) + base_x) & mask;
  const Cells y = ((__builtin_convertvector(cell_y, Cells) ^ flip_y) + base_y) & mask;
  store(lanes.cell_x + k, cell_x);
  store(lanes.cell_y + k, cell_y);
  store(lanes.place + k, (((y << static_cast<int>(torus.bits())) + x) << 2) + quadrant);
}

PLAYHOUSE_INLINE void begin(const Torus& torus, std::size_t count, Lanes& lanes) {
  for (std::size_t k = 0; k < count; k += kFour) {
    Four x, y;
    load(x, lanes.x + k);
    load(y, lanes.y + k);
    floor_of(x);
    floor_of(y);
    find_place(torus, k, x, y, lanes);
  }
}

/// Moves the rays to where they leave the square of their hop.
PLAYHOUSE_INLINE void advance(const Torus& torus, std::size_t count, Lanes& lanes) {
  for (std::size_t k = 0; k < count; k += kFour) {
    Four x, y, step_x, step_y, per_x, per_y, cell_x, cell_y;
    Cells hops;
    load(x, lanes.x + k);
    load(y, lanes.y + k);
    load(step_x, lanes.step_x + k);
    load(step_y, lanes.step_y + k);
    load(per_x, lanes.per_x + k);
    load(per_y, lanes.per_y + k);
    load(cell_x, lanes.cell_x + k);
    load(cell_y, lanes.cell_y + k);
    load(hops, lanes.hop + k);
    hops = hops > 0 ? hops : 1;
    const Four hop = __builtin_convertvector(hops, Four);
    const Four next_x = cell_x + hop, next_y = cell_y + hop;
    const Four t_x = (next_x - x) * per_x, t_y = (next_y - y) * per_y;
    const Four t = t_x < t_y ? t_x : t_y;
    Four beside_x = x + t * step_x, beside_y = y + t * step_y;
    floor_of(beside_x);
    floor_of(beside_y);
    beside_x = beside_x < cell_x ? cell_x : beside_x;  // rounding must not take it back
    beside_y = beside_y < cell_y ? cell_y : beside_y;
    store(lanes.t + k, t);
    find_place(torus, k, t_x < t_y ? next_x : beside_x, t_x < t_y ? beside_y : next_y, lanes);
  }
}

/// Keeps the nearer of what is known about ray k and the edges. Without branches: nobody can foretell what is
/// hit.
PLAYHOUSE_INLINE void meet(const Walls::Group& group, std::size_t k, Rays& rays) {
  const double px = rays.px[k], py = rays.py[k], dx = rays.dx[k], dy = rays.dy[k];
  const Four range = {rays.range[k], rays.range[k], rays.range[k], rays.range[k]};
  const Four seen = {group.ranger_return}, known = {rays.intensity[k]};
  Four ax, ay, bx, by;
  load(ax, group.ax);
  load(ay, group.ay);
  load(bx, group.bx);
  load(by, group.by);
  ax -= px;
  ay -= py;
  bx -= px;
  by -= py;
  const Four s0 = dx * ay - dy * ax, s1 = dx * by - dy * bx;
  Four t = (ax * by - ay * bx) / (s1 - s0);
  const auto met = (s0 * s1 <= 0) & (t >= 0) & (t < range);
  t = met ? t : range;
  const Four across = __builtin_shufflevector(t, t, 2, 3, 0, 1);
  t = t < across ? t : across;
  const Four beside = __builtin_shufflevector(t, t, 1, 0, 3, 2);
  t = t < beside ? t : beside;
  rays.range[k] = t[0];
  rays.intensity[k] = (t < range ? seen : known)[0];
}

}  // namespace

PLAYHOUSE_VECTORS void march(const Walls& walls, Rays& rays) {
  const Torus& torus = walls.torus();
  std::size_t count = rays.count;
  Lanes lanes;
  put(rays, torus, lanes);
  const std::uint8_t* const clearances = walls.clearances();
  std::uint32_t on[Lanes::kMost], touch[Lanes::kMost];  // lanes of rays that go on, that are where edges are
  for (std::size_t k = 0; k < count; ++k) on[k] = static_cast<std::uint32_t>(k);
  for (std::size_t k = count; k < (count + kFour - 1) / kFour * kFour; ++k) lanes.copy(0, k);
  begin(torus, count, lanes);
  for (std::size_t used = count; count > 0;) {
    std::size_t left = 0, touches = 0;
    for (std::size_t i = 0; i < count; ++i) {  // without branches: nobody can foretell where they end
      const std::uint32_t lane = on[i];
      const bool goes_on = lanes.t[lane] <= rays.range[lanes.ray[lane]];
      const std::int32_t clearance = clearances[lanes.place[lane]];
      lanes.hop[lane] = clearance;
      on[left] = touch[touches] = lane;
      left += goes_on;
      touches += goes_on & (clearance == 0);
    }
    count = left;
    for (std::size_t i = 0; i < touches; ++i) {
      const std::uint32_t k = lanes.ray[touch[i]];
      for (const Walls::Group& group : walls.in_cell(static_cast<std::size_t>(lanes.place[touch[i]]) >> 2))
        if (group.ranger_return >= 0 && group.z_min <= rays.z[k] && rays.z[k] <= group.z_max)
          meet(group, k, rays);
    }
    if (2 * count <= used) {
      for (std::size_t i = 0; i < count; ++i) {
        lanes.copy(on[i], i);
        on[i] = static_cast<std::uint32_t>(i);
      }
      used = count;
    }
    advance(torus, used, lanes);
  }
}

}  // namespace playhouse::stage
