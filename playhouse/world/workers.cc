#include "playhouse/world/workers.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace playhouse::world {

struct Workers::Arena {
  explicit Arena(unsigned count)
      : allowance(oneapi::tbb::global_control::max_allowed_parallelism, count),
        threads(static_cast<int>(count)) {}

  oneapi::tbb::global_control allowance;  // as many threads as asked for, also on a machine with fewer cores
  oneapi::tbb::task_arena threads;
};

Workers::Workers(unsigned count) : count_(std::max(1u, count)) {
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Workers::~Workers() = default;

void Workers::run_ranges(std::size_t rows, std::size_t grain, const void* body, Call call) {
  arena_->threads.execute([=] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, rows, grain),
                              [=](const auto& range) { call(body, range.begin(), range.end()); });
  });
}

unsigned Workers::current() const {
  if (count_ == 1) return 0;
  const int index = oneapi::tbb::this_task_arena::current_thread_index();
  return index < 0 || static_cast<unsigned>(index) >= count_ ? 0 : static_cast<unsigned>(index);
}

}  // namespace playhouse::world
