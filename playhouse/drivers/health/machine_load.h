#pragma once

/// Load of this machine, of what its kernel tells in /proc. Values.

#include <cstdint>
#include <optional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/wire/generated/health.h"

namespace playhouse::drivers {

/// What all processors together have done since the machine's start, in ticks of the kernel. Waiting for a disk
/// is idle; what an interrupt takes, or another virtual machine, is of the system.
struct CpuTimes {
  std::uint64_t idle = 0, system = 0, user = 0;
  friend bool operator==(const CpuTimes&, const CpuTimes&) = default;
};

struct MemoryLoad {
  wire::health::Memory memory, swap;
};

/// Of the text of /proc/stat.
Result<CpuTimes> read_cpu_times(std::string_view stat);

/// Of the text of /proc/meminfo. Memory that holds files' contents for later is free.
Result<MemoryLoad> read_memory_load(std::string_view meminfo);

/// Shares between two readings. [%] None if no time has passed between them.
std::optional<wire::health::Cpu> cpu_shares(const CpuTimes& before, const CpuTimes& after);

}  // namespace playhouse::drivers
