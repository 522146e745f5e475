#include "playhouse/run/pacer.h"

#include <algorithm>

#include "playhouse/base/assert.h"

namespace playhouse::run {

void Pacer::start(double now, double speed, bool paused) {
  PLAYHOUSE_ASSERT(interval_ > 0 && speed >= 0);
  speed_ = speed;
  paused_ = paused;
  due_ = now;
  left_ = 0;
  mark_ = now;
  ticks_since_mark_ = 0;
}

void Pacer::change(double now, double speed, bool paused) {
  PLAYHOUSE_ASSERT(speed >= 0);
  if (speed == speed_ && paused == paused_) return;
  const bool overdue = keeps_time() && due_ <= now;
  if (keeps_time())
    left_ = std::clamp((due_ - now) * speed_, 0.0, interval_);  // due_: infinite at tiny speeds
  speed_ = speed;
  paused_ = paused;
  if (keeps_time() && !overdue) due_ = now + left_ / speed_;
  mark_ = now;
  ticks_since_mark_ = 0;
}

std::optional<double> Pacer::due() const {
  if (speed_ == 0) return std::nullopt;
  return due_;
}

void Pacer::ticked(double now) {
  if (keeps_time()) {
    due_ += interval_ / speed_;
    if (due_ < now - kLag) due_ = now;
  } else {
    left_ = interval_;
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

}  // namespace playhouse::run
