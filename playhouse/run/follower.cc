#include "playhouse/run/follower.h"

#include <utility>

namespace playhouse::run {
namespace {

struct OnEvent final : Follower {
  void happened(const world::World& world, const world::Event& event) override { call(world, event); }
  std::function<void(const world::World&, const world::Event&)> call;
};

struct OnShow final : Follower {
  bool watches() const override { return true; }
  void shown(const world::World& world, const world::Pace& pace) override { call(world, pace); }
  std::function<void(const world::World&, const world::Pace&)> call;
};

}  // namespace

std::shared_ptr<Follower> on_event(std::function<void(const world::World&, const world::Event&)> call) {
  auto follower = std::make_shared<OnEvent>();
  follower->call = std::move(call);
  return follower;
}

std::shared_ptr<Follower> on_show(std::function<void(const world::World&, const world::Pace&)> call) {
  auto follower = std::make_shared<OnShow>();
  follower->call = std::move(call);
  return follower;
}

}  // namespace playhouse::run
