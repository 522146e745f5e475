#include "playhouse/drivers/plugin/plugin_thread.h"

#include <chrono>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/libraries/thrown_by.h"

namespace playhouse::drivers {

PluginThread::PluginThread(Hooks hooks, std::function<double()> clock, Failed failed)
    : hooks_(hooks), state_(std::make_shared<ThreadState>()) {
  state_->clock = std::move(clock);
  state_->failed = std::move(failed);
}

void PluginThread::finish(const std::function<void()>& recall) {
  Lock lock(state_->mutex);
  state_->ending = true;
  state_->changed.notify_all();
  if (!thread_.joinable()) return;
  const auto ends = [&] {
    return state_->changed.wait_for(lock, std::chrono::seconds(limits::kPluginEndSeconds),
                                    [this] { return state_->ended; });
  };
  bool ended = ends();
  if (!ended && recall) {
    lock.unlock();
    recall();
    lock.lock();
    ended = ends();
  }
  lock.unlock();
  if (ended) {
    thread_.join();
    return;
  }
  log::warn("a driver of a plug-in does not end; its thread is left behind");
  thread_.detach();
  end();
}

bool PluginThread::post(Hook hook, std::size_t most) {
  Lock lock(state_->mutex);
  if (state_->ending || state_->waiting.size() >= most) return false;
  state_->waiting.push_back(std::move(hook));
  if (hooks_ == Hooks::kOnCaller) {
    if (!state_->began)
      while (!state_->waiting.empty()) run_first(*state_, lock);
    return true;
  }
  if (!thread_.joinable()) thread_ = std::thread([state = state_] { run(*state); });
  lock.unlock();
  state_->changed.notify_all();
  return true;
}

double PluginThread::busy() const {
  const Lock lock(state_->mutex);
  return state_->began ? state_->clock() - *state_->began : 0;
}

void PluginThread::end() {
  std::deque<Hook> dropped;  // destroyed without the mutex: what they hold may answer NACK
  {
    const Lock lock(state_->mutex);
    state_->ending = true;
    dropped.swap(state_->waiting);
  }
  state_->changed.notify_all();
}

void PluginThread::run(ThreadState& state) {
  Lock lock(state.mutex);
  for (;;) {
    state.changed.wait(lock, [&state] { return state.ending || !state.waiting.empty(); });
    if (state.waiting.empty()) break;
    run_first(state, lock);
  }
  state.ended = true;
  state.changed.notify_all();
}

void PluginThread::run_first(ThreadState& state, Lock& lock) {
  Hook hook = std::move(state.waiting.front());
  state.waiting.pop_front();
  state.began = state.clock();
  lock.unlock();
  std::string thrown;
  const char* const why = libraries::thrown_by(thrown, hook);
  hook = nullptr;
  if (why != nullptr) state.failed(thrown);
  lock.lock();
  state.began.reset();
}

}  // namespace playhouse::drivers
