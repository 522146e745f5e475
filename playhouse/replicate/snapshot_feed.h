#pragma once

/// SnapshotFeed: hands snapshots from the tick thread to a thread that serves viewers, without
/// blocking (triple buffer): one is written, one is ready, one is read. Threads: wants_show()
/// and show() are for the tick thread or one that works for it, all else for the serving thread.

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// The minimum period of frames to one viewer, and of captures.
inline constexpr double kFramePeriod = 0.033;  // s

class SnapshotFeed {
 public:
  /// Monotonic seconds; any thread.
  using Clock = std::function<double()>;

  /// Makes the first layout; `devices` is called then, and by show() for new models.
  SnapshotFeed(const world::World& world, const Prototypes& prototypes, DeviceNames devices, Clock clock)
      : prototypes_(prototypes),
        clock_(std::move(clock)),
        devices_(std::move(devices)),
        layout_(std::make_shared<const Layout>(world, prototypes, devices_)),
        first_(layout_) {}

  /// True if there are viewers and the last capture is at least kFramePeriod ago.
  bool wants_show() const {
    return watched_.load(std::memory_order_relaxed) && clock_() - capture_time_ >= kFramePeriod;
  }

  /// Captures the world, which must not change meanwhile. True: the serving thread has to be notified.
  bool show(const world::World& world, const world::Pace& pace) {
    capture_time_ = clock_();
    {
      const std::lock_guard lock(mutex_);
      tick_interest_ = interest_;
    }
    if (layout_->population != world.population())
      layout_ = std::make_shared<const Layout>(world, prototypes_, devices_, layout_.get());
    capture(world, pace, layout_, tick_interest_, back_);
    {
      const std::lock_guard lock(mutex_);
      std::swap(back_, ready_);
      fresh_ = true;
    }
    return !told_.exchange(true);
  }

  /// Tells whether there are viewers.
  void watch(bool anybody) { watched_ = anybody; }
  /// The interest of all viewers, for the next capture.
  void set_interest(Interest interest) {
    const std::lock_guard lock(mutex_);
    interest_ = std::move(interest);
  }
  /// Swaps the newest snapshot, if there is one, into `front`. Called by the serving thread when notified.
  void take(Snapshot& front) {
    told_ = false;
    const std::lock_guard lock(mutex_);
    if (std::exchange(fresh_, false)) std::swap(ready_, front);
  }
  /// The layout at construction.
  const std::shared_ptr<const Layout>& first_layout() const { return first_; }

 private:
  const Prototypes& prototypes_;
  const Clock clock_;
  const DeviceNames devices_;
  std::shared_ptr<const Layout> layout_;  // of the newest capture
  const std::shared_ptr<const Layout> first_;
  double capture_time_ = -kFramePeriod;
  Interest tick_interest_;
  Snapshot back_;

  std::atomic<bool> watched_ = false, told_ = false;
  std::mutex mutex_;  // guards the next three; held for a swap only
  Interest interest_;
  Snapshot ready_;
  bool fresh_ = false;
};

}  // namespace playhouse::replicate
