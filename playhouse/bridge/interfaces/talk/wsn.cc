/// A mote as interface wsn (docs/drivers.md).

#include "playhouse/wire/generated/wsn.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"

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

class Wsn final : public SimulatedDevice {
 public:
  Wsn(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

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
    raw_ = value->value == 0;
    replier.ack();
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const MoteRow own = world.models.part[row];
    if (!mote_of(world, own).base) {
      if (world.motes.reported_tick[own] == world.tick()) tell(world, own, own, out);
      return;
    }
    for (const world::MoteLink& link : world.motes.links[own])
      if (const world::ModelRow heard = link.heard ? world.row(link.station) : world::ModelRow{})
        tell(world, world.models.part[heard], own, out);
  }

  void closed(world::Journal&) override { raw_ = false; }

 private:
  void tell(const world::World& world, MoteRow mote, MoteRow parent,
            std::vector<device::Publication>& out) const {
    publish(world, wsn::kDataState,
            wsn::Data{mote_of(world, mote).node_type, node_id(world, mote), node_id(world, parent),
                      readings(world, mote, raw_)},
            out);
  }

  void set_power(const device::Message& message, device::Replier replier) const {
    const auto value = wire::decode<wsn::PowerConfig>(message.body);
    if (!value || value->value > 1) return;
    command(std::move(replier), {value->node_id, value->group_id},
            [awake = value->value == 1](world::ModelId mote) {
              return world::Change(world::changes::WakeMote{mote, awake});
            });
  }
  void set_rate(const device::Message& message, device::Replier replier) const {
    const auto value = wire::decode<wsn::DatafreqConfig>(message.body);
    if (!value) return;
    command(std::move(replier), {value->node_id, value->group_id},
            [frequency = value->frequency](world::ModelId mote) {
              return world::Change(world::changes::SetReportRate{mote, frequency});
            });
  }

  /// Changes each mote that is meant and in reach of a base station, or this one; NACK if there is none.
  template <typename MakeChange>
  void command(device::Replier replier, Addressed addressed, MakeChange change) const {
    answer_by(std::move(replier), [id = model(), addressed, change](world::Journal& journal) {
      bool is_done = false;
      for (const world::ModelId mote : in_reach(journal.world(), id)) {
        const world::ModelRow row = journal.world().row(mote);
        if (!row || !addressed.has(journal.world(), world::MoteRow(journal.world().models.part[row])))
          continue;
        is_done = journal.apply(change(mote)) || is_done;
      }
      return is_done ? std::optional(Bytes()) : std::nullopt;
    });
  }
  static std::vector<world::ModelId> in_reach(const world::World& world, world::ModelId id) {
    const world::ModelRow row = world.row(id);
    if (!row) return {};
    const MoteRow own = world.models.part[row];
    if (!mote_of(world, own).base) return {id};
    std::vector<world::ModelId> motes;
    for (const world::MoteLink& link : world.motes.links[own]) motes.push_back(link.station);
    return motes;
  }

  std::atomic<bool> raw_{false};
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_wsn_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Wsn>(simulation, model);
}

}  // namespace playhouse::drivers
