#pragma once

/// SnapshotFeed: what all servers of viewers show of one run. The world is captured once for all of them,
/// with what any of their viewers wants, and every SnapshotReader sees that same snapshot. Nobody waits:
/// a reader keeps its snapshot as long as it likes, because for R readers there are R + 2: one each, the
/// newest, and the one that is written. Threads: wants_show() and show() are for the tick thread or one that
/// works for it; a reader is for the thread that serves its viewers.

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "playhouse/replicate/scene_text.h"
#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// The minimum period of frames to one viewer, and of captures.
inline constexpr double kFramePeriod = 0.033;  // s

class SnapshotReader;

class SnapshotFeed {
 public:
  /// Monotonic seconds; any thread.
  using Clock = std::function<double()>;

  /// Makes the first layout and snapshot, so construct it before the first tick; `devices` is called then, and
  /// by show() for new models. The world's scene must outlive it.
  SnapshotFeed(const world::World& world, DeviceNames devices, Clock clock);
  SnapshotFeed(const SnapshotFeed&) = delete;
  SnapshotFeed& operator=(const SnapshotFeed&) = delete;

  const Prototypes& prototypes() const { return prototypes_; }
  /// See replicate::scene_text().
  std::string scene_text(const Layout& layout, TellDevices devices) const;

  /// True if a capture is due: a server has viewers, and the last one is at least kFramePeriod ago. Call it
  /// after each tick, and while paused at 10 Hz or more, so that dragging is visible and connections stay
  /// alive. One atomic load for each reader without viewers.
  bool wants_show() const;
  /// Captures the world, which must not change meanwhile, and notifies the readers that have viewers.
  void show(const world::World& world, const world::Pace& pace);

 private:
  friend class SnapshotReader;

  struct SnapshotBuffer {
    Snapshot snapshot;
    std::size_t readers = 0;  // guarded by mutex_
  };

  SnapshotBuffer& free_buffer();

  const scene::SceneDesc& scene_;
  const std::string light_;  // see light_text()
  const Prototypes prototypes_;
  const Clock clock_;
  const DeviceNames devices_;
  std::vector<SnapshotReader*> readers_;  // as long as show() is called always the same
  std::vector<std::unique_ptr<SnapshotBuffer>> buffers_;

  // Thread: that of show().
  std::shared_ptr<const Layout> layout_;  // of the newest capture
  double capture_time_ = -kFramePeriod;
  Interest interest_;  // of all readers

  std::mutex mutex_;        // guards newest_, SnapshotBuffer::readers and SnapshotReader::interest_
  SnapshotBuffer* newest_;  // whose snapshot is the newest
};

/// A server's access to the snapshots. Construct it before the first show() of its feed and destroy it after the
/// last one.
class SnapshotReader {
 public:
  /// Runs a task on the thread that serves viewers; any thread.
  using PostTask = std::function<void(std::function<void()>)>;

  /// Posts `serve` whenever there is a newer snapshot, once before the next take(). What is posted does nothing
  /// after the reader's end.
  SnapshotReader(SnapshotFeed& feed, PostTask post, std::function<void()> serve);
  ~SnapshotReader();
  SnapshotReader(const SnapshotReader&) = delete;
  SnapshotReader& operator=(const SnapshotReader&) = delete;

  /// Tells whether there are viewers.
  void watch(bool anybody) { watches_ = anybody; }
  /// What all viewers of this server want, for the next capture.
  void set_interest(Interest interest);
  /// Makes the newest snapshot the one that snapshot() returns.
  void take();
  /// The snapshot taken last, at first that of the feed's construction. It changes with take() alone.
  const Snapshot& snapshot() const { return taken_->snapshot; }

 private:
  friend class SnapshotFeed;

  void notify();

  SnapshotFeed& feed_;
  const PostTask post_;
  const std::shared_ptr<const std::function<void()>> serve_;  // posted tasks have a weak one
  std::atomic<bool> watches_ = false, told_ = false;
  Interest interest_;                    // guarded by the feed's mutex
  SnapshotFeed::SnapshotBuffer* taken_;  // this thread's
};

}  // namespace playhouse::replicate
