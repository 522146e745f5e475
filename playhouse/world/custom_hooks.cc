#include "playhouse/world/custom_hooks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log_at.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

const CustomCode* custom_code(const World& world, ModelRow model) {
  const std::uint32_t desc = world.models.desc[model];
  return desc < world.custom_codes.size() ? world.custom_codes[desc].get() : nullptr;
}

void complain(const World& world, ModelRow model, const CustomCode& code, const char* why) {
  if (code.complained.test_and_set()) return;
  log::error_at(world.scene().at(world.where(model)), "custom model {} of {}: {}",
                in_quotes(world.desc(model).custom->library), in_quotes(world.name(model)), why);
}

bool all_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

CustomModel custom_model(const World& world, CustomRow custom, std::uint64_t tick, Purpose purpose) {
  const ModelRow model = world.customs.model[custom];
  return {.world = world,
          .model = model,
          .time = world.time_of(tick),
          .dt = world.scene().interval,
          .used = is_used(world, model),
          .command = world.customs.command[custom],
          .random = Rng(world.seed(), tick, {purpose, world.serial(model)})};
}

void begin_custom(World& world, CustomRow custom) {
  const ModelRow model = world.customs.model[custom];
  const CustomCode* const code = custom_code(world, model);
  std::vector<double>& state = world.customs.state[custom];
  std::vector<double>& command = world.customs.command[custom];
  if (!code || (state.size() == code->sizes.state && command.size() == code->sizes.commands)) return;
  state.assign(code->sizes.state, 0);
  command.assign(code->sizes.commands, 0);
  const CustomModel self = custom_model(world, custom, world.tick(), Purpose::kCustomAct);
  const bool begun = call_hook(self, *code, [&] { code->kind->begin(self, state, command); });
  if (begun && all_finite(state) && all_finite(command)) return;
  if (begun) complain(world, model, *code, "begins with a number that is not finite");
  std::ranges::fill(state, 0);
  std::ranges::fill(command, 0);
}

bool command_custom(World& world, CustomRow custom, std::uint32_t which, double value) {
  begin_custom(world, custom);
  std::vector<double>& command = world.customs.command[custom];
  if (which >= command.size() || !std::isfinite(value)) return false;
  command[which] = value;
  return true;
}

}  // namespace playhouse::world
