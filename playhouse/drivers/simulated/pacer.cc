#include "playhouse/drivers/simulated/pacer.h"

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

void Pacer::restart(double now, double speed) {
  PLAYHOUSE_ASSERT(interval_ > 0 && speed >= 0);
  speed_ = speed;
  due_ = now;
  mark_ = now;
  ticks_since_mark_ = 0;
}

std::optional<double> Pacer::due() const {
  if (speed_ == 0) return std::nullopt;
  return due_;
}

void Pacer::ticked(double now) {
  if (speed_ > 0) {
    due_ += interval_ / speed_;
    if (due_ < now - kLag) due_ = now;
  }
  measure(now);
}

void Pacer::measure(double now) {
  ++ticks_since_mark_;
  const double elapsed = now - mark_;
  if (elapsed < 1) return;
  factor_ = static_cast<double>(ticks_since_mark_) * interval_ / elapsed;
  mark_ = now;
  ticks_since_mark_ = 0;
}

}  // namespace playhouse::drivers
