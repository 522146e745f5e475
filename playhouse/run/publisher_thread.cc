#include "playhouse/run/publisher_thread.h"

#include "playhouse/base/assert.h"

namespace playhouse::run {
namespace {

/// Minimum number of parts that pays for waking another thread.
constexpr std::size_t kMany = 5;

}  // namespace

PublisherThread::~PublisherThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  begun_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void PublisherThread::begin(std::span<const Work> works) {
  PLAYHOUSE_ASSERT(!under_way_ && !works.empty());
  under_way_ = true;
  std::size_t parts = 0;
  for (const Work& work : works) parts += work.parts;
  {
    const std::lock_guard lock(mutex_);
    works_ = works;
    progress_.assign(works.size(), {});
    works_ended_ = 0;
  }
  if (parts >= kMany) wake();
}

void PublisherThread::go_on() {
  if (under_way_ && !awake_) wake();
}

void PublisherThread::wake() {
  awake_ = true;
  begun_.notify_one();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

void PublisherThread::finish(world::Workers& workers) {
  if (!under_way_) return;
  if (workers.count() > 1 && many_left()) {
    workers.run(workers.count(), 1, [this](std::size_t, std::size_t) { do_parts(); });
  } else {
    do_parts();
  }
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return works_ended_ == works_.size(); });
  works_ = {};
  progress_.clear();
  under_way_ = awake_ = false;
}

void PublisherThread::run() {
  for (;;) {
    do_parts();
    std::unique_lock lock(mutex_);
    begun_.wait(lock, [this] { return ending_ || next(); });
    if (ending_) return;
  }
}

void PublisherThread::do_parts() {
  while (const std::optional<WorkPart> part = take()) {
    part->work->run(part->number);
    did(*part);
  }
}

std::optional<PublisherThread::WorkPart> PublisherThread::take() {
  const std::lock_guard lock(mutex_);
  const std::optional<WorkPart> part = next();
  if (part) ++part->progress->begun;
  return part;
}

std::optional<PublisherThread::WorkPart> PublisherThread::next() {
  for (std::size_t k = 0; k < works_.size(); ++k)
    if (progress_[k].begun < works_[k].parts) return WorkPart{&works_[k], &progress_[k], progress_[k].begun};
  return std::nullopt;
}

void PublisherThread::did(const WorkPart& part) {
  {
    const std::lock_guard lock(mutex_);
    if (++part.progress->done < part.work->parts) return;
  }
  if (part.work->end) part.work->end();
  const std::lock_guard lock(mutex_);
  if (++works_ended_ == works_.size()) ended_.notify_one();
}

/// True if there is work for more than the caller.
bool PublisherThread::many_left() const {
  const std::lock_guard lock(mutex_);
  std::size_t left = 0;
  for (std::size_t k = 0; k < works_.size(); ++k) left += works_[k].parts - progress_[k].begun;
  return left > 1;
}

}  // namespace playhouse::run
