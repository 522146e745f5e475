#include "playhouse/rays/march.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/ray_edge.h"

namespace playhouse::rays {
namespace {

/// Floor of each lane.
PLAYHOUSE_INLINE void floor_of(simd::Float8& v) {
  float lane[simd::kEight];
  simd::store(lane, v);
  for (std::size_t i = 0; i < simd::kEight; ++i) lane[i] = __builtin_floorf(lane[i]);
  simd::load(v, lane);
}

/// Rays in lanes: lengths in cells relative to a base cell, mirrored so that all rays go in +x, +y.
struct Lanes {
  static constexpr std::size_t kMost = Rays::kRoom;

  float x[kMost], y[kMost];            // origins
  float step_x[kMost], step_y[kMost];  // per metre along the ray
  float per_x[kMost], per_y[kMost];    // metres along the ray per cell; huge for a ray across that axis
  float cell_x[kMost], cell_y[kMost];  // whole numbers: current cells of the rays
  float range[kMost];                  // m, of the rays
  std::int32_t flip_x[kMost], flip_y[kMost];  // -1 if mirrored: ~c is the original cell index
  std::int32_t base_x[kMost], base_y[kMost];  // of the torus
  std::int32_t quadrant[kMost];
  std::int32_t place[kMost];  // 4 * cell index + quadrant; -1 once a ray has ended
  std::int32_t hop[kMost];    // empty cells that can be skipped
  std::uint32_t ray[kMost];   // index of the ray in this lane

  void copy(std::size_t from, std::size_t to) {
    for (float* column : {x, y, step_x, step_y, per_x, per_y, cell_x, cell_y, range})
      column[to] = column[from];
    for (std::int32_t* column : {flip_x, flip_y, base_x, base_y, quadrant, hop}) column[to] = column[from];
    ray[to] = ray[from];
  }
};

/// Sets the origins of the rays of a part in the lanes from `at` on, not mirrored yet.
PLAYHOUSE_INLINE void put_origins(const Rays& rays, const Rays::NearRays& part, const bodies::Torus& torus,
                                  std::size_t at, Lanes& lanes) {
  const double cell = torus.cell(), per_metre = 1.0 / cell;
  const std::int64_t base_x = torus.along(part.about.x), base_y = torus.along(part.about.y);
  const double x0 = static_cast<double>(base_x) * cell, y0 = static_cast<double>(base_y) * cell;
  const auto wrapped_x = static_cast<std::int32_t>(torus.wrap(base_x)),
             wrapped_y = static_cast<std::int32_t>(torus.wrap(base_y));
  const double *px = rays.px + part.begin, *py = rays.py + part.begin;
  for (std::size_t i = 0; i < part.end - part.begin; ++i) {
    lanes.x[at + i] = static_cast<float>((px[i] - x0) * per_metre);
    lanes.y[at + i] = static_cast<float>((py[i] - y0) * per_metre);
    lanes.base_x[at + i] = wrapped_x;
    lanes.base_y[at + i] = wrapped_y;
    lanes.ray[at + i] = static_cast<std::uint32_t>(part.begin + i);
  }
}

/// Mirrors one axis of a ray with origin *x and direction component d.
PLAYHOUSE_INLINE std::int32_t put_axis(double d, float cell, float per_metre, float* x, float* step,
                                       float* per) {
  constexpr float kNever = 1e30f;
  const auto along = static_cast<float>(d), ahead = std::fabs(along), cells = cell / ahead;
  *x = along < 0 ? -*x : *x;
  *step = ahead * per_metre;
  *per = cells < kNever ? cells : kNever;
  return along < 0 ? -1 : 0;
}

PLAYHOUSE_INLINE void put_directions(const Rays& rays, const Rays::NearRays& part, const bodies::Torus& torus,
                                     std::size_t at, Lanes& lanes) {
  const auto cell = static_cast<float>(torus.cell()), per_metre = static_cast<float>(1.0 / torus.cell());
  for (std::size_t i = part.begin, k = at; i < part.end; ++i, ++k) {
    const std::int32_t left =
        put_axis(rays.dx[i], cell, per_metre, lanes.x + k, lanes.step_x + k, lanes.per_x + k);
    const std::int32_t down =
        put_axis(rays.dy[i], cell, per_metre, lanes.y + k, lanes.step_y + k, lanes.per_y + k);
    lanes.flip_x[k] = left;
    lanes.flip_y[k] = down;
    lanes.quadrant[k] = -left - 2 * down;
    lanes.range[k] = static_cast<float>(rays.range[i]);
  }
}

/// Lanes whose current cell has edges, and the number of active rays.
struct Found {
  std::uint32_t touch[Lanes::kMost];
  std::size_t touches = 0;
  simd::Int8 active = {};  // by lane modulo eight

