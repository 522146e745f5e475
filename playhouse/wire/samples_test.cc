#include "playhouse/wire/samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "playhouse/base/rng.h"
#include "playhouse/wire/generated/fields.h"

namespace playhouse::wire {

namespace {

/// Fills any generated struct as a function of a seed.

class Arbitrary {
 public:
  Arbitrary(std::uint64_t seed, Floats floats) : rng_(seed), floats_(floats) {}

  template <typename T>
  void field(T& out) {
    if constexpr (std::is_integral_v<T>) {
      out = static_cast<T>(small() ? rng_.bits() % 3 : rng_.bits());
    } else if constexpr (std::is_floating_point_v<T>) {
      out = number<T>();
    } else {
      each_field(out, *this);
    }
  }

  template <typename T, std::size_t kLength>
  void field(std::array<T, kLength>& out) {
    for (T& element : out) field(element);
  }

  template <typename List>
  void list(List& out, std::size_t max) {
    out.resize(std::min(max, small() ? below(2) : below(9)));
    for (auto& element : out) field(element);
  }

  void fixed_text(std::string& out, std::size_t length) {
    out.resize(length);
    for (char& c : out) field(c);
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(rng_.bits() % n); }
  bool small() { return rng_.bits() % 2 == 0; }

  template <typename T>
  T number() {
    if (floats_ == Floats::kFinite)
      return static_cast<T>(small() ? 0.25 * static_cast<double>(below(8)) : rng_.gaussian());
    if constexpr (sizeof(T) == 4) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(rng_.bits()));
    } else {
      return std::bit_cast<double>(rng_.bits());
    }
  }

  Rng rng_;
  Floats floats_;
};

template <typename T>
T value_of(std::uint64_t seed, Floats floats) {
  T value;
  Arbitrary(seed, floats).field(value);
  return value;
}

template <typename T>
std::vector<std::byte> encoded(std::uint64_t seed, Floats floats) {
  return encode(value_of<T>(seed, floats));
}

template <typename T>
bool decodes_to(std::span<const std::byte> body, std::uint64_t seed) {
  const Result<T> value = decode<T>(body);
  return value.ok() && *value == value_of<T>(seed, Floats::kFinite);
}

template <typename T>
bool decodes(std::span<const std::byte> body) {
  return decode<T>(body).ok();
}

struct Collect {
  std::vector<Sample> found;
  template <typename T>
  void operator()(std::string_view name) {
    found.push_back({name, encoded<T>, decodes_to<T>, decodes<T>});
  }
};

}  // namespace

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    Collect collect;
    each_message(collect);
    return collect.found;
  }();
  return all;
}

}  // namespace playhouse::wire
