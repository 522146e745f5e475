#pragma once

/// Calls of custom models' code (custom_kind.h), as all engines
/// do them. Thread: any worker, for models of its own range.

#include <cstdint>
#include <exception>
#include <span>

#include "playhouse/base/in_quotes.h"
#include "playhouse/world/custom_kind.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// The code of a model; null if there is none.
const CustomCode* custom_code(const World& world, ModelRow model);

/// Logs an error of a model, once for all models that share its code.
void complain(const World& world, ModelRow model, const CustomCode& code, const char* why);

bool all_finite(std::span<const double> numbers);

/// The common arguments of all hooks, for the state of `tick`.
CustomModel custom_model(const World& world, CustomRow custom, std::uint64_t tick, Purpose purpose);

/// Calls a hook of a model. Returns false and logs if it throws.
template <typename Hook>
bool call_hook(const CustomModel& self, const CustomCode& code, const Hook& hook) {
  try {
    hook();
    return true;
  } catch (const std::exception& error) {
    complain(self.world, self.model, code, escaped(error.what()).c_str());
  } catch (...) {
    complain(self.world, self.model, code, "threw something that is not a std::exception");
  }
  return false;
}

/// Initialises state and commands of a model that has not begun; no effect on others.
void begin_custom(World& world, CustomRow custom);

}  // namespace playhouse::world
