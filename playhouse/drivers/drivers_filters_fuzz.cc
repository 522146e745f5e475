/// The small drivers of scans, motion and maps, on devices that answer, publish and are told anything. What they tell
/// wheels on their own are numbers, and what they publish can be decoded.

#include <cmath>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/maps/map_filter.h"
#include "playhouse/drivers/maps/mapcspace.h"
#include "playhouse/drivers/maps/mapscale.h"
#include "playhouse/drivers/motion/bumper_safe.h"
#include "playhouse/drivers/motion/deadstop.h"
#include "playhouse/drivers/motion/differential.h"
#include "playhouse/drivers/motion/goto.h"
#include "playhouse/drivers/motion/lasersafe.h"
#include "playhouse/drivers/motion/suppressor.h"
#include "playhouse/drivers/scans/laser_filter.h"
#include "playhouse/drivers/scans/lasercspace.h"
#include "playhouse/drivers/scans/lasercutter.h"
#include "playhouse/drivers/scans/laserposeinterpolator.h"
#include "playhouse/drivers/scans/laserrescan.h"
#include "playhouse/drivers/scans/lasertoranger.h"
#include "playhouse/drivers/scans/sonartoranger.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/position1d.h"

namespace playhouse::drivers {
namespace {

namespace lsr = wire::laser;
namespace p1d = wire::position1d;
namespace p2d = wire::position2d;
namespace rng = wire::ranger;

constexpr device::DeviceId kRobot{0}, kLaser{1}, kSonar{2}, kMap{3}, kBumper{4}, kLeft{5}, kRight{6},
    kGoalRobot{7};  // of the source
constexpr device::DeviceId kCut{10}, kRescanned{11}, kFree{12}, kPosed{13}, kOfLaser{14}, kOfSonar{15},
    kDead{16}, kBumperSafe{17}, kLaserSafe{18}, kDifferential{19}, kGoto{20}, kMaster{21}, kSlave{22},
    kGrown{23}, kScaled{24};
constexpr std::uint32_t kMostSide = 24;  // cells of a map

wire::Pose2d any_pose2d(FuzzScript& script) {
  return {script.number(), script.number(), script.number()};
}
wire::Pose3d any_pose3d(FuzzScript& script) {
  return {script.number(), script.number(), script.number(), 0, 0, script.number()};
}
float any_float(FuzzScript& script) {
  return static_cast<float>(script.number());
}
std::vector<float> any_floats(FuzzScript& script) {
  std::vector<float> values(script.byte() % 40);
  for (float& value : values) value = any_float(script);
  return values;
}
lsr::Data any_scan(FuzzScript& script) {
  const auto angle = any_float(script), last = any_float(script), step = any_float(script),
             most = any_float(script);
  lsr::Data scan{angle, last, step, most, any_floats(script), {}, 0};
  scan.intensity.resize(script.byte() % 40);
  return scan;
}
/// An option of a file is a number.
double any_option(FuzzScript& script, double otherwise, double least) {
  const double value = script.number();
  return std::isfinite(value) && value >= least ? value : otherwise;
}

class Source final : public device::Driver, public device::Opener {
 public:
  explicit Source(FuzzScript& script) : script_(script) {}

