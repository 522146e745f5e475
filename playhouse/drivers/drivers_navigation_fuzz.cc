/// The drivers that localize, plan and avoid, on devices that answer, publish and are told anything. What
/// they tell the robot and what they publish are numbers.

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/amcl/amcl.h"
#include "playhouse/drivers/nd/nd.h"
#include "playhouse/drivers/vfh/vfh.h"
#include "playhouse/drivers/wavefront/wavefront.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse/wire/generated/planner.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

namespace lcl = wire::localize;
namespace lsr = wire::laser;
namespace p2d = wire::position2d;
namespace rng = wire::ranger;
namespace snr = wire::sonar;

constexpr device::DeviceId kRobot{0}, kLaser{1}, kSonar{2}, kMap{3}, kRanger{9};   // of the source
constexpr device::DeviceId kLocalize{4}, kPlace{5}, kPlanner{6}, kVfh{7}, kNd{8};  // of the drivers
constexpr std::uint32_t kMostSide = 24;                                            // cells of a map

bool is_finite(const wire::Pose2d& pose) {
  return std::isfinite(pose.px) && std::isfinite(pose.py) && std::isfinite(pose.pa);
}

wire::Pose2d any_pose2d(FuzzScript& script) {
  return {script.number(), script.number(), script.number()};
}
wire::Pose3d any_pose3d(FuzzScript& script) {
  return {script.number(), script.number(), script.number(), 0, 0, script.number()};
}
std::vector<float> any_floats(FuzzScript& script) {
  std::vector<float> values(script.byte() % 40);
  for (float& value : values) value = static_cast<float>(script.number());
  return values;
}

/// A robot with its sensors and a map.
class Source final : public device::Driver, public device::Opener {
 public:
  explicit Source(FuzzScript& script) : script_(script) {}

  std::string_view name() const override { return "source"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message& message) override {
    if (message.subtype == p2d::kCmdVel) {
      const wire::Pose2d velocity = wire::decode<p2d::CmdVel>(message.body)->vel;
      PLAYHOUSE_ASSERT(is_finite(velocity));
    } else if (message.subtype == p2d::kCmdPos) {
      PLAYHOUSE_ASSERT(is_finite(wire::decode<p2d::CmdPos>(message.body)->pos));
    }
    return device::Taken::kLatest;
  }
  void request(const device::Message& message, device::Replier replier) override {
    const std::uint8_t kind = script_.byte();
    if (kind == 0) return;
    if (kind == 1) {
      const auto raw = script_.take(script_.byte());
      return replier.ack({raw.begin(), raw.end()});
    }
    if (message.device == kMap) {
      replier.ack(message.subtype == wire::map::kReqGetInfo ? info() : tile(message));
    } else if (message.device == kRobot) {
      const wire::Bbox3d size{script_.number(), script_.number(), script_.number()};
      replier.ack(wire::encode(p2d::Geom{any_pose3d(script_), size}));
    } else if (message.device == kLaser) {
      replier.ack(wire::encode(lsr::Geom{any_pose3d(script_), {}}));
    } else if (message.device == kRanger) {
      replier.ack(message.subtype == rng::kReqGetGeom ? wire::encode(ranger_geom()) : wire::encode(config()));
    } else {
      snr::Geom geom;
      for (int i = script_.byte() % 8; i > 0; --i) geom.poses.push_back(any_pose3d(script_));
      replier.ack(wire::encode(geom));
    }
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return true; }
  Result<void> hold(device::DeviceId, device::Driver*) override { return {}; }
  void release(device::DeviceId, device::Driver*) override {}

 private:
  rng::Geom ranger_geom() {
    rng::Geom geom{any_pose3d(script_), {}, {}, {}};
    for (int i = script_.byte() % 8; i > 0; --i) geom.element_poses.push_back(any_pose3d(script_));
    return geom;
  }
  rng::Config config() {
    return {script_.number(), script_.number(), script_.number(), script_.number(), script_.number(), 0, 0};
  }
  std::vector<std::byte> info() {
    return wire::encode(wire::map::Info{static_cast<float>(script_.number()), script_.byte() % kMostSide,
                                        script_.byte() % kMostSide, any_pose2d(script_)});
  }
  /// Not compressed, as of a server without zlib.
  std::vector<std::byte> tile(const device::Message& message) {
    wire::map::Data tile = *wire::decode<wire::map::Data>(message.body);
    tile.data_range = static_cast<std::int8_t>(script_.byte());
    tile.data.resize(std::size_t{tile.width} * tile.height);
    for (std::int8_t& cell : tile.data) cell = static_cast<std::int8_t>(script_.byte());
    return wire::encode(tile);
  }

  FuzzScript& script_;
};

class Published final : public device::Publisher, public device::Outlet {
 public:
  void publish(std::vector<device::Publication> batch) override {
    for (const device::Publication& message : batch) {
      if (message.device == kLocalize) {
        const lcl::Data data = *wire::decode<lcl::Data>(message.body);
        double sum = 0;
        for (const lcl::Hypoth& each : data.hypoths) {
          PLAYHOUSE_ASSERT(is_finite(each.mean));
          for (const double value : each.cov) PLAYHOUSE_ASSERT(std::isfinite(value));
          sum += each.alpha;
        }
        PLAYHOUSE_ASSERT(std::fabs(sum - 1) < 1e-9);
      } else if (message.device == kPlace) {
        PLAYHOUSE_ASSERT(is_finite(wire::decode<p2d::Data>(message.body)->pos));
      }
    }
  }
  void answer(std::uint64_t, bool, std::vector<std::byte>) override {}
};

