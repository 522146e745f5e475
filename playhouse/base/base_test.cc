#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "playhouse/base/base64.h"
#include "playhouse/base/hash.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/result.h"
#include "playhouse/base/rng.h"
#include "playhouse/base/row.h"

namespace playhouse {
namespace {

TEST(NearestWord, finds_a_slip_and_refuses_a_stranger) {
  constexpr std::array<std::string_view, 3> words = {"position", "ranger", "fiducial"};
  EXPECT_EQ(nearest_word("positoin", words), "position");
  EXPECT_EQ(nearest_word("zzzzzz", words), "");
  constexpr std::array<std::string_view, 2> short_words = {"ir", "-h"};
  EXPECT_EQ(nearest_word("6", short_words), "") << "two slips, one letter";
  EXPECT_EQ(nearest_word("it", short_words), "ir");
  EXPECT_EQ(did_you_mean("rangr", words), " (did you mean \"ranger\"?)");
}

TEST(InQuotes, keeps_words_as_they_are_and_takes_the_sting_out_of_others) {
  EXPECT_EQ(in_quotes("rob\u00f6t"), "\"rob\u00f6t\"");
  EXPECT_EQ(in_quotes(std::string_view("a\n[error] b\0c\x7f", 14)), "\"a\\x0a[error] b\\x00c\\x7f\"");
  EXPECT_EQ(in_quotes(std::string(200, 'x')).size(), 202u);
  EXPECT_EQ(in_quotes(std::string(198, 'x') + "\u20ac" + "y"), "\"" + std::string(198, 'x') + "...\"");
  EXPECT_EQ(in_quotes(std::string(198, 'x') + "\u00f6" + "y"), "\"" + std::string(198, 'x') + "\u00f6...\"");
  EXPECT_EQ(in_quotes(std::string(65536, 'x')), "\"" + std::string(200, 'x') + "...\"");
  EXPECT_EQ(escaped("\xff"
                    "a\xc3 \xc0\x80 \xed\xa0\x80 \xf0\x9f\xa4\x96 \xe2\x82"),
            "\\xffa\\xc3 \\xc0\\x80 \\xed\\xa0\\x80 \xf0\x9f\xa4\x96 \\xe2\\x82")
      << "only UTF-8 is left as it is";
  EXPECT_EQ(escaped("a\nb" + std::string(300, 'x')), "a\\x0ab" + std::string(300, 'x'));
}

TEST(Base64, goes_there_and_back) {
  const std::string bytes("\0\xff\x10 pixels", 10);
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    std::string text;
    append_base64(text, {reinterpret_cast<const std::uint8_t*>(bytes.data()), size});
    EXPECT_EQ(text.size(), (size + 2) / 3 * 4);
    EXPECT_EQ(bytes_of_base64(text), bytes.substr(0, size));
  }
  EXPECT_EQ(bytes_of_base64("Zm9vYg=="), "foob");
}

TEST(Base64, refuses_what_is_none) {
  for (const char* const text : {"Zm9", "Zm9v\n", "Zm9vY===", "Zm=vYg==", "=m9v", "Zm9\xff", "===="})
    EXPECT_EQ(bytes_of_base64(text), std::nullopt) << text;
}

TEST(Result, holds_a_value_or_an_error) {
  Result<int> good = 3;
  Result<int> bad = Error{"a.world:2", "no such thing"};
  EXPECT_EQ(*good, 3);
  EXPECT_EQ(bad.error().line(), "a.world:2: no such thing");
}

struct Doors;
struct Windows;

template <typename Column, typename Index>
constexpr bool kCanIndex = requires(Column column, Index index) {
  column[index];
};

TEST(Rows, index_columns_of_their_own_table_and_no_others) {
  using Widths = ByRow<Doors, double>;
  static_assert(kCanIndex<Widths, Row<Doors>>);
  static_assert(!kCanIndex<Widths, Row<Windows>>);
  static_assert(!kCanIndex<Widths, std::uint32_t>);
  static_assert(sizeof(Row<Doors>) == sizeof(std::uint32_t));
  Widths width{0.9, 1.2, 2.5};
  std::vector<double> seen;
  for (const Row<Doors> door : RowsOf<Doors>(width.size() - 1)) seen.push_back(width[door + 1]);
  EXPECT_EQ(seen, (std::vector<double>{1.2, 2.5}));
  EXPECT_EQ(width.rows().size(), 3u);
  EXPECT_EQ(width.next() - width.rows()[1], 2u);
  EXPECT_EQ(*width.from(width.rows()[1]), 1.2);
  EXPECT_FALSE(Row<Doors>{});
  EXPECT_TRUE(Row<Doors>{0});
}

TEST(Rows, with_one_value_in_a_column_are_a_run) {
  const ByRow<Doors, char> house{'a', 'b', 'b', 'a', 'a'};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  const auto add = [&](RowsOf<Doors> run) { runs.emplace_back(run.front().index, run.size()); };
  each_run(RowsOf<Doors>(house.rows()[1], house.next()), house, add);
  EXPECT_EQ(runs, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 2}, {3, 2}}));
  runs.clear();
  each_run(RowsOf<Doors>(), house, add);
  EXPECT_TRUE(runs.empty());
}

TEST(Rng, depends_on_each_of_its_inputs_and_on_nothing_else) {
  EXPECT_EQ(Rng(1, 2, {Purpose::kColor, 3}).bits(), Rng(1, 2, {Purpose::kColor, 3}).bits());
  const std::uint64_t base = Rng(1, 2, {Purpose::kColor, 3}).bits();
  EXPECT_NE(base, Rng(2, 2, {Purpose::kColor, 3}).bits());
  EXPECT_NE(base, Rng(1, 3, {Purpose::kColor, 3}).bits());
  EXPECT_NE(base, Rng(1, 2, {Purpose::kController, 3}).bits());
  EXPECT_NE(base, Rng(1, 2, {Purpose::kColor, 4}).bits());
  EXPECT_NE(base, Rng(1, 2, {Purpose::kColor, 3, 1}).bits());
}

// Every sensor, beam and purpose of a world of 100 sensors with 20 beams, in two ticks; and the largest rows.
TEST(Rng, no_two_streams_are_one) {
  std::set<std::uint64_t> first_numbers;
  std::size_t streams = 0;
  const auto add = [&](std::uint64_t tick, const Stream& stream) {
    ++streams;
    first_numbers.insert(Rng(1, tick, stream).bits());
  };
  constexpr std::uint32_t kLargest = 0xFFFFFFFF;
  for (const std::uint64_t tick : {0u, 1u}) {
    for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(Purpose::kCount); ++number) {
      const auto purpose = static_cast<Purpose>(number);
      for (std::uint32_t row = 0; row < 100; ++row)
        for (std::uint32_t part = 0; part < 20; ++part) add(tick, {purpose, row, part});
      add(tick, {purpose, kLargest, 0});
      add(tick, {purpose, 0, kLargest});
      add(tick, {purpose, kLargest, kLargest});
    }
  }
  EXPECT_EQ(first_numbers.size(), streams);
}

TEST(Rng, gaussian_has_mean_zero_and_variance_one) {
  Rng rng(1);
  constexpr int kDraws = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = rng.gaussian();
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.02);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
}

TEST(Hash, depends_on_order_and_not_on_the_sign_of_zero) {
  Hash a, b, c, d;
  a.add(1.0), a.add(2.0);
  b.add(2.0), b.add(1.0);
  c.add(0.0), d.add(-0.0);
  EXPECT_NE(a.value(), b.value());
  EXPECT_EQ(c.value(), d.value());
}

}  // namespace
}  // namespace playhouse
