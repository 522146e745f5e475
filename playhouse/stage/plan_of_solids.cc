#include "playhouse/stage/plan_of_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/geom/trapezoids.h"

namespace playhouse::stage {
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

  /// Draws the pixels that an outline crosses.
  void draw(geom::Outline outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], e = outline[(i + 1) % outline.size()] - a;
      const auto steps = static_cast<int>(2 * std::sqrt(geom::dot(e, e)) / plan_.resolution) + 1;
      for (int k = 0; k <= steps; ++k) {
        const Vec2 p = a + (static_cast<double>(k) / steps) * e;
        const int x = static_cast<int>(std::floor((p.x - plan_.X_WI.x) / plan_.resolution));
        const int y = static_cast<int>(std::floor((p.y - plan_.X_WI.y) / plan_.resolution));
        if (x >= 0 && x < plan_.solid.width && y >= 0 && y < plan_.solid.height)
          mark(x, plan_.solid.height - 1 - y);
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

}  // namespace

Result<scene::Plan> plan_of_solids(const Solids& solids, double resolution,
                                   const std::function<bool(std::size_t row)>& counts) {
  std::map<std::uint32_t, std::vector<geom::Outline>> bodies;  // contours of a bitmap include holes
  std::vector<geom::Outline> thin;
  geom::Box all;
  for (std::size_t row = 0; row < solids.size(); ++row) {
    if (!counts(row)) continue;
    const geom::Outline outline = solids.polygon(row);
    for (const Vec2 p : outline) all.add(p);
    bodies[solids.body[row]].push_back(outline);
    if (solids.width[row] < resolution) thin.push_back(outline);
  }
  if (bodies.empty()) return scene::Plan{{}, {}, {}, resolution, {}};
  Result<scene::Plan> plan = empty_plan(all, resolution);
  if (!plan) return plan;
  Canvas canvas(*plan);
  for (const auto& [body, outlines] : bodies) canvas.fill(outlines);
  for (const geom::Outline outline : thin) canvas.draw(outline);
  return plan;
}

}  // namespace playhouse::stage
