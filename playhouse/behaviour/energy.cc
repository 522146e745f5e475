#include "playhouse/behaviour/energy.h"

#include <algorithm>
#include <cmath>

#include "playhouse/behaviour/generated/draws.h"

namespace playhouse::behaviour {
namespace {

constexpr double kWattsPerMomentum =
    10;  // of a robot that drives, as in Stage; of each kg at 1 m/s or 1 rad/s

double speed_of(const geom::Twist& velocity) {
  return std::fabs(velocity.x) + std::fabs(velocity.y) + std::fabs(velocity.a);
}

}  // namespace

void Energy::drain(world::World& world, world::Workers& workers) {
  if (population_ != world.population()) populate(world);
  workers.run(world.packs.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (const world::PackRow pack : world.packs.rows().part(begin, end)) drain(world, pack);
  });
}

void Energy::populate(const world::World& world) {
  population_ = world.population();
  loads_.clear(), first_load_.clear(), givers_.clear(), takers_.clear();
  if (world.packs.size() == 0) return;
  const world::Models& models = world.models;
  world::ByModel<world::PackRow> pack(models.size());
  first_load_.assign(world.packs.size() + 1, 0);
  for (const world::ModelRow model : models.rows()) {
    pack[model] = world::pack_of(world, model);
    if (pack[model]) ++first_load_[pack[model] + 1];
  }
  for (const world::PackRow row : world.packs.rows()) first_load_[row + 1] += first_load_[row];
  loads_.resize(first_load_.back());
  ByRow<world::PackTable, std::uint32_t> next = first_load_;
  for (const world::ModelRow model : models.rows()) {
    if (!pack[model]) continue;
    const scene::ModelDesc& desc = world.desc(model);
    const world::PositionRow position = world.position(models.id[model]);
    loads_[next[pack[model]]++] = {model, draw_of(desc), position, kWattsPerMomentum * desc.mass};
  }
  find_givers(world, pack);
}

/// `pack`: battery that supplies each model.
void Energy::find_givers(const world::World& world, const world::ByModel<world::PackRow>& pack) {
  for (const world::ModelRow model : pack.rows()) {
    const double watts = world.desc(model).give_watts;
    if (pack[model] && watts > 0) givers_.push_back({model, pack[model], watts});
  }
  if (givers_.empty()) return;
  for (const world::ModelRow model : pack.rows())
    takers_.push_back(pack[model] && world.desc(model).take_watts > 0 ? 1 : 0);
}

double Energy::drawn_by(const world::World& world, const Load& load) const {
  if (!world::is_used(world, load.model)) return 0;
  if (!load.position) return load.watts;
  return load.watts + load.watts_per_speed * speed_of(world.positions.velocity[load.position]);
}

void Energy::drain(world::World& world, world::PackRow pack) const {
  world::Packs& packs = world.packs;
  const double dt = world.scene().interval;
  double watts = 0;
  for (std::uint32_t load = first_load_[pack]; load < first_load_[pack + 1]; ++load)
    watts += drawn_by(world, loads_[load]);
  const bool is_endless = packs.stored[pack] < 0;
  const double joules = is_endless ? watts * dt : std::min(watts * dt, packs.stored[pack]);
  if (!is_endless) packs.stored[pack] -= joules;
  packs.dissipated[pack] += joules;
  packs.watts[pack] = joules / dt;
  packs.charging[pack] = 0;
}

bool Energy::gives(const world::World& world, const Giver& giver) {
  const world::PackRow pack = giver.pack;
  return world::is_used(world, giver.model) && world.packs.gives[pack] != 0 && world.packs.stored[pack] != 0;
}

void Energy::charge(world::World& world, const Giver& giver, std::span<const world::ModelRow> takers) {
  world::Packs& packs = world.packs;
  const double dt = world.scene().interval;
  const world::PackRow from = giver.pack;
  for (const world::ModelRow taker : takers) {
    const world::PackRow to = world::pack_of(world, taker);
    if (packs.takes[to] == 0 || packs.stored[to] < 0) continue;
    const double room = packs.capacity[to] - packs.stored[to];
    const bool is_endless = packs.stored[from] < 0;
    double joules = std::min(std::min(giver.watts, world.desc(taker).take_watts) * dt, room);
    if (!is_endless) joules = std::min(joules, packs.stored[from]);
    if (joules <= 0) continue;
    if (!is_endless) packs.stored[from] -= joules;
    packs.stored[to] += joules;
    packs.charging[to] = 1;
    packs.watts[from] += joules / dt;
    packs.watts[to] -= joules / dt;
  }
}

}  // namespace playhouse::behaviour
