#include "playhouse/base/assert.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "playhouse/base/before_abort.h"

namespace playhouse {
namespace {

std::atomic<bool (*)()> before_abort = nullptr;

}  // namespace

void set_before_abort(bool (*task)()) {
  before_abort = task;
}

void assert_failed(const char* condition, const char* file, int line) {
  // Flushes the log first, which may explain the failure, without blocking on a stalled reader.
  bool (*const task)() = before_abort;
  if (task == nullptr || task())
    std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace playhouse
