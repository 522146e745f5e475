#include "playhouse/simd/instruction_set.h"

#include <algorithm>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::simd {

bool vectors_use_avx2 = is_available(InstructionSet::kAvx2);
EightLanes eight_lanes = is_available(InstructionSet::kAvx512) ? EightLanes::kAvx512 : EightLanes::kNone;

bool is_available(InstructionSet set) {
  if (set == InstructionSet::kPlain || set == InstructionSet::kAvx512Emulated) return true;
#ifdef __x86_64__
  const bool avx2 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("popcnt");
  if (set == InstructionSet::kAvx2) return avx2;
  return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
#else
  return false;
#endif
}

InstructionSet instruction_set() {
  if (eight_lanes == EightLanes::kAvx512) return InstructionSet::kAvx512;
  if (eight_lanes == EightLanes::kPlain) return InstructionSet::kAvx512Emulated;
  return vectors_use_avx2 ? InstructionSet::kAvx2 : InstructionSet::kPlain;
}

void choose_instruction_set(InstructionSet set) {
  PLAYHOUSE_ASSERT(is_available(set));
  vectors_use_avx2 = set != InstructionSet::kPlain && is_available(InstructionSet::kAvx2);
  eight_lanes = set == InstructionSet::kAvx512           ? EightLanes::kAvx512
                : set == InstructionSet::kAvx512Emulated ? EightLanes::kPlain
                                                         : EightLanes::kNone;
}

Result<InstructionSet> parse_instruction_set(std::string_view name) {
  const auto found = std::find(kInstructionSetNames.begin(), kInstructionSetNames.end(), name);
  if (found == kInstructionSetNames.end())
    return Error{"",
                 "there is no instruction set " + in_quotes(name) + did_you_mean(name, kInstructionSetNames)};
  const auto set = static_cast<InstructionSet>(found - kInstructionSetNames.begin());
  if (!is_available(set)) return Error{"", "this processor has no " + std::string(name) + " instructions"};
  return set;
}

}  // namespace playhouse::simd
