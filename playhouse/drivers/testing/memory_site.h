#pragma once

/// A site for tests of .cfg drivers: devices that are only remembered, and worlds from memory with a
/// StillEngine.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/testing/still_engine.h"

namespace playhouse::drivers::testing {

class MemorySite final : public Surroundings {
 public:
  explicit MemorySite(std::string world) : world_text_(std::move(world)), site_(*this, 6665) {
    site_.data_flow().pass_to(recorder);
  }
  ~MemorySite() override {
    if (site_.simulation() != nullptr) site_.simulation()->discard();
  }

  /// Makes the drivers of a file; "" or the error's line.
  std::string build(const std::string& cfg) {
    scene::MemoryFiles none({});
    const Result<scene::CfgFile> file = scene::load_cfg_text(cfg, "test.cfg", none);
    if (!file) return file.error().line();
    Registry registry;
    register_drivers(registry);
    Result<std::vector<std::unique_ptr<device::Driver>>> made = make_drivers(registry, *file, site_);
    if (!made) return made.error().line();
    drivers_ = std::move(*made);
    return "";
  }

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
  void run(int ticks) {
    site_.simulation()->extend(static_cast<std::uint64_t>(ticks));
    site_.simulation()->run();
  }

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    added_.emplace_back(address, &driver);
    return device::DeviceId{static_cast<std::uint32_t>(added_.size() - 1)};
  }
  Result<void> hold(device::DeviceId device) override {
    if (held[device.row]++ == 0) return added_[device.row].second->start(device);
    return {};
  }
  void release(device::DeviceId device) override {
    if (--held[device.row] == 0) added_[device.row].second->stop(device);
  }
  Result<std::unique_ptr<Simulation>> open_world(const std::string& path) override {
    opened.push_back(path);
    scene_ = scene_of(world_text_);
    return std::make_unique<Simulation>(std::make_unique<StillEngine>(scene_),
                                        Simulation::Options{.speed = 0, .paused = false, .duration = 0});
  }

  Recorder recorder;
  std::map<std::uint32_t, int> held;
  std::vector<std::string> opened;

 private:
  std::string world_text_;
  scene::SceneDesc scene_;
  std::vector<std::pair<device::Address, device::Driver*>> added_;
  Site site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
};

}  // namespace playhouse::drivers::testing
