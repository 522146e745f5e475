#include "playhouse/app/playback.h"

#include <algorithm>

#include "playhouse/base/log.h"
#include "playhouse/world/periods.h"

namespace playhouse::app {
namespace {

/// Maximum number of keyframes for the page's slider: spacing grows with the length.
constexpr std::uint64_t kMoments = 3600;

std::shared_ptr<const world::Timeline> moments(std::uint64_t first, std::uint64_t last, double interval) {
  auto timeline = std::make_shared<world::Timeline>();
  const std::uint64_t step = std::max(world::ticks_of(1, interval), (last - first) / kMoments + 1);
  for (std::uint64_t tick = first; tick < last; tick += step) timeline->ticks.push_back(tick);
  timeline->ticks.push_back(last);
  return timeline;
}

}  // namespace

Playback::Playback(run::Simulation& simulation, record::Rerun& rerun)
    : simulation_(simulation),
      rerun_(rerun),
      timeline_(moments(rerun.first_tick(), rerun.last_tick(), rerun.world().scene().interval)) {}

void Playback::rewind(std::uint64_t tick) {
  simulation_.requests().post([this, tick](const world::Journal&) { rerun_.seek(tick); });
}

void Playback::look_for_end() {
  if (rerun_.differs() && !std::exchange(told_, true))
    log::error("the run differs from its recording {}; it is shown up to there", *rerun_.differs());
  if ((rerun_.at_end() || rerun_.differs()) && !simulation_.requests().pace().paused)
    simulation_.requests().pause();
}

}  // namespace playhouse::app
