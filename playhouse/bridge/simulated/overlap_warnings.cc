#include "playhouse/bridge/simulated/overlap_warnings.h"

#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/bodies/blocked_starts.h"

namespace playhouse::drivers {

void OverlapWarnings::placed(const world::World& world, world::ModelRow model, std::string_view done) {
  if (told_ >= limits::kWarningsOfAKind) return;
  const std::string other = bodies::overlapped_by(world, model);
  if (other.empty()) return;
  ++told_;
  log::warn("simulation: a client {} {} into {}{}", done, in_quotes(world.name(model)), other,
            told_ == limits::kWarningsOfAKind ? " (further ones are not logged)" : "");
}

}  // namespace playhouse::drivers
