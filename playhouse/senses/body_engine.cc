#include "playhouse/senses/body_engine.h"

#include <algorithm>
#include <utility>

#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/touch.h"

namespace playhouse::senses {
namespace {

/// Layers of movable solids by their lowest height: solids with overlapping height
/// ranges, such as robot bodies, share a layer; what is stacked on top is in another.
std::vector<std::uint8_t> layers_of(const bodies::Solids& solids) {
  constexpr std::size_t kMost = 8;
  std::vector<std::pair<double, double>> heights;
  for (const bodies::SolidRow row : solids.moving_rows())
    heights.emplace_back(solids.z_free(row), solids.z_max[row]);
  std::sort(heights.begin(), heights.end());
  std::vector<double> begins;
  double top = -1e300;
  for (const auto& [z_min, z_max] : heights) {
    if (z_min > top - bodies::kTouch) begins.push_back(z_min);
    top = std::max({top, z_min, z_max});  // an enclosed solid has z_min > z_max
  }
  if (begins.size() > kMost) return {};
  std::vector<std::uint8_t> layer;
  for (const bodies::SolidRow row : solids.moving_rows()) {
    const auto above = std::upper_bound(begins.begin(), begins.end(), solids.z_free(row));
    layer.push_back(static_cast<std::uint8_t>(above - begins.begin() - 1));
  }
  return layer;
}

/// Mean over trees of the radius of their largest solid. [m]
double robot_radius(const bodies::Trees& trees, const bodies::Solids& solids) {
  double sum = 0;
  for (const bodies::TreeRow tree : trees.rows()) {
    double largest = 0;
    for (const bodies::SolidRow row : trees.solids_of(tree)) largest = std::max(largest, solids.radius[row]);
    sum += largest;
  }
  return sum / static_cast<double>(std::max<std::size_t>(trees.size(), 1));
}

}  // namespace

BodyEngine::BodyEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers,
                       const SenseMakers& makers)
    : PhasedEngine(scene, seed, workers), shapes_(scene) {
  add_senses(senses_, workers_.count(), makers);
}

world::PhysicsShapes BodyEngine::shapes() const {
  world::PhysicsShapes shapes;
  const auto prism = [&](bodies::SolidRow row, const geom::Pose& X_FM) {
    const geom::Rotation turn = geom::Rotation::of(X_FM.a);
    world::SolidCorners corners;
    for (const double z : {solids_.z_min_M[row], solids_.z_max_M[row]})
      for (const geom::Vec2 p_M : solids_.polygon_M(row)) {
        const geom::Vec2 p = X_FM.xy() + turn * p_M;
        corners.push_back({p.x, p.y, X_FM.z + z});
      }
    return corners;
  };
  for (const bodies::SolidRow row : solids_.fixed_rows())
    if (solids_.is_obstacle(row)) shapes.fixed.push_back(prism(row, world_.models.X_WM[solids_.model[row]]));
  for (const bodies::TreeRow tree : trees_.rows()) {
    const world::ModelRow top = trees_.root[tree];
    const geom::Pose X_BW = geom::inverse(world_.models.X_WM[top]);
    world::PhysicsShapes::Body body{world_.id(top), {}};
    for (const bodies::SolidRow row : trees_.solids_of(tree))
      if (solids_.is_obstacle(row))
        body.solids.push_back(prism(row, geom::compose(X_BW, world_.models.X_WM[solids_.model[row]])));
    if (!body.solids.empty()) shapes.bodies.push_back(std::move(body));
  }
  return shapes;
}

/// True if the static solids have to be made. Any event may be one of theirs: if a model is removed, later
/// ones change rows. A state that was loaded mostly has those of before.
bool BodyEngine::have_static_models_changed() {
  std::vector<bodies::StaticModel> now = bodies::static_models(world_);
  if (static_models_ == now) return false;
  static_models_ = std::move(now);
  return true;
}

void BodyEngine::populate() {
  const bool fixed = have_static_models_changed();
  trees_ = bodies::make_trees(world_);
  if (fixed) solids_ = make_fixed_solids(world_, shapes_);
  replace_moving_solids(solids_, world_, shapes_, trees_);
  if (fixed) walls_ = bodies::Walls(solids_);
  index_.populate(solids_.moving(), robot_radius(trees_, solids_), layers_of(solids_),
                  std::span(solids_.radius).last(solids_.moving()));
  index();
  populated(fixed);
  senses_.populate(world_, space());
}

void BodyEngine::ingest(std::span<const world::Event> events) {
  using EventKind = world::Event::EventKind;
  bool population = false, moved = false;
  for (const world::Event& event : events) {
    if (event.kind == EventKind::kSet) continue;
    const bool places = event.kind == EventKind::kPlace;
    population |= !places || event.mobility == world::Mobility::kFixed || moves_within_body(event);
    moved |= places;
  }
  if (population) {
    populate();
  } else if (moved) {
    for (const world::Event& event : events) replace(event);
    index();
  }
}

/// True if a rigidly attached part was moved on its body: enclosure has to be recomputed.
bool BodyEngine::moves_within_body(const world::Event& event) const {
  const world::ModelRow model = world_.row(event.model);
  return event.kind == world::Event::EventKind::kPlace && model && world_.models.parent[model] &&
         !world::moves(world_.models.kind[model]);
}

/// Updates the solids of a tree that was teleported.
void BodyEngine::replace(const world::Event& event) {
  const world::ModelRow model = world_.row(event.model);
  if (event.kind != world::Event::EventKind::kPlace || !model) return;
  const bodies::TreeRow tree = trees_.of_root(world_.models.root[model]);
  turn(solids_, world_.models, trees_.models_of(tree));
  place(solids_, world_.models, trees_.solids_of(tree));
  replaced(tree);
}

void BodyEngine::index() {
  index_.rebuild(
      solids_.moving(), [&](std::size_t i) { return disc_of(solids_, solids_.moving_rows()[i]); }, workers_);
}

void BodyEngine::sense(std::uint64_t tick) {
  rays_ += senses_.sense(world_, space(), tick, workers_, division_);
}

void BodyEngine::touching(world::ModelRow model, const world::ByModel<std::uint8_t>& wanted,
                          std::vector<world::ModelRow>& out) const {
  bodies::touching(space(), trees_, world_.models, model, wanted, out);
}

}  // namespace playhouse::senses
