/// A mote as interface wsn (docs/drivers.md).

#include "playhouse/wire/generated/wsn.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/settings/settings.h"

namespace playhouse::drivers {
namespace {

namespace wsn = wire::wsn;
using wire::MessageType;
using world::MoteRow;

constexpr std::int32_t kAllMotes = -1;           // of a node id and of a group
constexpr float kNotMeasured = -1;               // light and sound
constexpr double kCounts = 1023;                 // of a converter of 10 bits
constexpr double kColdest = -40, kWarmest = 85;  // degC, at its ends

/// A reading as counts of the converter, between what is 0 and what is all of them.
float counts(double value, double low, double high) {
  const double share = high > low ? (value - low) / (high - low) : 0;
  return static_cast<float>(std::lround(kCounts * std::clamp(share, 0.0, 1.0)));
}

const scene::MoteDesc& mote_of(const world::World& world, MoteRow mote) {
  return *world.desc(world.motes.model[mote]).mote;
}

std::uint32_t node_id(const world::World& world, MoteRow mote) {
  const std::uint32_t given = mote_of(world, mote).node_id;
  return given != 0 ? given : world.id(world.motes.model[mote]).value + 1;
}

wsn::NodeData readings(const world::World& world, MoteRow mote, bool raw) {
  const world::Motes& motes = world.motes;
  const scene::MoteDesc& desc = mote_of(world, mote);
  const geom::Vec3& f = motes.acceleration[mote];
  const double most = desc.acceleration_range;
  const auto told = [raw](double value, double low, double high) {
    return raw ? counts(value, low, high) : static_cast<float>(value);
  };
  wsn::NodeData data;
  data.light = data.mic = kNotMeasured;
  data.accel_x = told(f.x, -most, most);
  data.accel_y = told(f.y, -most, most);
  data.accel_z = told(f.z, -most, most);
  data.temperature = told(motes.temperature[mote], kColdest, kWarmest);
  data.battery = told(motes.volts[mote], 0, desc.volts_full);
  return data;
}

/// Whom a request is for.
struct Addressed {
  std::int32_t node = kAllMotes, group = kAllMotes;

  bool has(const world::World& world, MoteRow mote) const {
    const auto is = [](std::int32_t wanted, std::uint32_t id) {
      return wanted == kAllMotes || static_cast<std::uint32_t>(wanted) == id;
    };
    return is(node, node_id(world, mote)) && is(group, mote_of(world, mote).group);
  }
};

struct WsnSettings {
  bool raw = false;
};

class Wsn final : public DeviceWithSettings<WsnSettings> {
 public:
  Wsn(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithSettings(simulation, simulation.world().id(model), WsnSettings{}) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, wsn::kReqPower},
        {MessageType::kReq, wsn::kReqDatatype},
        {MessageType::kReq, wsn::kReqDatafreq},
    };
    return kServed;
  }
  bool acts(std::uint8_t request) const override { return request != wsn::kReqDatatype; }

  void request(const device::Message& message, device::Replier replier) override {
    if (message.subtype == wsn::kReqPower) return set_power(message, std::move(replier));
    if (message.subtype == wsn::kReqDatafreq) return set_rate(message, std::move(replier));
    const auto value = wire::decode<wsn::DatatypeConfig>(message.body);
    if (!value || value->value > 1) return;
    change_settings(std::move(replier), [raw = value->value == 0](WsnSettings& wanted) {
      wanted.raw = raw;
      return true;
    });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const MoteRow own = world.models.part[row];
    if (mote_of(world, own).base) {
      tell_heard(world, own, out);
    } else if (world.motes.reported_tick[own] == world.tick()) {
      tell(world, own, own, out);
    }
    if (knows_reach(world, row)) post_waiting();
  }

  void ended(world::Journal& journal) override {
    waiting_.clear();  // without an answer is NACK
    DeviceWithSettings::ended(journal);
  }

 private:
  /// Changes motes that a request is for; false if there is none.
  using Command = std::function<bool(world::Journal&)>;
  struct Waiting {
    std::shared_ptr<device::Replier> replier;
    Command command;
  };

  bool settle(WsnSettings&) const override { return true; }

