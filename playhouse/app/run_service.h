#pragma once

#include <functional>
#include <vector>

#include "playhouse/app/service.h"

namespace playhouse::app {

/// Takes a service through all its steps, beginning with `read`, runs it, prints where it is and how it went,
/// and returns the program's exit code, kFailed where something was not saved or recorded. `opened` is called
/// with the ports when clients can connect; the state is saved at the times of `saves`.
int run_service(Service& service, const std::function<Result<void>()>& read, const Running& running,
                const std::function<void(const std::vector<std::uint16_t>& ports)>& opened = {},
                const std::vector<SaveAt>& saves = {});

}  // namespace playhouse::app
