#pragma once

/// The .cfg driver "fakelocalize": where a robot is, as the simulation knows it, for programs that need a localization.

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/localize.h"

namespace playhouse::drivers {

struct FakeLocalizeOptions {
  std::string model;  // name of the robot
};

Result<FakeLocalizeOptions> fake_localize_options(SectionFields fields);

/// Which devices a section provides, in this order.
struct FakeLocalizeDevices {
  bool localize = false, position2d = false;
};

/// Uses the simulation, and asks it once a tick.
class FakeLocalize final : public Algorithm {
 public:
  FakeLocalize(Shell& shell, const FakeLocalizeOptions& options, const FakeLocalizeDevices& devices,
               Site& site);

  void opened() override;
  void take_news(std::vector<device::Publication>&) override {}
  void ticked() override;

 private:
  std::optional<geom::Pose> newest();
  void ask();
  void take(const AnswerBody& body);
  void publish(double time, const geom::Pose& X_WR);
  std::size_t position_device() const { return devices_.localize ? 1 : 0; }

  Shell& shell_;
  const FakeLocalizeOptions options_;
  const FakeLocalizeDevices devices_;
  Site& site_;

  std::mutex mutex_;  // guards what follows
  bool asking_ = false, is_gone_ = false;
  std::optional<geom::Pose> X_WR_;  // the newest
};

extern const DriverDefinition kFakeLocalizeDriver;

}  // namespace playhouse::drivers
