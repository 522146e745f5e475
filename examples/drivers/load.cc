// A sensor: how many programs want a processor of this machine, as the voltages of an aio: means of the last
// 1, 5 and 15 minutes.
//
//   driver ( name "load" plugin "load" provides ["aio:0"] interval 1 )
//
// interval: seconds between two readings. filename: what to read instead of /proc/loadavg.
#include <fstream>
#include <stdexcept>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/aio.h"

namespace aio = playhouse::wire::aio;
namespace pd = playhouse::drivers;

namespace {

class Load : public pd::Plugin {
  void configure(const pd::PluginSection& section) override {
    file_ = section.filename("filename", "/proc/loadavg");
    step_every(section.number("interval", 1));
  }

  void step() override {
    std::ifstream in(file_);
    aio::Data data;
    data.voltages.resize(3);
    if (!(in >> data.voltages[0] >> data.voltages[1] >> data.voltages[2]))
      throw std::runtime_error("no load in " + file_);
    publish(0, aio::kDataState, data);
  }

  std::string file_;
};

}  // namespace

PLAYHOUSE_DRIVER(Load)