AmclOptions few_particles() {
  AmclOptions options;
  options.max_particles = 200;
  return options;
}

class Course {
 public:
  explicit Course(FuzzScript& script) : script_(script), source_(script) {
    flow_.pass_to(published_);
    amcl_.begin<Amcl>(few_particles(), ScanInterface::kLaser);
    amcl_.provide({kLocalize, kPlace});
    wavefront_.begin<Wavefront>(WavefrontOptions(), ScanInterface::kLaser);
    wavefront_.provide({kPlanner});
    vfh_.begin<Vfh>(VfhOptions(), ScanInterface::kRanger);
    vfh_.provide({kVfh});
    nd_.begin<Nd>(NdOptions(),
                  std::vector{ScanInterface::kLaser, ScanInterface::kRanger, ScanInterface::kSonar});
    nd_.provide({kNd});
    connect(amcl_, {kRobot, kLaser, kMap}, {});
    connect(vfh_, {kRobot, kRanger}, {});
    connect(nd_, {kRobot, kRobot, kLaser, kRanger, kSonar}, {});
    connect(wavefront_, {kRobot, kPlace, kMap, kLaser}, {{kPlace, &amcl_}});
  }

  void step() {
    switch (script_.byte() % 8) {
      case 0:
        return goals();
      case 1: {
        const lcl::SetPose pose{any_pose2d(script_),
                                {script_.number(), script_.number(), script_.number(), script_.number(),
                                 script_.number(), script_.number()}};
        return amcl_.request({kLocalize, 3, lcl::kReqSetPose, wire::encode(pose)}, {published_, 1});
      }
      case 2:
        amcl_.rewound({1, script_.number(), script_.byte()});
        wavefront_.rewound({script_.byte()});
        vfh_.rewound({script_.byte()});
        return nd_.rewound({script_.byte()});
      case 3:
        amcl_.request({kLocalize, 3, lcl::kReqGetParticles, {}}, {published_, 1});
        return wavefront_.request({kPlanner, 3, wire::planner::kReqGetWaypoints, {}}, {published_, 1});
      default:
        return tick();
    }
  }

 private:
  /// Of which the drivers know the ticks that the fuzzer tells them.
  struct Run final : SiteWorld {
    double time() const override { return 0; }
    void between_ticks(std::function<void()> task) override { task(); }
    void forget(device::Address) override {}
    std::size_t sensors_of(device::Address) const override { return 1; }
    Moment join(device::Address, std::span<const device::Address>, RunListener&) override { return {}; }
  };
  struct Other {
    device::DeviceId id;
    device::Driver* driver;
  };
  void connect(Shell& driver, std::vector<device::DeviceId> devices, std::vector<Other> others) {
    for (std::size_t i = 0; i < devices.size(); ++i) {
      device::Driver* provider = &source_;
      for (const Other& other : others)
        if (other.id == devices[i]) provider = other.driver;
      driver.client().use(i, devices[i], *provider);
    }
    driver.client().join(flow_);
    PLAYHOUSE_ASSERT(driver.follow(run_, {}, {}).ok());
    PLAYHOUSE_ASSERT(driver.start({}).ok());
  }

  void goals() {
    const wire::Pose2d goal = any_pose2d(script_);
    const std::vector<std::byte> pos = wire::encode(p2d::CmdPos{goal, {}, 1});
    vfh_.command({kVfh, 2, p2d::kCmdPos, pos});
    nd_.command({kNd, 2, p2d::kCmdPos, pos});
    const std::vector<std::byte> plan = wire::encode(wire::planner::Cmd{goal});
    wavefront_.command({kPlanner, 2, wire::planner::kCmdGoal, plan});
  }

  void tick() {
    const double time = 0.1 * static_cast<double>(++tick_);
    const p2d::Data state{any_pose2d(script_), any_pose2d(script_), script_.byte()};
    lsr::Data scan;
    scan.min_angle = static_cast<float>(script_.number());
    scan.resolution = static_cast<float>(script_.number());
    scan.max_range = static_cast<float>(script_.number());
    scan.ranges = any_floats(script_);
    rng::DataRange ranges;
    for (const float range : any_floats(script_)) ranges.ranges.push_back(range);
    flow_.publish({{kRobot, p2d::kDataState, time, wire::encode(state)},
                   {kLaser, lsr::kDataScan, time, wire::encode(scan)},
                   {kRanger, rng::kDataRange, time, wire::encode(ranges)},
                   {kSonar, snr::kDataRanges, time, wire::encode(snr::Data{any_floats(script_)})}});
    amcl_.ticked(tick_);
    vfh_.ticked(tick_);
    nd_.ticked(tick_);
    wavefront_.ticked(tick_);
  }

  FuzzScript& script_;
  Run run_;
  Source source_;
  Published published_;
  device::DataFlow flow_;
  std::uint64_t tick_ = 0;
  Shell amcl_{"amcl", source_, 3}, wavefront_{"wavefront", source_, 4}, vfh_{"vfh", source_, 2},
      nd_{"nd", source_, 5};
};

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::FuzzScript script(std::as_bytes(std::span(data, size)));
  playhouse::drivers::Course course(script);
  for (int step = 0; step < 64 && !script.done(); ++step) course.step();
  return 0;
}
