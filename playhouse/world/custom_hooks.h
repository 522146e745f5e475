#pragma once

/// How engines call the code of custom models (custom_kind.h): what all of them have to do around a hook.
/// Thread: any worker, for models of its own range.

#include <cstdint>
#include <exception>
#include <span>

#include "playhouse/base/in_quotes.h"
#include "playhouse/world/custom_kind.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// The code of a model; null if it has none.
const CustomCode* custom_code(const World& world, ModelRow model);

/// Logs what is wrong with a model, unless something of models like it was logged before.
void complain(const World& world, ModelRow model, const CustomCode& code, const char* why);

bool all_finite(std::span<const double> numbers);

/// What every hook gets, for the state of `tick`.
CustomModel custom_model(const World& world, CustomRow custom, std::uint64_t tick, Purpose purpose);

/// Calls a hook of the model. False, and a complaint, if it throws.
template <typename Hook>
bool call_hook(const CustomModel& self, const CustomCode& code, const Hook& hook) {
  try {
    hook();
    return true;
  } catch (const std::exception& error) {
    complain(self.world, self.model, code, escaped(error.what()).c_str());
  } catch (...) {
    complain(self.world, self.model, code, "threw something that is no std::exception");
  }
  return false;
}

/// Gives a model that has not begun its commands and its state. Does nothing for others.
void begin_custom(World& world, CustomRow custom);

}  // namespace playhouse::world
