#include "playhouse/bodies/blocked_starts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/solids.h"

namespace playhouse::bodies {
namespace {

using world::World;

constexpr std::size_t kMostRobots = 10'000;  // of a world that is looked at: more are placed by programs
constexpr std::size_t kMostModels = 2000;    // the same for one model that is placed: about 0.2 ms
constexpr std::size_t kMostPairs = 1000;     // that are looked for: robots may all be at one place
constexpr double kLeastRow = 0.25;           // m
constexpr double kMostRows = 4096;           // of an extent, so that long things are in so many rows at most

geom::Box box_of(std::span<const geom::Vec2> points) {
  geom::Box box;
  for (const geom::Vec2 p : points) box.add(p);
  return box;
}

/// A block of a model.
struct PlacedBlock {
  Solid solid;
  geom::Box box;
  world::ModelRow model;
  bool is_searched = false;
};

/// An edge of the contours of a bitmap.
struct Edge {
  geom::Vec2 a, b;
  std::uint32_t contours = 0;  // number of its contours
};

struct BitmapWalls {
  world::ModelRow model;
  double bottom = 0, top = 0;
};

/// Numbers of things by the rows of the plane that they are in.
class RowIndex {
 public:
  RowIndex(double low, double high) : low_(low), height_(std::max(kLeastRow, (high - low) / kMostRows)) {
    rows_.resize(static_cast<std::size_t>((high - low) / height_) + 1);
  }
  void add(std::uint32_t thing, double y0, double y1) {
    for (std::size_t row = row_of(y0); row <= row_of(y1); ++row) rows_[row].push_back(thing);
  }
  /// Of one row. What spans several is in each.
  std::span<const std::uint32_t> at(std::size_t row) const { return rows_[row]; }
  std::size_t row_of(double y) const {
    const double row = std::floor((y - low_) / height_);
    return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
  }

 private:
  double low_, height_;
  std::vector<std::vector<std::uint32_t>> rows_;
};

class Search {
 public:
  /// `is_searched`: by row, of models whose overlaps are looked for.
  template <typename IsSearched>
  Search(const World& world, const IsSearched& is_searched) : world_(world) {
    for (const world::ModelRow row : world.models.rows()) add_model(row, is_searched(row));
  }

  /// Pairs of models: a searched one, and what it overlaps.
  std::set<std::pair<world::ModelRow, world::ModelRow>> run() {
    if (bodies_.empty()) return {};
    const auto [low, high] = extent();
    RowIndex bodies(low, high), edges(low, high);
    for (std::uint32_t i = 0; i < bodies_.size(); ++i)
      bodies.add(i, bodies_[i].box.y_min, bodies_[i].box.y_max);
    for (std::uint32_t i = 0; i < edges_.size(); ++i)
      edges.add(i, std::min(edges_[i].a.y, edges_[i].b.y), std::max(edges_[i].a.y, edges_[i].b.y));
    for (const PlacedBlock& body : bodies_) {
      if (found_.size() >= kMostPairs) break;
      if (!body.is_searched) continue;
      look_at_bodies(body, bodies);
      look_at_walls(body, edges);
    }
    return found_;
  }

 private:
  void add_model(world::ModelRow row, bool is_searched) {
    const scene::ModelDesc& desc = world_.desc(row);
    const geom::Pose& X_WM = world_.models.X_WM[row];
    std::vector<Solid> solids;
    add_blocks(desc, X_WM, solids);
    for (Solid& solid : solids) {
      const geom::Box box = box_of(solid.p);
      bodies_.push_back({std::move(solid), box, row, is_searched});
    }
    if (!desc.obstacle_return) return;
    const geom::Pose X_WB = geom::compose(X_WM, desc.X_MB);
    for (const scene::Contours& contours : desc.bitmaps) {
      const auto number = static_cast<std::uint32_t>(walls_.size());
      walls_.push_back({row, X_WB.z + contours.z_min, X_WB.z + contours.z_max});
      for (const std::vector<geom::Vec2>& loop : contours.loops) {
        const std::vector<geom::Vec2> p = moved(X_WB, loop);
        for (std::size_t i = 0, before = p.size() - 1; i < p.size(); before = i++)
          edges_.push_back({p[before], p[i], number});
      }
    }
  }

