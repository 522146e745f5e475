#include "playhouse/senses/radio.h"

#include <algorithm>

#include "playhouse/geom/logarithm.h"

namespace playhouse::senses {
namespace {

constexpr double kNearest = 0.01, kFarthest = 1e6;  // m
constexpr double kMostFading = 6;                   // standard deviations; Rng::gaussian() gives no more

double decades(double value, double least) {
  return geom::log10(std::max(value, least));
}

}  // namespace

double path_loss(const scene::WifiDesc& hears, double frequency, double distance) {
  const double d = decades(distance, kNearest), f = 20 * decades(frequency, 1);
  const double in_free_space = 20 * d + f - 27.55;
  switch (hears.propagation) {
    case scene::Propagation::kItuIndoor:
      return std::max(f + hears.plc * d - 28, 0.0);
    case scene::Propagation::kLogDistance:
      return std::max(distance < 1 ? in_free_space : f - 27.55 + 10 * hears.ple * d, 0.0);
    case scene::Propagation::kSimple:
    case scene::Propagation::kFriis:
    case scene::Propagation::kRaytrace:
      break;
  }
  return std::max(in_free_space, 0.0);
}

/// Path loss is monotonic in distance, so bisection finds the limit.
double farthest_heard(const scene::WifiDesc& hears, double power, double frequency) {
  const double most =
      hears.propagation == scene::Propagation::kSimple ? std::min(hears.range, kFarthest) : kFarthest;
  const double budget = power - hears.sensitivity + kMostFading * hears.fading;
  const auto is_heard = [&](double distance) { return path_loss(hears, frequency, distance) <= budget; };
  if (is_heard(most)) return most;
  if (!is_heard(0)) return 0;
  double near = 0, far = most;
  for (int i = 0; i < 64; ++i) {
    const double middle = 0.5 * (near + far);
    (is_heard(middle) ? near : far) = middle;
  }
  return far;
}

std::uint32_t link_quality(const scene::WifiDesc& hears, double level) {
  constexpr double kBest = 30;  // dB
  return static_cast<std::uint32_t>(100 * std::clamp((level - hears.sensitivity) / kBest, 0.0, 1.0) + 0.5);
}

}  // namespace playhouse::senses
