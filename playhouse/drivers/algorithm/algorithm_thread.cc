#include "playhouse/drivers/algorithm/algorithm_thread.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

AlgorithmThread::~AlgorithmThread() {
  {
    const Lock lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void AlgorithmThread::follow_ticks(std::uint64_t tick, std::uint64_t delay) {
  const Lock lock(mutex_);
  PLAYHOUSE_ASSERT(last_number_ == 0);
  tick_ = tick;
  delay_ = delay;
}

void AlgorithmThread::post(AlgorithmStep step) {
  {
    Lock lock(mutex_);
    if (!tick_) std::erase_if(jobs_, [](const PostedStep& job) { return job.step != nullptr; });
    jobs_.push_back({++last_number_, tick_.value_or(0) + 1 + delay_, std::move(step), std::nullopt});
    if (steps_ == Steps::kOnCaller) return tick_ ? void() : run_posted(lock);
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  changed_.notify_all();
}

void AlgorithmThread::clear() {
  Lock lock(mutex_);
  jobs_.clear();
  fresh_ = true;
  changed_.notify_all();  // a tick may be waiting for one
  changed_.wait(lock, [this] { return !delivering_; });
}

void AlgorithmThread::ticked(std::uint64_t tick) {
  Lock lock(mutex_);
  tick_ = tick;
  while (!jobs_.empty() && jobs_.front().due <= tick) {
    const std::uint64_t number = jobs_.front().number;
    if (steps_ == Steps::kOnCaller) run_step(lock, jobs_.front());
    changed_.wait(lock, [&] {
      const PostedStep* job = find(number);
      return job == nullptr || job->result.has_value();
    });
    if (find(number) != nullptr) deliver_first(lock);
  }
}

void AlgorithmThread::run() {
  Lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || next_to_begin() != nullptr; });
    if (ending_) return;
    run_step(lock, *next_to_begin());
  }
}

/// On the thread that posts. What a delivery posts, it leaves to the call that delivers.
void AlgorithmThread::run_posted(Lock& lock) {
  if (std::exchange(running_, true)) return;
  while (PostedStep* const job = next_to_begin()) run_step(lock, *job);
  running_ = false;
}

void AlgorithmThread::run_step(Lock& lock, PostedStep& job) {
  const std::uint64_t number = job.number;
  const AlgorithmStep step = std::exchange(job.step, nullptr);
  const bool fresh = std::exchange(fresh_, false);
  lock.unlock();
  Delivery result = step(fresh);
  lock.lock();
  PostedStep* const done = find(number);
  if (done == nullptr) return;  // cleared in the meantime
  done->result = std::move(result);
  if (!tick_) return deliver_first(lock);
  changed_.notify_all();
}

void AlgorithmThread::deliver_first(Lock& lock) {
  const Delivery result = std::move(*jobs_.front().result);
  jobs_.pop_front();
  delivering_ = true;
  lock.unlock();
  result();
  lock.lock();
  delivering_ = false;
  changed_.notify_all();
}

AlgorithmThread::PostedStep* AlgorithmThread::next_to_begin() {
  const auto found = std::ranges::find_if(jobs_, [](const PostedStep& job) { return job.step != nullptr; });
  return found == jobs_.end() ? nullptr : &*found;
}

AlgorithmThread::PostedStep* AlgorithmThread::find(std::uint64_t number) {
  const auto found = std::ranges::find(jobs_, number, &PostedStep::number);
  return found == jobs_.end() ? nullptr : &*found;
}

}  // namespace playhouse::drivers