  void tell(const world::World& world, MoteRow mote, MoteRow parent,
            std::vector<device::Publication>& out) const {
    publish(world, wsn::kDataState,
            wsn::Data{mote_of(world, mote).node_type, node_id(world, mote), node_id(world, parent),
                      readings(world, mote, settings().raw)},
            out);
  }

  /// No more than a client can be owed; begins after the last one told, so that all motes have their turn.
  void tell_heard(const world::World& world, MoteRow own, std::vector<device::Publication>& out) {
    const std::vector<world::MoteLink>& links = world.motes.links[own];
    const auto after = std::ranges::upper_bound(links, last_told_, {}, &world::MoteLink::station);
    const std::size_t first = static_cast<std::size_t>(after - links.begin());
    std::size_t left = limits::kSessionQueueMessages;
    for (std::size_t i = 0; i < links.size() && left > 0; ++i) {
      const world::MoteLink& link = links[(first + i) % links.size()];
      const world::ModelRow heard = link.heard ? world.row(link.station) : world::ModelRow{};
      if (!heard) continue;
      tell(world, world.models.part[heard], own, out);
      last_told_ = link.station;
      --left;
    }
    if (left > 0) last_told_ = {};
  }

  void set_power(const device::Message& message, device::Replier replier) {
    const auto value = wire::decode<wsn::PowerConfig>(message.body);
    if (!value || value->value > 1) return;
    command(std::move(replier), {value->node_id, value->group_id},
            [awake = value->value == 1](world::ModelId mote) {
              return world::Change(world::changes::WakeMote{mote, awake});
            });
  }
  void set_rate(const device::Message& message, device::Replier replier) {
    const auto value = wire::decode<wsn::DatafreqConfig>(message.body);
    if (!value) return;
    command(std::move(replier), {value->node_id, value->group_id},
            [frequency = value->frequency](world::ModelId mote) {
              return world::Change(world::changes::SetReportRate{mote, frequency});
            });
  }

  /// Changes each mote that is meant and in reach of a base station, or this one; NACK if there is none.
  template <typename MakeChange>
  void command(device::Replier replier, Addressed addressed, MakeChange change) {
    post({std::make_shared<device::Replier>(std::move(replier)),
          [id = model(), addressed, change](world::Journal& journal) {
            bool is_done = false;
            for (const world::ModelId mote : in_reach(journal.world(), id)) {
              const world::ModelRow row = journal.world().row(mote);
              if (!row || !addressed.has(journal.world(), world::MoteRow(journal.world().models.part[row])))
                continue;
              is_done = journal.apply(change(mote)) || is_done;
            }
            return is_done;
          }});
  }
  static std::vector<world::ModelId> in_reach(const world::World& world, world::ModelId id) {
    const world::ModelRow row = world.row(id);
    if (!row) return {};
    const MoteRow own = world.models.part[row];
    if (!mote_of(world, own).base) return {id};
    if (world.models.subscribers[row] == 0) return {};  // not open
    std::vector<world::ModelId> motes;
    for (const world::MoteLink& link : world.motes.links[own]) motes.push_back(link.station);
    return motes;
  }

  /// False of a base station from when it is opened to the next tick, which measures.
  static bool knows_reach(const world::World& world, world::ModelRow row) {
    const MoteRow own = world.models.part[row];
    return !mote_of(world, own).base || world.motes.measured_tick[own] != 0 ||
           world.models.subscribers[row] == 0;
  }
  /// Waits for a tick if the base station has just been opened.
  void post(Waiting asked) {
    simulation().requests().post(
        [self = shared_from_this(), this, asked = std::move(asked)](world::Journal& journal) mutable {
          const world::ModelRow row = journal.world().row(model());
          if (row && !knows_reach(journal.world(), row)) {
            waiting_.push_back(std::move(asked));
          } else if (asked.command(journal)) {
            asked.replier->ack();
          } else {
            asked.replier->nack();
          }
        },
        robot());
  }
  void post_waiting() {
    for (Waiting& asked : std::exchange(waiting_, {})) post(std::move(asked));
  }

  std::vector<Waiting> waiting_;  // for the first tick of a base station
  world::ModelId last_told_;      // if not all were told that it heard; none: begin with the first one
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_wsn_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Wsn>(simulation, model);
}

}  // namespace playhouse::drivers
