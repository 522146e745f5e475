#include "playhouse/controllers/rasterize.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"

namespace playhouse::controllers {
namespace {

using geom::Vec2;

constexpr int kColumns = 40, kRows = 20;
constexpr double kLeast = 1e-6;  // m, of a box

/// Marks cells along outlines, sampled at half a cell.
class Raster {
 public:
  Raster(const geom::Size& size, int columns, int rows)
      : columns_(columns),
        per_metre_{columns / std::max(size.x, kLeast), rows / std::max(size.y, kLeast)},
        corner_B_{-size.x / 2, -size.y / 2},
        lines_(static_cast<std::size_t>(rows), std::string(static_cast<std::size_t>(columns), '.')) {}

  void mark(std::span<const Vec2> loop_B) {
    for (std::size_t k = 0; k < loop_B.size(); ++k)
      mark(in_cells(loop_B[k]), in_cells(loop_B[(k + 1) % loop_B.size()]));
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  Vec2 in_cells(Vec2 p_B) const {
    return {(p_B.x - corner_B_.x) * per_metre_.x, (p_B.y - corner_B_.y) * per_metre_.y};
  }
  void mark(Vec2 from, Vec2 to) {
    const Vec2 way = to - from;
    const int steps = static_cast<int>(2 * std::max(std::fabs(way.x), std::fabs(way.y))) + 1;
    for (int step = 0; step <= steps; ++step) {
      const Vec2 at = from + (static_cast<double>(step) / steps) * way;
      const auto rows = static_cast<int>(lines_.size());
      const int column = std::clamp(static_cast<int>(at.x), 0, columns_ - 1);
      const int row = std::clamp(static_cast<int>(at.y), 0, rows - 1);
      lines_[static_cast<std::size_t>(rows - 1 - row)][static_cast<std::size_t>(column)] = 'O';
    }
  }

  int columns_;
  Vec2 per_metre_, corner_B_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> raster_of(const scene::ModelDesc& desc, int columns, int rows) {
  Raster raster(desc.size, columns, rows);
  for (const scene::Block& block : desc.blocks) raster.mark(block.points);
  for (const scene::Contours& bitmap : desc.bitmaps)
    for (const std::vector<Vec2>& loop : bitmap.loops) raster.mark(loop);
  return raster.take();
}

void Rasterize::deliver(world::World& world) {
  for (const std::uint32_t i : by_id()) {
    if (std::exchange(done_[i], 1)) continue;
    const world::ModelRow model = world.row(id(i));
    log::info("{} in {} x {} cells:", in_quotes(world.name(model)), kColumns, kRows);
    for (const std::string& line : raster_of(world.desc(model), kColumns, kRows)) log::info("{}", line);
  }
}

}  // namespace playhouse::controllers