  /// Of y.
  std::pair<double, double> extent() const {
    double low = bodies_[0].box.y_min, high = bodies_[0].box.y_max;
    for (const PlacedBlock& body : bodies_)
      low = std::min(low, body.box.y_min), high = std::max(high, body.box.y_max);
    for (const Edge& edge : edges_) low = std::min(low, edge.a.y), high = std::max(high, edge.a.y);
    return {low, high};
  }

  bool are_of_one_tree(world::ModelRow one, world::ModelRow other) const {
    return world_.models.root[one] == world_.models.root[other];
  }

  void look_at_bodies(const PlacedBlock& body, const RowIndex& index) {
    for (std::size_t row = index.row_of(body.box.y_min); row <= index.row_of(body.box.y_max); ++row)
      for (const std::uint32_t number : index.at(row)) {
        if (found_.size() >= kMostPairs) return;
        const PlacedBlock& other = bodies_[number];
        if (are_of_one_tree(body.model, other.model) || !body.box.overlaps(other.box)) continue;
        if (other.is_searched && other.model < body.model) continue;  // of two the first one has the line
        if (!share_heights(body.solid, other.solid.bottom, other.solid.top)) continue;
        if (overlap(outline_of(body.solid), outline_of(other.solid)))
          found_.insert({body.model, other.model});
      }
  }

  /// In walls: an edge goes through the body, or the body is within them, by the even-odd rule.
  void look_at_walls(const PlacedBlock& body, const RowIndex& index) {
    const Polygon outline = outline_of(body.solid);
    const geom::Vec2 inner = body.solid.p.front();
    std::map<std::uint32_t, bool> inside;
    for (std::size_t row = index.row_of(body.box.y_min); row <= index.row_of(body.box.y_max); ++row) {
      const bool is_row_of_inner = row == index.row_of(inner.y);
      for (const std::uint32_t number : index.at(row)) {
        const auto [a, b, contours] = edges_[number];
        const BitmapWalls& walls = walls_[contours];
        if (are_of_one_tree(body.model, walls.model) || !share_heights(body.solid, walls.bottom, walls.top))
          continue;
        const geom::Vec2 ends[] = {a, b};
        if (body.box.overlaps(box_of(ends)) && length_inside(outline, a, b) > kTouch)
          found_.insert({body.model, walls.model});
        if (is_row_of_inner && ray_crosses(inner, a, b)) inside[contours] = !inside[contours];
      }
    }
    for (const auto& [contours, is_inside] : inside)
      if (is_inside) found_.insert({body.model, walls_[contours].model});
  }

  const World& world_;
  std::vector<PlacedBlock> bodies_;
  std::vector<Edge> edges_;
  std::vector<BitmapWalls> walls_;
  std::set<std::pair<world::ModelRow, world::ModelRow>> found_;
};

std::string shown(const World& world, world::ModelRow model) {
  const std::string name = world.name(model);
  return in_quotes(name.empty() ? world.alias(model) : name);
}

}  // namespace

std::vector<std::string> blocked_starts(const World& world) {
  if (world.positions.size() == 0 || world.positions.size() > kMostRobots) return {};
  std::set<std::pair<world::ModelRow, world::ModelRow>> roots;
  const auto& root = world.models.root;
  const auto is_driven = [&](world::ModelRow row) {
    return world.models.mobility[row] == world::Mobility::kDriven;
  };
  for (const auto& [robot, other] : Search(world, is_driven).run()) roots.insert({root[robot], root[other]});
  std::vector<std::string> lines;
  for (const auto& [robot, other] : roots) {
    if (lines.size() == limits::kWarningsOfAKind) {
      lines.push_back(world.scene().path + ": further robots start in something");
      break;
    }
    lines.push_back(world.scene().at(world.where(robot)) + ": " + shown(world, robot) + " starts in " +
                    shown(world, other) + ": it stalls there");
  }
  return lines;
}

std::string overlapped_by(const World& world, world::ModelRow model) {
  if (world.models.size() > kMostModels) return {};
  const world::ModelRow root = world.models.root[model];
  const auto is_of_tree = [&](world::ModelRow row) { return world.models.root[row] == root; };
  const auto found = Search(world, is_of_tree).run();
  return found.empty() ? std::string() : shown(world, world.models.root[found.begin()->second]);
}

}  // namespace playhouse::bodies
