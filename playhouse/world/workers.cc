#include "playhouse/world/workers.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#ifdef PLAYHOUSE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace playhouse::world {

// TBB orders the caller's writes before the bodies, and theirs before the
// caller's return; since its library is not instrumented, this tells the thread
// sanitizer. Ranges of one phase are unordered, which the sanitizer should see.
#ifdef PLAYHOUSE_THREAD_SANITIZER
static void leave(char* order) {
  __tsan_release(order);
}
static void enter(char* order) {
  __tsan_acquire(order);
}

// TBB's own memory: what its library does to it through functions that the sanitizer intercepts (memcmp, delete), and the
// tree of a loop's ranges, whose last count a worker takes after its body, in a header and so instrumented; the caller, which
// waits in the library, reuses that memory of its stack. No body runs within fold_tree().
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libtbb.so\n"
         "race:tbb::detail::d1::fold_tree<\n";
}
#else
static void leave(char*) {}
static void enter(char*) {}
#endif

/// Allows as many TBB threads as requested, even beyond the number of cores. The minimum of all
/// controls is effective process-wide, so there is a single one, for the maximum requested.
static void allow(unsigned count) {
  using oneapi::tbb::global_control;
  static std::mutex mutex;
  static std::unique_ptr<global_control> allowance;
  static unsigned allowed = 1;
  const std::lock_guard lock(mutex);
  if (count <= allowed) return;
  allowed = count;
  allowance.reset();
  allowance = std::make_unique<global_control>(global_control::max_allowed_parallelism, count);
}

struct Workers::Arena {
  explicit Arena(unsigned count) : threads(static_cast<int>(count)) { allow(count); }

  oneapi::tbb::task_arena threads;
  char started = 0;  // only their addresses are used, for the two orderings
  char done = 0;
};

Workers::Workers(unsigned count) : count_(std::max(1u, count)) {
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Workers::~Workers() = default;

void Workers::run_ranges(std::size_t rows, std::size_t grain, const void* body, Call call) {
  Arena& arena = *arena_;
  leave(&arena.started);
  const auto take = [&](const auto& range) {
    enter(&arena.started);
    call(body, range.begin(), range.end());
    leave(&arena.done);
  };
  arena.threads.execute(
      [&] { oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, rows, grain), take); });
  enter(&arena.done);
}

unsigned Workers::current() const {
  if (count_ == 1) return 0;
  const int index = oneapi::tbb::this_task_arena::current_thread_index();
  return index < 0 || static_cast<unsigned>(index) >= count_ ? 0 : static_cast<unsigned>(index);
}

}  // namespace playhouse::world
