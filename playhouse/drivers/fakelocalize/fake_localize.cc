#include "playhouse/drivers/fakelocalize/fake_localize.h"

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

namespace lcl = wire::localize;
namespace p2d = wire::position2d;
namespace sim = wire::simulation;

FakeLocalize::FakeLocalize(Shell& shell, const FakeLocalizeOptions& options,
                           const FakeLocalizeDevices& devices, Site& site)
    : shell_(shell), options_(options), devices_(devices), site_(site) {
  if (!devices.localize) return;
  shell.on_request(lcl::kReqGetParticles, [this](const device::Message&, device::Replier replier) {
    if (const std::optional<geom::Pose> X_WR = newest())
      replier.ack(wire::encode(lcl::GetParticles{pose2d(*X_WR), 0, {{pose2d(*X_WR), 1}}}));
  });
}

std::optional<geom::Pose> FakeLocalize::newest() {
  const std::lock_guard lock(mutex_);
  return X_WR_;
}

void FakeLocalize::opened() {
  if (site_.world() == nullptr)
    log::warn(
        "driver fakelocalize: there is no simulated world in this program, so its pose is that of its "
        "opening");
  {
    const std::lock_guard lock(mutex_);
    asking_ = is_gone_ = false;
    X_WR_.reset();
  }
  ask();
}

void FakeLocalize::ticked() {
  if (shell_.client().is_open()) ask();
}

/// Unless an earlier question is not answered yet.
void FakeLocalize::ask() {
  {
    const std::lock_guard lock(mutex_);
    if (asking_ || is_gone_) return;
    asking_ = true;
  }
  const sim::Pose3dReq question{wire::c_string(options_.model), {}, 0};
  shell_.client().ask(0, sim::kReqGetPose3d, wire::encode(question),
                      [this](const AnswerBody& body) { take(body); });
}

void FakeLocalize::take(const AnswerBody& body) {
  const std::optional<sim::Pose3dReq> told = decoded<sim::Pose3dReq>(body);
  const std::optional<geom::Pose> X_WR = told ? planar(told->pose) : std::nullopt;
  {
    const std::lock_guard lock(mutex_);
    asking_ = false;
    is_gone_ = !X_WR;
    X_WR_ = X_WR;
  }
  if (X_WR) return publish(told->simtime / 1e6, *X_WR);
  log::warn("driver fakelocalize: the simulation does not tell where {} is, so it has no pose",
            in_quotes(options_.model));
}

void FakeLocalize::publish(double time, const geom::Pose& X_WR) {
  std::vector<device::Publication> batch;
  if (devices_.localize)
    batch.push_back({shell_.device(0), lcl::kDataHypoths, time,
                     wire::encode(lcl::Data{0, time, {{pose2d(X_WR), {}, 1}}})});
  if (devices_.position2d)
    batch.push_back({shell_.device(position_device()), p2d::kDataState, time,
                     wire::encode(p2d::Data{pose2d(X_WR), {}, 0})});
  site_.data_flow().publish(std::move(batch));
}

Result<FakeLocalizeOptions> fake_localize_options(SectionFields fields) {
  FakeLocalizeOptions options;
  options.model = fields.text({"model", "Name of the robot in the world.", {}, "required"});
  fields.expect(!options.model.empty(), "model", "is needed: the name of the robot in the world");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_fake_localize(const config::CfgSection& section, Site& site) {
  FakeLocalizeDevices devices;
  devices.position2d = names_device(section, "provides", "position2d");
  devices.localize = names_device(section, "provides", "localize") || !devices.position2d;
  WantedDevices wanted{.provides = {}, .uses = {{"simulation"}}};
  if (devices.localize) wanted.provides.push_back({"localize"});
  if (devices.position2d) wanted.provides.push_back({"position2d"});
  return make_algorithm<FakeLocalize>(section, site, wanted, fake_localize_options, devices, std::ref(site));
}

constexpr DeviceText kFakeLocalizeProvides[] = {
    {"localize", {}, HowMany::kSomeOfThese, "has one hypothesis, which is true"},
    {"position2d", {}, HowMany::kSomeOfThese, "has the pose in the world"}};
constexpr DeviceText kFakeLocalizeUses[] = {{"simulation", {}, HowMany::kOne, "knows where the robot is"}};

}  // namespace

constinit const DriverDefinition kFakeLocalizeDriver{
    .name = "fakelocalize",
    .doc = "Where a simulated robot is, as a localization that is always right.",
    .provides = kFakeLocalizeProvides,
    .uses = kFakeLocalizeUses,
    .read_options = reading<fake_localize_options>,
    .make = make_fake_localize,
};

}  // namespace playhouse::drivers
