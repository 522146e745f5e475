#pragma once

/// The .cfg driver "suppressor": two sources of commands to one device, of which one, the master, silences the other.

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct SuppressorOptions {
  double fadeout = 0;  // s, after a command of the master
};

Result<SuppressorOptions> suppressor_options(SectionFields fields);

/// Provides the master and the slave. Time is that of the device's newest data.
class Suppressor final : public Algorithm {
 public:
  Suppressor(Shell& shell, const SuppressorOptions& options);

  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kMaster = 0, kSlave = 1;  // provided devices

  device::Taken take(const device::Message& message, std::size_t from);

  Shell& shell_;
  const SuppressorOptions options_;
  device::Subscription& data_;

  std::mutex mutex_;               // guards what follows
  double now_ = 0;                 // s
  std::optional<double> told_at_;  // s; by the master
};

extern const DriverDefinition kSuppressorDriver;

}  // namespace playhouse::drivers
