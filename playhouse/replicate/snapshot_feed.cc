#include "playhouse/replicate/snapshot_feed.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::replicate {

SnapshotFeed::SnapshotFeed(const world::World& world, DeviceNames devices, Clock clock)
    : scene_(world.scene()),
      light_(light_text(world)),
      prototypes_(scene_),
      clock_(std::move(clock)),
      devices_(std::move(devices)),
      layout_(std::make_shared<const Layout>(world, prototypes_, devices_)) {
  for (int k = 0; k < 2; ++k) buffers_.push_back(std::make_unique<SnapshotBuffer>());
  newest_ = buffers_.front().get();
  capture(world, {}, layout_, {}, newest_->snapshot);
}

std::string SnapshotFeed::scene_text(const Layout& layout, TellDevices devices) const {
  return replicate::scene_text(scene_, light_, prototypes_, layout, devices);
}

bool SnapshotFeed::wants_show() const {
  const bool is_watched = std::ranges::any_of(readers_, [](const SnapshotReader* reader) {
    return reader->watches_.load(std::memory_order_relaxed);
  });
  return is_watched && clock_() - capture_time_ >= kFramePeriod;
}

void SnapshotFeed::show(const world::World& world, const world::Pace& pace) {
  capture_time_ = clock_();
  interest_.clear();
  SnapshotBuffer* written = nullptr;
  {
    const std::lock_guard lock(mutex_);
    for (const SnapshotReader* reader : readers_) interest_.add(reader->interest_);
    written = &free_buffer();
  }
  if (layout_->population != world.population())
    layout_ = std::make_shared<const Layout>(world, prototypes_, devices_, layout_.get());
  capture(world, pace, layout_, interest_, written->snapshot, &newest_->snapshot);
  {
    const std::lock_guard lock(mutex_);
    newest_ = written;
  }
  for (SnapshotReader* reader : readers_) reader->notify();
}

/// It stays free without the lock: readers take the newest one alone.
SnapshotFeed::SnapshotBuffer& SnapshotFeed::free_buffer() {
  const auto found = std::ranges::find_if(buffers_, [this](const std::unique_ptr<SnapshotBuffer>& buffer) {
    return buffer->readers == 0 && buffer.get() != newest_;
  });
  PLAYHOUSE_ASSERT(found != buffers_.end());
  return **found;
}

SnapshotReader::SnapshotReader(SnapshotFeed& feed, PostTask post, std::function<void()> serve)
    : feed_(feed),
      post_(std::move(post)),
      serve_(std::make_shared<const std::function<void()>>(std::move(serve))),
      taken_(feed.newest_) {
  ++taken_->readers;
  feed_.readers_.push_back(this);
  feed_.buffers_.push_back(std::make_unique<SnapshotFeed::SnapshotBuffer>());
}

SnapshotReader::~SnapshotReader() {
  --taken_->readers;
  std::erase(feed_.readers_, this);
}

void SnapshotReader::set_interest(Interest interest) {
  const std::lock_guard lock(feed_.mutex_);
  interest_ = std::move(interest);
}

void SnapshotReader::take() {
  told_ = false;
  const std::lock_guard lock(feed_.mutex_);
  --taken_->readers;
  taken_ = feed_.newest_;
  ++taken_->readers;
}

void SnapshotReader::notify() {
  if (!watches_ || told_.exchange(true)) return;
  post_([weak = std::weak_ptr(serve_)] {
    if (const auto serve = weak.lock()) (*serve)();
  });
}

}  // namespace playhouse::replicate
