#pragma once

/// Shell: the driver around an Algorithm. It has its devices, uses those that the section requires while one of
/// its own is open, runs its steps on a thread, passes commands and requests on, and follows the run. Devices
/// are numbered as the section's WantedDevices has them.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/algorithm.h"
#include "playhouse/drivers/algorithm/algorithm_thread.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {

class Shell final : public device::Driver, public RunListener {
 public:
  /// For an algorithm that uses so many devices.
  Shell(std::string name, device::Opener& opener, std::size_t uses,
        AlgorithmThread::Steps steps = AlgorithmThread::Steps::kOnThread);
  /// Makes the algorithm, from the shell and what else it takes.
  template <typename A, typename... Parts>
  A& begin(Parts&&... parts) {
    auto made = std::make_unique<A>(*this, std::forward<Parts>(parts)...);
    A& algorithm = *made;
    algorithm_ = std::move(made);
    return algorithm;
  }
  void provide(std::vector<device::DeviceId> devices) { provided_ = std::move(devices); }

  // For constructors of algorithms. A command or request that is not registered is refused.

  using TakeCommand = std::function<device::Taken(const device::Message&)>;
  using TakeRequest = std::function<void(const device::Message&, device::Replier)>;
  void on_command(std::uint8_t subtype, TakeCommand take, std::size_t device = 0);
  void on_request(std::uint8_t subtype, TakeRequest take, std::size_t device = 0);
  /// A body that is no T is refused.
  template <typename T>
  void on_command(std::uint8_t subtype, std::function<device::Taken(const T&)> take, std::size_t device = 0) {
    on_command(
        subtype,
        [take = std::move(take)](const device::Message& message) {
          const Result<T> value = wire::decode<T>(message.body);
          return value ? take(*value) : device::Taken::kNo;
        },
        device);
  }
  /// A request of body T is answered with a body, or NACK if there is none.
  template <typename T>
  void on_request(std::uint8_t subtype, std::function<AnswerBody(const T&)> answer, std::size_t device = 0) {
    on_request(
        subtype,
        [answer = std::move(answer)](const device::Message& message, device::Replier replier) {
          const Result<T> value = wire::decode<T>(message.body);
          if (!value) return;
          if (AnswerBody body = answer(*value)) replier.ack(std::move(*body));
        },
        device);
  }
  /// A request that a device which it uses answers.
  void forward_request(std::uint8_t subtype, std::size_t to, std::size_t device = 0);
  /// So are all of a device that are not registered; what becomes of such commands is up to `take`. Devices of `also`
  /// are asked the same, and what they answer is dropped.
  void forward_others(std::size_t to, TakeCommand take, std::size_t device = 0,
                      std::vector<std::size_t> also = {});
  /// The property "refusal" (refusal.h).
  void on_refusal_asked(std::function<std::string()> why) { refusal_ = std::move(why); }

  // For algorithms. Any thread.

  device::DeviceClient& client() { return client_; }
  device::DeviceId device(std::size_t provided) const { return provided_[provided]; }
  bool provides(std::size_t provided) const { return provided < provided_.size(); }
  void post(AlgorithmThread::AlgorithmStep step) { thread_.post(std::move(step)); }
  /// Drops steps (AlgorithmThread::clear()).
  void drop_steps() { thread_.clear(); }
  /// Of random numbers: of the run's seed and its first device.
  std::uint64_t seed() const { return seed_; }

  // device::Driver

  std::string_view name() const override { return name_; }
  bool ready(device::DeviceId) const override { return client_.ready(); }
  void prepare(device::DeviceId, Prepared heard) override { client_.prepare(std::move(heard)); }
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId) override { close(); }
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { client_.barrier(std::move(replier)); }

  /// Random numbers follow from a seed of its own and, in a simulated world, that of the run. Before the run.
  void set_seed(std::uint64_t own) { seed_ = own_seed_ = own; }
  /// Follows the run of a simulated world, as one of the devices of the model of `robot`: results of steps are due one
  /// tick after the step was posted. Fails if the algorithm can do nothing with that model. Before the run.
  Result<void> follow(SiteWorld& world, device::Address robot, std::span<const device::Address> own);

  // RunListener

  void ticked(std::uint64_t tick) override {
    thread_.ticked(tick);
    algorithm_->ticked();
  }
  void rewound(const Moment& moment) override;
  void placed() override { algorithm_->placed(); }

 private:
  struct RequestTaker {
    TakeRequest take;
    std::optional<std::size_t> by;  // the device that answers
  };
  struct Others {
    std::size_t to = 0;
    TakeCommand take;
    std::vector<std::size_t> also;
  };
  using DeviceSubtype = std::pair<std::size_t, std::uint8_t>;  // device and subtype
  std::size_t number_of(device::DeviceId device) const;
  const Others* others_of(device::DeviceId device) const;
  void close();

  const std::string name_;
  device::DeviceClient client_;
  std::vector<device::DeviceId> provided_;
  int open_ = 0;  // own devices; io thread
  std::uint64_t own_seed_ = 0;
  std::atomic<std::uint64_t> seed_ = 0;

  // Not changed once the algorithm is made.
  std::map<DeviceSubtype, TakeCommand> commands_;
  std::map<DeviceSubtype, RequestTaker> answers_;
  std::map<std::size_t, Others> others_;  // by device
  std::function<std::string()> refusal_;

  std::unique_ptr<Algorithm> algorithm_;
  AlgorithmThread thread_;  // last member: joined before what its steps use is destroyed
};

/// The devices of a section, of its fields "provides" and "requires".
struct WantedDevices {
  std::vector<WantedDevice> provides, uses;
};
struct Wired {
  std::vector<device::Address> provides, uses;  // as wanted
};
Result<Wired> wired(const config::CfgSection& section, const Site& site, const WantedDevices& wanted);
/// Registers the devices of a section's driver. The model of the first device that it uses is its robot.
Result<std::unique_ptr<device::Driver>> registered(const config::CfgSection& section, Site& site,
                                                   const Wired& devices, std::unique_ptr<Shell> shell);

template <typename A, typename... Parts>
Result<std::unique_ptr<device::Driver>> in_shell(const config::CfgSection& section, Site& site,
                                                 const Wired& devices, const Parts&... parts) {
  const AlgorithmThread::Steps steps = site.surroundings().has_threads() ? AlgorithmThread::Steps::kOnThread
                                                                         : AlgorithmThread::Steps::kOnCaller;
  auto shell = std::make_unique<Shell>(section.name(), site.surroundings(), devices.uses.size(), steps);
  shell->begin<A>(parts...);
  return registered(section, site, devices, std::move(shell));
}

/// The driver of a section: A in a shell, made from the section's options, if it has any, and `more`.
template <typename A>
Result<std::unique_ptr<device::Driver>> make_algorithm(const config::CfgSection& section, Site& site,
                                                       const WantedDevices& wanted) {
  const Result<Wired> devices = wired(section, site, wanted);
  if (!devices) return devices.error();
  return in_shell<A>(section, site, *devices);
}
template <typename A, typename ReadOptions, typename... More>
Result<std::unique_ptr<device::Driver>> make_algorithm(const config::CfgSection& section, Site& site,
                                                       const WantedDevices& wanted, ReadOptions read_options,
                                                       const More&... more) {
  const Result<Wired> devices = wired(section, site, wanted);
  if (!devices) return devices.error();
  const auto options = read_options(section);
  if (!options) return options.error();
  return in_shell<A>(section, site, *devices, *options, more...);
}

}  // namespace playhouse::drivers
