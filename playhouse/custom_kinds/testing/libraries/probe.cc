// A custom model that does what its first argument says.
#include <stdexcept>

#include "playhouse/world/custom_library.h"

namespace pw = playhouse::world;

class Probe : public pw::CustomKind {
  Sizes configure(std::span<const std::string> arguments) override {
    const std::string what = arguments.empty() ? "" : arguments[0];
    if (what == "refuse") throw std::invalid_argument("wants another world\n[error] a forged line");
    if (what == "refuse_int") throw 5;
    if (what == "many") return {0, 0, 4097};
    if (what == "two" && arguments.size() != 3) throw std::invalid_argument("two wants two numbers");
    return {1, 2, 3};
  }
  void begin(const pw::CustomModel& self, std::span<double> state, std::span<double> command) const override {
    // Of the program: what is no inline function.
    state[0] = self.world.row(self.world.id(self.model)) == self.model ? 4 : 0;
    command[0] = 5;
  }
};

PLAYHOUSE_CUSTOM_KIND(Probe)
