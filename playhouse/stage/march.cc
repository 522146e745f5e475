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
  static constexpr std::size_t kMost = Rays::kRoom;

  double x[kMost], y[kMost];            // origins
  double step_x[kMost], step_y[kMost];  // per metre along the ray
  double per_x[kMost], per_y[kMost];    // metres along the ray per cell; huge for a ray across that axis
  double cell_x[kMost], cell_y[kMost];  // whole numbers: where the rays are
  double range[kMost];                  // m, of the rays
  std::int32_t flip_x[kMost], flip_y[kMost];  // -1 where mirrored: ~c is the cell that c was
  std::int32_t base_x[kMost], base_y[kMost];  // of the torus
  std::int32_t quadrant[kMost];
  std::int32_t place[kMost];  // 4 * index of the cell + quadrant; -1 where a ray has ended
  std::int32_t hop[kMost];    // cells that they may cross at once
  std::uint32_t ray[kMost];   // whose lane it is

  void copy(std::size_t from, std::size_t to) {
    for (double* column : {x, y, step_x, step_y, per_x, per_y, cell_x, cell_y, range})
      column[to] = column[from];
    for (std::int32_t* column : {flip_x, flip_y, base_x, base_y, quadrant, hop}) column[to] = column[from];
    ray[to] = ray[from];
  }
};

/// Signs of four numbers: -1 for those below 0, else 0.
PLAYHOUSE_INLINE Cells below_zero(const Four& v) {
  using Halves = std::int32_t __attribute__((vector_size(2 * sizeof(Cells))));
  const auto below = v < 0;
  Halves halves;
  std::memcpy(&halves, &below, sizeof halves);
  return __builtin_shufflevector(halves, halves, 0, 2, 4, 6);
}

/// One axis of four rays that start at p, base cells being at `base`.  [m]
PLAYHOUSE_INLINE Cells put_axis(const double* p, const double* d, double base, double cell, double* x,
                                double* step, double* per) {
  constexpr double kNever = 1e300;
  Four at, ahead;
  load(at, p);
  load(ahead, d);
  const Cells flip = below_zero(ahead);
  at = (at - base) * (1.0 / cell);
  at = ahead < 0 ? -at : at;
  ahead = ahead < 0 ? -ahead : ahead;
  store<Four>(x, at);
  store<Four>(step, ahead * (1.0 / cell));
  store<Four>(per, ahead == 0 ? kNever : cell / ahead);
  return flip;
}

/// Puts the rays of a part into lanes; those after them are overwritten.
PLAYHOUSE_INLINE void put(const Rays& rays, const Rays::Part& part, const Torus& torus, Lanes& lanes) {
  const double cell = torus.cell();
  const std::int64_t base_x = torus.along(part.about.x), base_y = torus.along(part.about.y);
  const double x0 = static_cast<double>(base_x) * cell, y0 = static_cast<double>(base_y) * cell;
  const Cells none = {0, 0, 0, 0};
  for (std::size_t k = part.begin; k < part.end; k += kFour) {
    const Cells left =
        put_axis(rays.px + k, rays.dx + k, x0, cell, lanes.x + k, lanes.step_x + k, lanes.per_x + k);
    const Cells down =
        put_axis(rays.py + k, rays.dy + k, y0, cell, lanes.y + k, lanes.step_y + k, lanes.per_y + k);
    store(lanes.flip_x + k, left);
    store(lanes.flip_y + k, down);
    store<Cells>(lanes.base_x + k, none + static_cast<std::int32_t>(torus.wrap(base_x)));
    store<Cells>(lanes.base_y + k, none + static_cast<std::int32_t>(torus.wrap(base_y)));
    store<Cells>(lanes.quadrant + k, -left - 2 * down);
    for (std::size_t i = k; i < k + kFour; ++i) {
      lanes.range[i] = rays.range[i];
      lanes.ray[i] = static_cast<std::uint32_t>(i);
    }
  }
}

/// Finds the place of four rays from their cells, which they enter at t.  [m]
PLAYHOUSE_INLINE void find_place(const Torus& torus, std::size_t k, const Four& cell_x, const Four& cell_y,
                                 const Four& t, Lanes& lanes) {
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
  Four range;
  load(range, lanes.range + k);
  const Cells ended = below_zero(range - t);
  store<Cells>(lanes.place + k, ((((y << static_cast<int>(torus.bits())) + x) << 2) + quadrant) | ended);
}

PLAYHOUSE_INLINE void begin(const Torus& torus, std::size_t count, Lanes& lanes) {
  for (std::size_t k = 0; k < count; k += kFour) {
    Four x, y;
    load(x, lanes.x + k);
    load(y, lanes.y + k);
    floor_of(x);
    floor_of(y);
    find_place(torus, k, x, y, Four{0, 0, 0, 0}, lanes);
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
    find_place(torus, k, t_x < t_y ? next_x : beside_x, t_x < t_y ? beside_y : next_y, t, lanes);
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
  for (std::size_t i = 0; i < rays.part_count; ++i) put(rays, rays.parts[i], torus, lanes);
  const std::uint8_t* const clearances = walls.clearances();
  std::uint32_t on[Lanes::kMost], touch[Lanes::kMost];  // lanes of rays that go on, that are where edges are
  for (std::size_t k = 0; k < count; ++k) on[k] = static_cast<std::uint32_t>(k);
  lanes.hop[0] = 1;  // which the lanes that fill up the last four keep
  for (std::size_t k = count; k < (count + kFour - 1) / kFour * kFour; ++k) lanes.copy(0, k);
  begin(torus, count, lanes);
  for (std::size_t used = count; count > 0;) {
    std::size_t left = 0, touches = 0;
    for (std::size_t i = 0; i < count; ++i) {  // without branches: nobody can foretell where they end
      const std::uint32_t lane = on[i];
      const std::int32_t place = lanes.place[lane], clearance = clearances[place];
      lanes.hop[lane] = clearance;
      on[left] = touch[touches] = lane;
      left += place >= 0;
      touches += clearance == 0;
    }
    count = left;
    for (std::size_t i = 0; i < touches; ++i) {
      const std::uint32_t lane = touch[i], k = lanes.ray[lane];
      for (const Walls::Group& group : walls.in_cell(static_cast<std::size_t>(lanes.place[lane]) >> 2))
        if (group.z_min <= rays.z[k] && rays.z[k] <= group.z_max) meet(group, k, rays);
      lanes.range[lane] = rays.range[k];
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
