#include "playhouse/stage/instruction_set.h"

#include <algorithm>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

bool vectors_use_avx2 = is_available(InstructionSet::kAvx2);

bool is_available(InstructionSet set) {
  if (set == InstructionSet::kPlain) return true;
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

InstructionSet instruction_set() {
  return vectors_use_avx2 ? InstructionSet::kAvx2 : InstructionSet::kPlain;
}

void choose_instruction_set(InstructionSet set) {
  PLAYHOUSE_ASSERT(is_available(set));
  vectors_use_avx2 = set == InstructionSet::kAvx2;
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

}  // namespace playhouse::stage
