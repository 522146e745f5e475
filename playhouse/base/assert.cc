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
  // What was said before may tell why. Where nobody reads, nothing must wait here.
  bool (*const task)() = before_abort;
  if (task == nullptr || task())
    std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace playhouse
