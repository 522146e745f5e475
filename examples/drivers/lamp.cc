// An actuator: a lamp behind a file, as those of /sys/class/leds, which is off (0) or on (1).
//
//   driver ( name "lamp" plugin "lamp" provides ["blinkenlight:0"] filename "/sys/class/leds/green/brightness" )
//
// It is switched off when the last client has gone.
#include <fstream>
#include <stdexcept>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/blinkenlight.h"

namespace lights = playhouse::wire::blinkenlight;
namespace pd = playhouse::drivers;

namespace {

class Lamp : public pd::Plugin {
  void configure(const pd::PluginSection& section) override {
    file_ = section.filename("filename", "");
    if (file_.empty()) throw std::invalid_argument("needs a filename");
    on_command<lights::CmdPower>(0, lights::kCmdPower,
                                 [this](const lights::CmdPower& power) { set(power.enable != 0); });
  }

  void close() override { set(false); }

  void set(bool on) {
    if (!(std::ofstream(file_) << (on ? 1 : 0) << std::flush))
      throw std::runtime_error("can't write " + file_);
    lights::Data state;
    state.enable = on ? 1 : 0;
    publish(0, lights::kDataState, state);
  }

  std::string file_;
};

}  // namespace

PLAYHOUSE_DRIVER(Lamp)
