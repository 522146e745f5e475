/// Custom models: calls act() of the library on a copy of
/// each model's state, which is kept if the hook succeeds.
///
/// In: customs.command, state, stall; the frozen world, as the library reads it.
/// Out: customs.command and state of those that begin, state, velocity; colours of models.

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/behaviour/generated/acts.h"
#include "playhouse/world/custom_hooks.h"

namespace playhouse::behaviour {
namespace {

/// Limit that keeps products with a tick finite.  [m/s, rad/s]
constexpr double kFastest = 1e6;

bool is_velocity(const geom::Twist& v) {
  const auto good = [](double speed) { return std::fabs(speed) <= kFastest; };
  return good(v.x) && good(v.y) && good(v.z) && good(v.a);
}

bool is_color(const scene::Color& color) {
  return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b) && std::isfinite(color.a);
}

class CustomAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    const std::size_t models = world.customs.size();
    scratch_.resize(workers.count());
    colors_.resize(models);
    workers.run(models, 16, [&](std::size_t begin, std::size_t end) {
      for (const world::CustomRow row : world.customs.rows().part(begin, end))
        act_one(world, row, scratch_[workers.current()]);
    });
  }

  /// Colours are shared by equal models, so they are set sequentially.
  void change(world::World& world) override {
    for (const world::CustomRow row : world.customs.rows()) {
      const world::ModelRow model = world.customs.model[row];
      if (colors_[row] != world.models.color[model]) world::set_color(world, model, colors_[row]);
    }
  }

 private:
  void act_one(world::World& world, world::CustomRow row, std::vector<double>& state) {
    world::Customs& customs = world.customs;
    const world::ModelRow model = customs.model[row];
    colors_[row] = world.models.color[model];
    customs.velocity[row] = {};
    const world::CustomCode* const code = world::custom_code(world, model);
    if (!code) return;
    world::begin_custom(world, row);
    state.assign(customs.state[row].begin(), customs.state[row].end());
    world::CustomActor self{{world::custom_model(world, row, world.tick() + 1, Purpose::kCustomAct)},
                            state,
                            {},
                            customs.stall[row] != 0,
                            colors_[row]};
    if (!world::call_hook(self, *code, [&] { code->kind->act(self); })) return;
    if (!world::all_finite(state) || !is_velocity(self.velocity) || !is_color(self.color)) {
      world::complain(world, model, *code, "acts with a number that is not finite or far too large");
      return;
    }
    std::ranges::copy(state, customs.state[row].begin());
    customs.velocity[row] = self.velocity;
    colors_[row] = self.color;
  }

  std::vector<std::vector<double>> scratch_;        // states, per worker
  ByRow<world::CustomTable, scene::Color> colors_;  // requested colours
};

}  // namespace

std::unique_ptr<ActPhase> make_custom_act() {
  return std::make_unique<CustomAct>();
}

}  // namespace playhouse::behaviour