  std::size_t going_on() const {
    return static_cast<std::size_t>((active[0] + active[1]) + (active[2] + active[3]) +
                                    (active[4] + active[5]) + (active[6] + active[7]));
  }
};

/// Looks up the cells of eight rays, entered at t: which have edges, which are empty.  [m]
PLAYHOUSE_INLINE void look(const bodies::Torus& torus, const std::uint8_t* clearances, std::size_t k,
                           const simd::Float8& cell_x, const simd::Float8& cell_y, const simd::Float8& t,
                           Lanes& lanes, Found& found) {
  const auto mask = static_cast<std::int32_t>(torus.side() - 1);
  simd::Int8 flip_x, flip_y, base_x, base_y, quadrant;
  simd::load(flip_x, lanes.flip_x + k);
  simd::load(flip_y, lanes.flip_y + k);
  simd::load(base_x, lanes.base_x + k);
  simd::load(base_y, lanes.base_y + k);
  simd::load(quadrant, lanes.quadrant + k);
  const simd::Int8 x = ((__builtin_convertvector(cell_x, simd::Int8) ^ flip_x) + base_x) & mask;
  const simd::Int8 y = ((__builtin_convertvector(cell_y, simd::Int8) ^ flip_y) + base_y) & mask;
  simd::store(lanes.cell_x + k, cell_x);
  simd::store(lanes.cell_y + k, cell_y);
  simd::Float8 range;
  simd::load(range, lanes.range + k);
  const simd::Int8 ended = range < t;
  simd::store<simd::Int8>(lanes.place + k,
                          ((((y << static_cast<int>(torus.bits())) + x) << 2) + quadrant) | ended);
  found.active += ended + 1;
  for (std::size_t lane = k; lane < k + simd::kEight; ++lane) {  // branch-free: hits are unpredictable
    const std::int32_t clearance = clearances[lanes.place[lane]];
    lanes.hop[lane] = clearance;
    found.touch[found.touches] = static_cast<std::uint32_t>(lane);
    found.touches += clearance == 0;
  }
}

PLAYHOUSE_INLINE void begin(const bodies::Walls& walls, std::size_t count, Lanes& lanes, Found& found) {
  for (std::size_t k = 0; k < count; k += simd::kEight) {
    simd::Float8 x, y;
    simd::load(x, lanes.x + k);
    simd::load(y, lanes.y + k);
    floor_of(x);
    floor_of(y);
    look(walls.torus(), walls.clearances(), k, x, y, simd::Float8{}, lanes, found);
  }
}

/// Advances the rays to where they leave their empty square.
PLAYHOUSE_INLINE void advance(const bodies::Walls& walls, std::size_t count, Lanes& lanes, Found& found) {
  for (std::size_t k = 0; k < count; k += simd::kEight) {
    simd::Float8 x, y, step_x, step_y, per_x, per_y, cell_x, cell_y;
    simd::Int8 hops;
    simd::load(x, lanes.x + k);
    simd::load(y, lanes.y + k);
    simd::load(step_x, lanes.step_x + k);
    simd::load(step_y, lanes.step_y + k);
    simd::load(per_x, lanes.per_x + k);
    simd::load(per_y, lanes.per_y + k);
    simd::load(cell_x, lanes.cell_x + k);
    simd::load(cell_y, lanes.cell_y + k);
    simd::load(hops, lanes.hop + k);
    hops = hops > 1 ? hops : 1;
    const simd::Float8 hop = __builtin_convertvector(hops, simd::Float8);
    const simd::Float8 next_x = cell_x + hop, next_y = cell_y + hop;
    const simd::Float8 t_x = (next_x - x) * per_x, t_y = (next_y - y) * per_y;
    const simd::Float8 t = t_x < t_y ? t_x : t_y;
    simd::Float8 beside_x = x + t * step_x, beside_y = y + t * step_y;
    floor_of(beside_x);
    floor_of(beside_y);
    beside_x = beside_x < cell_x ? cell_x : beside_x;  // keeps progress monotonic despite rounding
    beside_y = beside_y < cell_y ? cell_y : beside_y;
    look(walls.torus(), walls.clearances(), k, t_x < t_y ? next_x : beside_x, t_x < t_y ? beside_y : next_y,
         t, lanes, found);
  }
}

/// Compacts the active rays: copies those that are late to where rays have ended.
PLAYHOUSE_INLINE void compact(std::size_t active, std::size_t used, Lanes& lanes) {
  std::uint32_t free[Lanes::kMost], late[Lanes::kMost];
  std::size_t gaps = 0, moves = 0;
  for (std::size_t i = 0; i < active; ++i) {
    free[gaps] = static_cast<std::uint32_t>(i);
    gaps += lanes.place[i] < 0;
  }
  for (std::size_t i = active; i < used; ++i) {
    late[moves] = static_cast<std::uint32_t>(i);
    moves += lanes.place[i] >= 0;
  }
  for (std::size_t i = 0; i < moves; ++i) lanes.copy(late[i], free[i]);
}

/// Pads the last vector with an ended ray.
PLAYHOUSE_INLINE void pad(std::size_t count, Lanes& lanes) {
  for (std::size_t k = count; k % simd::kEight != 0; ++k) {
    lanes.copy(0, k);
    lanes.range[k] = -1;
  }
}

/// The distance at which a ray hits the nearest edge of a group, scalar.
[[gnu::noinline]] double edges_alone(const bodies::Walls::Group& group, geom::Vec2 p, geom::Vec2 d) {
  double first = bodies::kMiss;
  for (std::uint32_t i = 0; i < group.count; ++i)
    first = std::min(first, bodies::edge_hit(group.edge(i).a - p, group.edge(i).b - p, d));
  return first;
}

/// Shortens ray k by its hits with a group, except edges seen edge-on: those are left to the scalar path.
/// Branch-free: hits are unpredictable.
PLAYHOUSE_INLINE void meet(const bodies::Walls::Group& group, std::size_t k, simd::Mask4& edge_on,
                           Rays& rays) {
  const double px = rays.px[k], py = rays.py[k];
  simd::Double4 ax, ay, bx, by;
  simd::load(ax, group.x);
  simd::load(ay, group.y);
  simd::load(bx, group.x + 1);
  simd::load(by, group.y + 1);
  const bodies::Distance<double, simd::Double4> met(rays.dx[k], rays.dy[k], ax - px, ay - py, bx - px,
                                                    by - py);
  edge_on |= met.edge_on;
  const simd::Double4 across = __builtin_shufflevector(met.t, met.t, 2, 3, 0, 1);
  simd::Double4 t = met.t < across ? met.t : across;
  const simd::Double4 beside = __builtin_shufflevector(t, t, 1, 0, 3, 2);
  t = t < beside ? t : beside;
  bodies::keep_first_alone(t[0], bodies::number_of(group.solid), rays.range[k], rays.solid[k]);
}

/// Calls meet(group, k) for every ray in a cell with edges, and updates its range.
template <typename Meet>
PLAYHOUSE_INLINE void each_touch(const bodies::Walls& walls, bodies::SeenByBits by, const Found& found,
                                 const Rays& rays, Lanes& lanes, const Meet& meet) {
  for (std::size_t i = 0; i < found.touches; ++i) {
    const std::uint32_t lane = found.touch[i], k = lanes.ray[lane];
    for (const bodies::Walls::Group& group : walls.in_cell(static_cast<std::size_t>(lanes.place[lane]) >> 2))
      if (group.z_min <= rays.z[k] && rays.z[k] <= group.z_max && (group.seen_by & by) != 0) meet(group, k);
    lanes.range[lane] = static_cast<float>(rays.range[k]);
  }
}

PLAYHOUSE_INLINE void march_here(const bodies::Walls& walls, bodies::SeenByBits by, Rays& rays) {
  Lanes lanes;
  std::size_t used = 0;
  for (std::size_t i = 0; i < rays.part_count; ++i) {
    const Rays::NearRays part = rays.parts[i];
    put_origins(rays, part, walls.torus(), used, lanes);
    put_directions(rays, part, walls.torus(), used, lanes);
    used += part.end - part.begin;
  }
  lanes.hop[0] = 1;
  pad(used, lanes);
  Found found;
  begin(walls, used, lanes, found);
  while (const std::size_t active = found.going_on()) {
    simd::Mask4 edge_on = {};
    each_touch(walls, by, found, rays, lanes,
               [&](const bodies::Walls::Group& group, std::size_t k) { meet(group, k, edge_on, rays); });
    if (simd::any(edge_on))
      each_touch(walls, by, found, rays, lanes, [&](const bodies::Walls::Group& group, std::size_t k) {
        const double t = edges_alone(group, rays.p(k), rays.d(k));
        bodies::keep_first_alone(t, bodies::number_of(group.solid), rays.range[k], rays.solid[k]);
      });
    if (2 * active <= used) {
      compact(active, used, lanes);
      used = active;
      pad(used, lanes);
    }
    found.touches = 0;
    found.active = simd::Int8{};
    advance(walls, used, lanes, found);
  }
}

}  // namespace

void march(const bodies::Walls& walls, bodies::SeenByBits by, Rays& rays) {
  simd::in_vectors<march_here>(walls, by, rays);
}

}  // namespace playhouse::rays
