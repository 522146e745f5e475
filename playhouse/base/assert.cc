#include "playhouse/base/assert.h"

#include <cstdio>
#include <cstdlib>

#include "playhouse/base/log_output.h"

namespace playhouse {

void assert_failed(const char* condition, const char* file, int line) {
  // What was said before may tell why. Where nobody reads, nothing must wait here.
  if (log::flush()) std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace playhouse