  std::string_view name() const override { return "source"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message& message) override {
    if (message.device == kLeft || message.device == kRight) {
      PLAYHOUSE_ASSERT(std::isfinite(wire::decode<p1d::CmdVel>(message.body)->vel));
    } else if (message.device == kGoalRobot && message.subtype == p2d::kCmdVel) {
      const wire::Pose2d velocity = wire::decode<p2d::CmdVel>(message.body)->vel;
      PLAYHOUSE_ASSERT(std::isfinite(velocity.px) && std::isfinite(velocity.pa));
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
    replier.ack(answer(message));
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return true; }
  Result<void> hold(device::DeviceId, device::Driver*) override { return {}; }
  void release(device::DeviceId, device::Driver*) override {}

 private:
  std::vector<std::byte> answer(const device::Message& message) {
    if (message.device == kMap) return message.subtype == wire::map::kReqGetInfo ? info() : tile(message);
    if (message.device == kLaser && message.subtype == lsr::kReqGetConfig)
      return wire::encode(lsr::Config{any_float(script_), any_float(script_), any_float(script_),
                                      any_float(script_), any_float(script_), script_.byte(),
                                      any_float(script_)});
    if (message.device == kSonar) return wire::encode(wire::sonar::Geom{{any_pose3d(script_)}});
    if (message.device == kLaser) return wire::encode(lsr::Geom{any_pose3d(script_), {}});
    return wire::encode(
        p2d::Geom{any_pose3d(script_), {script_.number(), script_.number(), script_.number()}});
  }
  std::vector<std::byte> info() {
    return wire::encode(wire::map::Info{any_float(script_), script_.byte() % kMostSide,
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
      if (message.device == kFree && message.subtype == lsr::kDataScan) {
        const lsr::Data scan = *wire::decode<lsr::Data>(message.body);
        for (const float range : scan.ranges) PLAYHOUSE_ASSERT(range >= 0);
      } else if (message.device == kDifferential) {
        const wire::Pose2d pose = wire::decode<p2d::Data>(message.body)->pos;
        PLAYHOUSE_ASSERT(std::isfinite(pose.px) && std::isfinite(pose.py) && std::isfinite(pose.pa));
      } else if (message.device == kOfLaser) {
        PLAYHOUSE_ASSERT(wire::decode<rng::DataRange>(message.body).ok());
      }
    }
  }
  void answer(std::uint64_t, bool, std::vector<std::byte>) override {}
};

class Workshop {
 public:
  explicit Workshop(FuzzScript& script) : script_(script), source_(script) {
    flow_.pass_to(published_);
    const double right = any_option(script, -1, -1e9);
    cut_.begin<LaserFilter<LaserCutter>>(LaserCutter{right, any_option(script, right, right)});
    rescanned_.begin<LaserFilter<LaserRescan>>(
        LaserRescan{right, any_option(script, right, right), 1 + script.byte()});
    free_.begin<LaserFilter<LaserCSpace>>(LaserCSpace{any_option(script, 0.5, 0), 1 + script.byte() % 8});
    PoseStampOptions stamps;
    stamps.all = script.byte() % 2 == 0;
    stamps.distance = any_option(script, -1, -1);
    posed_.begin<LaserPoseInterpolator>(stamps);
    of_laser_.begin<ToRanger<LaserSource>>();
    of_sonar_.begin<ToRanger<SonarSource>>();
    dead_.begin<DeadStop>(DeadStopOptions{any_option(script, 0.5, 0)});
    bumper_safe_.begin<BumperSafe>();
    LaserSafeOptions safe;
    safe.is_box = script.byte() % 2 == 0;
    safe.history = 1 + script.byte() % 4;
    laser_safe_.begin<LaserSafe>(safe);
    differential_.begin<Differential>(DifferentialOptions{any_option(script, 0.25, 0.001)});
    goto_.begin<Goto>(GotoOptions());
    suppressor_.begin<Suppressor>(SuppressorOptions{any_option(script, 0, 0)});
    grown_.begin<FilteredMap>(
        [radius = any_option(script, 0.2, 0)](const GridMap& map) { return MapCSpace{radius}.map(map); });
    scaled_.begin<FilteredMap>([size = 0.05 + 0.05 * script.byte()](const GridMap& map) -> Result<GridMap> {
      constexpr float kFinest = 1e-3f, kCoarsest = 0.5f;  // else it may have many cells
      if (!(map.info.scale > kFinest && map.info.scale < kCoarsest)) return Error{{}, "is none"};
      return MapScale{size}.map(map);
    });
    connect(cut_, {kLaser}, {kCut});
    connect(rescanned_, {kLaser}, {kRescanned});
    connect(free_, {kLaser}, {kFree});
    connect(posed_, {kLaser, kRobot}, {kPosed});
    connect(of_laser_, {kLaser}, {kOfLaser});
    connect(of_sonar_, {kSonar}, {kOfSonar});
    connect(dead_, {kRobot}, {kDead});
    connect(bumper_safe_, {kRobot, kBumper}, {kBumperSafe});
    connect(laser_safe_, {kRobot, kLaser}, {kLaserSafe});
    connect(differential_, {kLeft, kRight}, {kDifferential});
    connect(goto_, {kGoalRobot}, {kGoto});
    connect(suppressor_, {kRobot}, {kMaster, kSlave});
    connect(grown_, {kMap}, {kGrown});
    connect(scaled_, {kMap}, {kScaled});
  }

  void step() {
    switch (script_.byte() % 4) {
      case 0:
        return commands();
      case 1:
        return requests();
      default:
        return data();
    }
  }

 private:
  struct Opened {
    Shell* driver;
    std::vector<device::DeviceId> devices;
  };
  void connect(Shell& driver, const std::vector<device::DeviceId>& devices,
               const std::vector<device::DeviceId>& own) {
    for (std::size_t i = 0; i < devices.size(); ++i) driver.client().use(i, devices[i], source_);
    driver.client().join(flow_);
    driver.provide(own);
    PLAYHOUSE_ASSERT(driver.start({}).ok());
    opened_.push_back({&driver, own});
  }
  void each(const std::function<void(Shell&, device::DeviceId)>& call) {
    for (const Opened& opened : opened_)
      for (const device::DeviceId device : opened.devices) call(*opened.driver, device);
  }

  void commands() {
    const std::vector<std::byte> velocity = wire::encode(p2d::CmdVel{any_pose2d(script_), 1}),
                                 goal = wire::encode(p2d::CmdPos{any_pose2d(script_), {}, 1}),
                                 car = wire::encode(p2d::CmdCar{script_.number(), script_.number()});
    const std::uint8_t kind = script_.byte() % 4;
    const auto& body = kind == 0 ? velocity : kind == 1 ? goal : car;
    const std::uint8_t subtype = kind == 0   ? p2d::kCmdVel
                                 : kind == 1 ? p2d::kCmdPos
                                 : kind == 2 ? p2d::kCmdCar
                                             : p2d::kCmdVelHead;
    each([&](Shell& driver, device::DeviceId device) {
      if (device != kGoto || kind == 1)
        driver.command({device, 2, subtype, body});  // else it passes on what it is told
    });
  }

  void requests() {
    const std::uint8_t subtype = script_.byte();
    const auto raw = script_.take(script_.byte() % 64);
    each([&](Shell& driver, device::DeviceId device) {
      driver.request({device, 3, subtype, raw}, {published_, 1});
      driver.capable(device, 3, subtype);
    });
  }

  void data() {
    const double time = script_.number();
    const std::vector<std::byte> state =
        wire::encode(p2d::Data{any_pose2d(script_), any_pose2d(script_), script_.byte()});
    std::vector<std::uint8_t> pressed(script_.byte() % 8);
    for (std::uint8_t& each : pressed) each = script_.byte() % 2;
    const p1d::Data left{0, any_float(script_), 0, 0}, right{0, any_float(script_), script_.byte(), 0};
    const lsr::Data scan = any_scan(script_);
    flow_.publish(
        {{kRobot, p2d::kDataState, time, state},
         {kGoalRobot, p2d::kDataState, time, state},
         {kBumper, wire::bumper::kDataState, time, wire::encode(wire::bumper::Data{pressed})},
         {kLeft, p1d::kDataState, time, wire::encode(left)},
         {kRight, p1d::kDataState, time, wire::encode(right)},
         {kLaser, lsr::kDataScan, time, wire::encode(scan)},
         {kLaser, lsr::kDataScanpose, time, wire::encode(lsr::DataScanpose{scan, any_pose2d(script_)})},
         {kSonar, wire::sonar::kDataRanges, time, wire::encode(wire::sonar::Data{any_floats(script_)})}});
  }

  FuzzScript& script_;
  Source source_;
  Published published_;
  device::DataFlow flow_;
  std::vector<Opened> opened_;
  Shell cut_{"lasercutter", source_, 1}, rescanned_{"laserrescan", source_, 1},
      free_{"lasercspace", source_, 1}, posed_{"laserposeinterpolator", source_, 2},
      of_laser_{"lasertoranger", source_, 1}, of_sonar_{"sonartoranger", source_, 1},
      dead_{"deadstop", source_, 1}, bumper_safe_{"bumper_safe", source_, 2},
      laser_safe_{"lasersafe", source_, 2}, differential_{"differential", source_, 2},
      goto_{"goto", source_, 1}, suppressor_{"suppressor", source_, 1}, grown_{"mapcspace", source_, 1},
      scaled_{"mapscale", source_, 1};
};

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::FuzzScript script(std::as_bytes(std::span(data, size)));
  playhouse::drivers::Workshop workshop(script);
  for (int step = 0; step < 64 && !script.done(); ++step) workshop.step();
  return 0;
}
