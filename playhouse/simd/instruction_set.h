#pragma once

/// Dispatch of vector functions (vectors.h) by CPU features. Each is
/// compiled for every instruction set, and all versions give the same bits.

#include <array>
#include <cstdint>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::simd {

/// Plain: the architecture's baseline. Emulated: the AVX-512 kernels on any processor, slowly, for tests.
enum class InstructionSet : std::uint8_t { kPlain, kAvx2, kAvx512, kAvx512Emulated };
inline constexpr std::array<std::string_view, 4> kInstructionSetNames = {"plain", "avx2", "avx512",
                                                                         "avx512-emulated"};

/// True if the processor supports it.
bool is_available(InstructionSet set);

/// The set that vector functions run with. Default: AVX-512
/// if available and worth while, else AVX2, else plain.
InstructionSet instruction_set();

/// Sets it for the whole process; never during a tick. Asserts that it is available.
void choose_instruction_set(InstructionSet set);

/// Parses a name of kInstructionSetNames. Fails on other names, and if the processor lacks the set.
Result<InstructionSet> parse_instruction_set(std::string_view name);

}  // namespace playhouse::simd
