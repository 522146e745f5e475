#pragma once

/// Which instructions the vector functions of this module run with (vectors.h). Each of them is in the
/// program once for every set of instructions, and all versions give the same bits.

#include <array>
#include <cstdint>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::stage {

/// Plain: what every processor has. Emulated: the kernels for AVX-512, on any processor, slowly.
enum class InstructionSet : std::uint8_t { kPlain, kAvx2, kAvx512, kAvx512Emulated };
inline constexpr std::array<std::string_view, 4> kInstructionSetNames = {"plain", "avx2", "avx512",
                                                                         "avx512-emulated"};

/// True where the processor has it.
bool is_available(InstructionSet set);

/// What vector functions run with: AVX-512 or else AVX2 where it is available, unless something else was
/// chosen.
InstructionSet instruction_set();

/// Changes it for the whole process, which must not be inside a tick. Asserts that it is available.
void choose_instruction_set(InstructionSet set);

/// The set of that name. Fails on other names, and where the processor lacks it.
Result<InstructionSet> parse_instruction_set(std::string_view name);

}  // namespace playhouse::stage
