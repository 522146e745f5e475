/// Lamps: blinking. All periods count from the start of
/// the run, so lamps of equal period flash in phase.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

/// Times are compared in integer microseconds, the resolution of files.
std::int64_t microseconds(double seconds) {
  constexpr double kMost = 1e12;  // s; longer than any run
  return std::llround(std::clamp(seconds, 0.0, kMost) * 1e6);
}

/// `now`: time of the state being computed. [s]
bool is_lit(const world::World& world, world::BlinkenlightRow lamp, double now) {
  const world::Blinkenlights& lamps = world.blinkenlights;
  if (!lamps.enabled[lamp]) return false;
  if (world.models.subscribers[lamps.model[lamp]] == 0) return true;
  const std::int64_t period = microseconds(lamps.period[lamp]);
  if (period == 0) return true;
  const double since = static_cast<double>(microseconds(now) % period);
  return since < lamps.dutycycle[lamp] * static_cast<double>(period);
}

/// Writes blinkenlights.lit. Lamps without subscribers do not blink: lit while switched on.
class BlinkenlightAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    const double now = static_cast<double>(world.tick() + 1) * world.scene().interval;
    workers.run(world.blinkenlights.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (const world::BlinkenlightRow lamp : world.blinkenlights.rows().part(begin, end))
        world.blinkenlights.lit[lamp] = is_lit(world, lamp, now);
    });
  }
};

}  // namespace

std::unique_ptr<ActPhase> make_blinkenlight_act() {
  return std::make_unique<BlinkenlightAct>();
}

}  // namespace playhouse::behaviour
