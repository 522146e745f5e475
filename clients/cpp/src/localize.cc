#include "playhouse_client/localize.h"

#include <array>
#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace localize = wire::localize;

namespace {

Covariance covariance_of(const std::array<double, 6>& cov) {
  const auto [xx, yy, aa, xy, ya, xa] = cov;
  return {xx, yy, aa, xy, ya, xa};
}

}  // namespace

Result<Localize> Localize::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, localize::kCode, index, access);
  if (!device) return device.error();
  return Localize(std::move(*device));
}

std::vector<Hypothesis> Localize::hypotheses() const {
  std::vector<Hypothesis> hypotheses;
  const auto data = device_.latest<localize::Data>(localize::kDataHypoths);
  if (!data) return hypotheses;
  for (const localize::Hypoth& one : data->hypoths)
    hypotheses.push_back({client::pose(one.mean), covariance_of(one.cov), one.alpha});
  return hypotheses;
}

std::optional<Pose> Localize::pose() const {
  const auto data = device_.latest<localize::Data>(localize::kDataHypoths);
  if (!data || data->hypoths.empty()) return std::nullopt;
  return client::pose(data->hypoths.front().mean);
}

Result<void> Localize::set_pose(const Pose& pose, const Covariance& covariance) {
  const auto& [xx, yy, aa, xy, ya, xa] = covariance;
  const auto sound = finite(device_, "set_pose", {pose.x, pose.y, pose.a, xx, yy, aa, xy, ya, xa});
  if (!sound) return sound;
  const localize::SetPose request{on_wire(pose), {xx, yy, aa, xy, ya, xa}};
  return done(device_.request(localize::kReqSetPose, request));
}

Result<std::vector<Particle>> Localize::particles() {
  const auto answer = device_.request<localize::GetParticles>(localize::kReqGetParticles);
  if (!answer) return answer.error();
  std::vector<Particle> particles;
  for (const localize::Particle& one : answer->particles)
    particles.push_back({client::pose(one.pose), one.alpha});
  return particles;
}

}  // namespace playhouse::client
