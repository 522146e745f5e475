#include "playhouse/app/world_saver.h"

#include <algorithm>
#include <span>
#include <utility>

#include "playhouse/app/whole_file.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/world/saving/as_scene.h"

namespace playhouse::app {

void WorldSaver::save(const world::World& world, const std::string& file) {
  SaveJob job{file, world::as_scene(world), world.time()};
  {
    const std::lock_guard lock(mutex_);
    const auto waiting = std::ranges::find(jobs_, file, &SaveJob::file);
    if (waiting == jobs_.end()) {
      jobs_.push_back(std::move(job));
    } else {
      std::swap(*waiting, job);  // the replaced scene is destroyed without the lock
    }
    ending_ = false;
  }
  changed_.notify_one();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

bool WorldSaver::finish() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
  return all_saved_;
}

void WorldSaver::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    SaveJob job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    const bool written = write(std::move(job));
    lock.lock();
    all_saved_ = all_saved_ && written;
  }
}

bool WorldSaver::write(SaveJob job) {
  const Result<std::string> text = world::world_file(job.standing, job.time, job.file);
  const Result<void> written =
      text ? write_file(job.file, std::as_bytes(std::span(*text)))
           : Result<void>(Error{escaped(job.file), "not saved: " + text.error().text});
  if (written)
    log::info("saved the world at {} s to {}", job.time, escaped(job.file));
  else
    log::tell(log::Level::kError, written.error());
  return written.ok();
}

}  // namespace playhouse::app
