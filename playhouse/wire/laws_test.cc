// Laws that hold for every message of every interface, checked on random values.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "playhouse/base/packing.h"
#include "playhouse/base/rng.h"
#include "playhouse/wire/messages.h"
#include "playhouse/wire/samples.h"

namespace playhouse::wire {
namespace {

const std::map<std::string_view, const MessageDef*>& rows_by_name() {
  static const auto rows = [] {
    std::map<std::string_view, const MessageDef*> out;
    for (const MessageDef& row : universal_messages()) out[row.name] = &row;
    for (const InterfaceDef& interface : interfaces()) {
      for (const MessageDef& row : interface.messages) out[row.name] = &row;
    }
    return out;
  }();
  return rows;
}

/// Calls `law(sample, row)` for every message with a payload; each must say "" or what is wrong.
template <typename Law>
std::string broken(Law law) {
  for (const Sample& sample : samples()) {
    const std::string wrong = law(sample, *rows_by_name().at(sample.name));
    if (!wrong.empty()) return std::string(sample.name) + ": " + wrong;
  }
  return "";
}

TEST(WireLaws, cover_every_message_that_has_a_payload) {
  const auto with_payload =
      std::ranges::count_if(rows_by_name(), [](const auto& entry) { return entry.second->has_payload; });
  EXPECT_EQ(samples().size(), static_cast<std::size_t>(with_payload));
}

RC_GTEST_PROP(WireLaws, every_message_decodes_to_the_value_that_was_encoded, (std::uint64_t seed)) {
  RC_ASSERT(broken([&](const Sample& sample, const MessageDef& row) -> std::string {
              const Bytes bytes = sample.encoded(seed, Floats::kFinite);
              if (!sample.decodes_to(bytes, seed)) return "decodes to another value";
              if (bytes.size() % 4 != 0) return "is no multiple of four bytes";
              return row.check(bytes);
            }) == "");
}

RC_GTEST_PROP(WireLaws, every_message_reencodes_to_the_same_bytes_whatever_its_bits, (std::uint64_t seed)) {
  RC_ASSERT(broken([&](const Sample& sample, const MessageDef& row) -> std::string {
              const Bytes bytes = sample.encoded(seed, Floats::kAnyBits);
              return row.reencode(bytes) == bytes ? "" : "reencodes to other bytes";
            }) == "");
}

RC_GTEST_PROP(WireLaws, bytes_after_the_value_are_tolerated, (std::uint64_t seed)) {
  RC_ASSERT(broken([&](const Sample& sample, const MessageDef& row) -> std::string {
              const Bytes bytes = sample.encoded(seed, Floats::kAnyBits);
              Bytes longer = bytes;
              longer.resize(bytes.size() + 1 + seed % 9, std::byte{0xAA});
              return row.reencode(longer) == bytes ? "" : "does not ignore them: " + row.check(longer);
            }) == "");
}

TEST(WireLaws, a_body_cut_at_any_length_is_refused_and_the_error_names_the_byte) {
  EXPECT_EQ(broken([](const Sample& sample, const MessageDef& row) -> std::string {
              const Bytes bytes = sample.encoded(7, Floats::kFinite);
              for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
                const auto part = std::span(bytes).first(cut);
                if (sample.decodes(part)) return "decodes when cut at " + std::to_string(cut);
                if (cut > 0 && row.check(part).find("at byte ") == std::string::npos) return "names no byte";
              }
              return "";
            }),
            "");
}

RC_GTEST_PROP(WireLaws, a_word_of_ones_anywhere_takes_no_more_memory_than_the_body_allows,
              (std::uint64_t seed)) {
  RC_ASSERT(broken([&](const Sample& sample, const MessageDef&) -> std::string {
              const Bytes bytes = sample.encoded(seed, Floats::kFinite);
              for (std::size_t at = seed % 8 * 4; at + 4 <= bytes.size(); at += 32) {
                Bytes hostile = bytes;
                std::fill_n(hostile.begin() + static_cast<std::ptrdiff_t>(at), 4, std::byte{0xFF});
                largest_allocation = 0;
                (void)sample.decodes(hostile);
                // Four bytes of memory per byte on the wire (lists of text), and an error line.
                if (largest_allocation > 4 * hostile.size() + 256) {
                  return "takes " + std::to_string(largest_allocation) + " bytes for " +
                         std::to_string(bytes.size());
                }
              }
              return "";
            }) == "");
}

RC_GTEST_PROP(WireLaws, spoiled_bytes_never_crash_and_what_decodes_is_stable, (std::uint64_t seed)) {
  RC_ASSERT(broken([&](const Sample& sample, const MessageDef& row) -> std::string {
              Bytes bytes = sample.encoded(seed, Floats::kAnyBits);
              Rng rng(~seed);
              for (int i = 0; i < 3; ++i)
                bytes[rng.bits() % bytes.size()] ^= static_cast<std::byte>(rng.bits() & 0xFF);
              const Bytes once = row.reencode(bytes);
              if (once.empty() != !row.check(bytes).empty()) return "check and reencode disagree";
              return row.reencode(once) == once ? "" : "is not stable";
            }) == "");
}

}  // namespace
}  // namespace playhouse::wire
