#include "playhouse/app/descriptor_limit.h"

#include <sys/resource.h>

namespace playhouse::app {

void raise_descriptor_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);  // failure leaves the old limit
}

}  // namespace playhouse::app
