#include "playhouse/drivers/health/machine_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "playhouse/base/split.h"

namespace playhouse::drivers {
namespace {

constexpr std::uint64_t kUnit = 1024;  // bytes of a "kB" of /proc/meminfo
constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max() / kUnit;

/// The numbers after a line's first word, until something is none.
std::vector<std::uint64_t> numbers_of(std::string_view line) {
  std::vector<std::uint64_t> numbers;
  for (const std::string_view word : split(line.substr(std::min(line.find(' '), line.size())), ' ')) {
    if (word.empty()) continue;
    std::uint64_t number = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (fault != std::errc() || end != word.data() + word.size()) break;
    numbers.push_back(number);
  }
  return numbers;
}

/// The numbers of the line that begins with `word`; none if there is no such line.
std::vector<std::uint64_t> numbers_after(std::string_view word, std::string_view text) {
  for (const std::string_view line : split(text, '\n'))
    if (line.starts_with(word) && line.substr(word.size()).starts_with(' ')) return numbers_of(line);
  return {};
}

std::optional<std::uint64_t> kilobytes(std::string_view word, std::string_view meminfo) {
  const std::vector<std::uint64_t> numbers = numbers_after(word, meminfo);
  if (numbers.size() != 1 || numbers.front() > kMost) return std::nullopt;
  return numbers.front();
}

std::optional<wire::health::Memory> memory_of(std::optional<std::uint64_t> total,
                                              std::optional<std::uint64_t> free) {
  if (!total || !free || *free > *total) return std::nullopt;
  const auto bytes = [](std::uint64_t count) { return static_cast<std::int64_t>(count * kUnit); };
  return wire::health::Memory{bytes(*total), bytes(*total - *free), bytes(*free)};
}

}  // namespace

Result<CpuTimes> read_cpu_times(std::string_view stat) {
  std::vector<std::uint64_t> times = numbers_after("cpu", stat);
  if (times.size() < 4) return Error{"", "/proc/stat has no line \"cpu\" with four numbers or more"};
  times.resize(8);  // what older kernels lack is 0; what follows is counted in the first two
  const auto [user, nice, system, idle, waiting, interrupts, late, stolen] =
      std::tie(times[0], times[1], times[2], times[3], times[4], times[5], times[6], times[7]);
  return CpuTimes{idle + waiting, system + interrupts + late + stolen, user + nice};
}

Result<MemoryLoad> read_memory_load(std::string_view meminfo) {
  std::optional<std::uint64_t> available = kilobytes("MemAvailable:", meminfo);
  if (!available) available = kilobytes("MemFree:", meminfo);  // kernels before 3.14
  const auto memory = memory_of(kilobytes("MemTotal:", meminfo), available);
  const auto swap = memory_of(kilobytes("SwapTotal:", meminfo), kilobytes("SwapFree:", meminfo));
  if (!memory || !swap) return Error{"", "/proc/meminfo does not tell the total and free memory and swap"};
  return MemoryLoad{*memory, *swap};
}

std::optional<wire::health::Cpu> cpu_shares(const CpuTimes& before, const CpuTimes& after) {
  // Some counters of the kernel go back a little at times.
  const auto passed = [&](std::uint64_t CpuTimes::*time) {
    return after.*time > before.*time ? static_cast<double>(after.*time - before.*time) : 0.0;
  };
  const double idle = passed(&CpuTimes::idle), system = passed(&CpuTimes::system),
               user = passed(&CpuTimes::user);
  const double all = idle + system + user;
  if (all == 0) return std::nullopt;
  const auto share = [all](double time) { return static_cast<float>(100 * time / all); };
  return wire::health::Cpu{share(idle), share(system), share(user)};
}

}  // namespace playhouse::drivers
