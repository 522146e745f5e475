#pragma once

#include <functional>
#include <vector>

#include "playhouse/app/service.h"

namespace playhouse::app {

/// Takes a service through all its steps, starting with `read`, runs it, prints its addresses and
/// outcome, and returns the exit code, kFailed if something was not saved or recorded. `opened`
/// is called with the ports once clients can connect; states are saved at the times in `saves`.
int run_service(Service& service, const std::function<Result<void>()>& read, const Running& running,
                const std::function<void(const std::vector<std::uint16_t>& ports)>& opened = {},
                const std::vector<SaveAt>& saves = {});

}  // namespace playhouse::app
