#include "playhouse/bodies/plan_of_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/geom/trapezoids.h"

namespace playhouse::bodies {
namespace {

/// Rasteriser into a plan.
class Canvas {
 public:
  explicit Canvas(scene::Plan& plan) : plan_(plan) {}

  /// Fills pixels with centres inside the outlines (even-odd rule).
  void fill(std::span<const geom::Outline> outlines) {
    std::vector<std::vector<Vec2>> loops;
    for (const geom::Outline outline : outlines)
      for (loops.emplace_back(); const Vec2 p : outline) loops.back().push_back(in_pixels(p));
    const std::vector<geom::Outline> in_plan(loops.begin(), loops.end());
    for (const geom::Trapezoid& part : geom::trapezoids(in_plan))
      geom::each_line(part, 0, plan_.solid.height, [&](int row, double left, double right) {
        const int first = column_after(left), last = column_after(right);
        for (int x = std::max(first, 0); x < std::min(last, plan_.solid.width); ++x) mark(x, row);
      });
  }

  /// Draws the pixels that an outline, of a hole or not, crosses where the solid
  /// beside it has been too thin to fill one. Outlines are counter-clockwise.
  void draw_thin(const scene::Bitmap& filled, geom::Outline outline, bool hole) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], e = outline[(i + 1) % outline.size()] - a;
      const double length = std::sqrt(geom::dot(e, e));
      if (length == 0) continue;
      const Vec2 inwards = ((hole ? -1 : 1) / length) * Vec2{-e.y, e.x};
      const auto steps = static_cast<int>(2 * length / plan_.resolution) + 1;
      for (int k = 0; k < steps; ++k) {  // not at corners, and inside: edges may be between pixels
        const Vec2 p = a + ((k + 0.5) / steps) * e + (1e-3 * plan_.resolution) * inwards;
        if (!is_filled(filled, p, inwards)) mark_at(p);
      }
    }
  }

 private:
  /// From the upper left corner, y down.
  Vec2 in_pixels(Vec2 p) const {
    return {(p.x - plan_.X_WI.x) / plan_.resolution,
            plan_.solid.height - (p.y - plan_.X_WI.y) / plan_.resolution};
  }
  /// The first column with its centre right of x. [pixels]
  static int column_after(double x) { return static_cast<int>(std::ceil(x - 0.5)); }
  /// True if a pixel less than one behind an edge is filled.
  bool is_filled(const scene::Bitmap& filled, Vec2 p, Vec2 inwards) const {
    for (int quarter = 0; quarter <= 4; ++quarter) {
      const Vec2 q = in_pixels(p + (quarter * plan_.resolution / 4) * inwards);
      if (filled.at(static_cast<int>(std::floor(q.x)), static_cast<int>(std::floor(q.y)))) return true;
    }
    return false;
  }
  void mark_at(Vec2 p) {
    const Vec2 q = in_pixels(p);
    const int x = static_cast<int>(std::floor(q.x)), row = static_cast<int>(std::floor(q.y));
    if (x >= 0 && x < plan_.solid.width && row >= 0 && row < plan_.solid.height) mark(x, row);
  }
  void mark(int x, int row) {
    plan_.solid.solid[static_cast<std::size_t>(row) * static_cast<std::size_t>(plan_.solid.width) +
                      static_cast<std::size_t>(x)] = 1;
  }

  scene::Plan& plan_;
};

/// An empty plan with a margin of one pixel, aligned to multiples of the resolution.
Result<scene::Plan> empty_plan(const geom::Box& walls, double resolution) {
  const double x0 = std::floor(walls.x_min / resolution) - 1, y0 = std::floor(walls.y_min / resolution) - 1;
  const double width = std::ceil(walls.x_max / resolution) + 1 - x0,
               height = std::ceil(walls.y_max / resolution) + 1 - y0;
  if (width * height > static_cast<double>(limits::kBitmapPixels))
    return Error{"", fmt::format("would be {:.0f} x {:.0f} pixels, and an image has at most {}", width,
                                 height, limits::kBitmapPixels)};
  scene::Plan plan;
  plan.resolution = resolution;
  plan.solid = {static_cast<int>(width), static_cast<int>(height), {}};
  plan.solid.solid.resize(static_cast<std::size_t>(width * height));
  plan.X_WI = {x0 * resolution, y0 * resolution, 0, 0};
  return plan;
}

/// On its own first: what is thin is so wherever it touches others. `rows`: of its outlines.
Result<void> draw_body(const Solids& solids, std::span<const SolidRow> rows, scene::Plan& plan) {
  geom::Box box;
  std::vector<geom::Outline> outlines;
  for (const SolidRow row : rows) {
    outlines.push_back(solids.polygon(row));
    for (const Vec2 p : outlines.back()) box.add(p);
  }
  Result<scene::Plan> own = empty_plan(box, plan.resolution);
  if (!own) return own.error();
  Canvas canvas(*own);
  canvas.fill(outlines);
  const scene::Bitmap filled = own->solid;
  for (const SolidRow row : rows) canvas.draw_thin(filled, solids.polygon(row), solids.hole[row] != 0);
  const auto offset = [&](double own_low, double low) {
    return static_cast<int>(std::lround((own_low - low) / plan.resolution));
  };
  const int right = offset(own->X_WI.x, plan.X_WI.x);
  const int down = plan.solid.height - own->solid.height - offset(own->X_WI.y, plan.X_WI.y);
  for (int y = 0; y < own->solid.height; ++y)
    for (int x = 0; x < own->solid.width; ++x)
      if (own->solid.at(x, y))
        plan.solid.solid[static_cast<std::size_t>(y + down) * static_cast<std::size_t>(plan.solid.width) +
                         static_cast<std::size_t>(x + right)] = 1;
  return {};
}

}  // namespace

bool is_wall_at(const Solids& solids, SolidRow row, double height) {
  return solids.is_obstacle(row) && solids.z_min[row] <= height && height <= solids.z_max[row];
}

Result<scene::Plan> plan_of_solids(const Solids& solids, double resolution,
                                   const std::function<bool(SolidRow row)>& counts) {
  std::map<SolidRow, std::vector<SolidRow>> bodies;  // contours of a bitmap include holes
  geom::Box all;
  for (const SolidRow row : solids.rows()) {
    if (!counts(row)) continue;
    for (const Vec2 p : solids.polygon(row)) all.add(p);
    bodies[solids.body[row]].push_back(row);
  }
  if (bodies.empty()) return scene::Plan{{}, {}, {}, resolution, {}};
  Result<scene::Plan> plan = empty_plan(all, resolution);
  if (!plan) return plan;
  for (const auto& [body, rows] : bodies)
    if (const Result<void> drawn = draw_body(solids, rows, *plan); !drawn) return drawn.error();
  return plan;
}

}  // namespace playhouse::bodies
