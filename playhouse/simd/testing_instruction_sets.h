#pragma once

/// For tests of what vector functions compute.

#include <gtest/gtest.h>

#include <string>

#include "playhouse/simd/instruction_set.h"

namespace playhouse::simd::testing {

/// Scoped choice of an instruction set.
class WithInstructionSet {
 public:
  explicit WithInstructionSet(InstructionSet set) { choose_instruction_set(set); }
  ~WithInstructionSet() { choose_instruction_set(before_); }
  WithInstructionSet(const WithInstructionSet&) = delete;
  WithInstructionSet& operator=(const WithInstructionSet&) = delete;

 private:
  InstructionSet before_ = instruction_set();
};

/// Runs `body` once for each set that this processor supports; the
/// test InstructionSets.are_all_tested_here reports the others.
template <typename Body>
void with_every_instruction_set(const Body& body) {
  for (const InstructionSet set : {InstructionSet::kPlain, InstructionSet::kAvx2, InstructionSet::kAvx512,
                                   InstructionSet::kAvx512Emulated}) {
    if (!is_available(set)) continue;
    const WithInstructionSet chosen(set);
    SCOPED_TRACE(std::string(kInstructionSetNames[static_cast<std::size_t>(set)]));
    body();
  }
}

}  // namespace playhouse::simd::testing
