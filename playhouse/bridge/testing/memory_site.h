#pragma once

/// A site for tests of .cfg drivers: devices that are only remembered, and worlds from memory with a
/// StillEngine.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/bridge/all_drivers.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/net/simulated.h"

namespace playhouse::drivers::testing {

/// Makes the drivers of a file at a site; "" or the error's line.
inline std::string build_drivers(const std::string& cfg, Site& site,
                                 std::vector<std::unique_ptr<device::Driver>>& drivers) {
  config::MemoryFiles none({});
  const Result<config::CfgFile> file = config::load_cfg_text(cfg, "test.cfg", none);
  if (!file) return file.error().line();
  Result<std::vector<std::unique_ptr<device::Driver>>> made = all_drivers().make(*file, site);
  if (!made) return made.error().line();
  drivers = std::move(*made);
  return "";
}

class MemorySite final : public Host {
 public:
  explicit MemorySite(std::string world, bool has_threads = true)
      : has_threads_(has_threads), world_text_(std::move(world)), site_(*this, 6665) {
    site_.data_flow().pass_to(recorder);
  }
  ~MemorySite() override {
    if (simulation_of(site_) != nullptr) simulation_of(site_)->discard();
  }

  /// Makes the drivers of a file; "" or the error's line.
  std::string build(const std::string& cfg) { return build_drivers(cfg, site_, drivers_); }

  /// "port:code:index=driver" of every device, in order of creation.
  std::vector<std::string> devices() const {
    std::vector<std::string> lines;
    for (const auto& [address, driver] : added_) {
      lines.push_back(std::to_string(address.robot) + ":" + std::to_string(address.interf) + ":" +
                      std::to_string(address.index) + "=" + std::string(driver->name()));
    }
    return lines;
  }
  device::DeviceId id(device::Address address) const { return *site_.find(address); }
  device::Driver& driver(device::Address address) const { return *added_[id(address).row].second; }
  Site& site() { return site_; }
  /// Does what was posted to the tick, so many ticks, and what was posted to the io thread meanwhile.
  void run(int ticks) {
    simulation_of(site_)->extend(static_cast<std::uint64_t>(ticks));
    simulation_of(site_)->run();
    hear();
  }
  /// Does what was posted to the io thread.
  void hear() {
    for (const std::function<void()>& task : std::exchange(posted_, {})) task();
  }

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    added_.emplace_back(address, &driver);
    return device::DeviceId{static_cast<std::uint32_t>(added_.size() - 1)};
  }
  void retire_device(device::DeviceId device) override {
    retired.push_back(device.row);
    const std::vector<device::Driver*> holders = std::exchange(held[device.row], {});
    device::Driver& driver = *added_[device.row].second;
    if (!holders.empty()) driver.stop(device);
    driver.forget(device);
    for (device::Driver* holder : holders)
      if (holder != nullptr) holder->retired(device);
  }
  Result<void> hold(device::DeviceId device, device::Driver* holder = nullptr) override {
    if (std::ranges::find(retired, device.row) != retired.end()) return Error{"", "the device has retired"};
    held[device.row].push_back(holder);
    return held[device.row].size() == 1 ? added_[device.row].second->start(device) : Result<void>();
  }
  void release(device::DeviceId device, device::Driver* holder = nullptr) override {
    std::vector<device::Driver*>& holders = held[device.row];
    const auto found = std::ranges::find(holders, holder);
    if (found == holders.end()) return;  // the device has retired
    holders.erase(found);
    if (holders.empty()) added_[device.row].second->stop(device);
  }
  Result<void> open_port(std::uint32_t port) override {
    if (port > last_port) return Error{std::to_string(port), "is in use"};
    ports.push_back(port);
    return {};
  }
  void post(std::function<void()> task) override { posted_.push_back(std::move(task)); }
  bool has_threads() const override { return has_threads_; }
  std::filesystem::path plugin_program() const override { return "/proc/self/exe"; }  // testing/main_test.cc
  net::SimulatedNetwork& network() override { return network_; }
  Result<std::unique_ptr<SiteWorld>> open_world(const std::string& path, Site& site) override {
    opened.push_back(path);
    scene_ = run::testing::scene_of(world_text_);
    return simulated_world(
        site, std::make_unique<run::Simulation>(
                  std::make_unique<run::testing::StillEngine>(scene_),
                  run::Simulation::SimulationOptions{
                      .speed = 0, .paused = false, .duration = 0, .clock = run::testing::no_time_passes}));
  }

  OutputRecorder recorder;
  std::map<std::uint32_t, std::vector<device::Driver*>> held;  // once per hold; null: nobody hears of its end
  std::vector<std::uint32_t> retired;                          // in this order
  std::vector<std::string> opened;
  std::vector<std::uint32_t> ports;  // opened after the first one
  std::uint32_t last_port = 65535;   // further ones are in use

 private:
  const bool has_threads_;
  net::SimulatedNetwork network_{1};
  std::string world_text_;
  scene::SceneDesc scene_;
  std::vector<std::pair<device::Address, device::Driver*>> added_;
  std::vector<std::function<void()>> posted_;
  Site site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
};

}  // namespace playhouse::drivers::testing
