#include "inflate.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::client {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// Compressed by zlib at a level and with a strategy of it.
Bytes deflated(const Bytes& bytes, int level, int strategy) {
  z_stream stream{};
  PLAYHOUSE_ASSERT(deflateInit2(&stream, level, Z_DEFLATED, 15, 8, strategy) == Z_OK);
  Bytes out(deflateBound(&stream, bytes.size()));
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  PLAYHOUSE_ASSERT(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// Rows of cells with rooms and noise, words, noise, and nothing.
std::vector<Bytes> samples() {
  std::mt19937 random(1);
  Bytes noise(70000), rooms(512 * 512), words;
  for (std::byte& byte : noise) byte = static_cast<std::byte>(random());
  for (std::size_t i = 0; i < rooms.size(); ++i)
    rooms[i] = static_cast<std::byte>(i % 37 == 0 || i / 512 % 41 == 0 ? 1 : random() % 50 == 0 ? 0 : -1);
  while (words.size() < 100000) {
    const Bytes more = bytes_of("word" + std::to_string(random() % 1000));
    words.insert(words.end(), more.begin(), more.end());
  }
  return {noise, rooms, words, Bytes(300000), bytes_of("a"), {}};
}

TEST(Inflate, MakesOfAStreamOfZlibWhatItWas) {
  for (const Bytes& bytes : samples())
    for (const int level : {0, 1, 6, 9})
      for (const int strategy : {Z_DEFAULT_STRATEGY, Z_HUFFMAN_ONLY, Z_FIXED, Z_RLE}) {
        const auto inflated = inflate(deflated(bytes, level, strategy), bytes.size());
        ASSERT_TRUE(inflated) << bytes.size() << " bytes at level " << level << ", strategy " << strategy;
        ASSERT_EQ(*inflated, bytes);
      }
}

TEST(Inflate, RefusesAnotherNumberOfBytes) {
  const Bytes bytes = samples()[2];
  for (const int level : {0, 6}) {
    const Bytes stream = deflated(bytes, level, Z_DEFAULT_STRATEGY);
    EXPECT_FALSE(inflate(stream, bytes.size() - 1));
    EXPECT_FALSE(inflate(stream, bytes.size() + 1));
    EXPECT_FALSE(inflate(stream, 0));
  }
}

TEST(Inflate, RefusesWhatIsCutShort) {
  const Bytes bytes = bytes_of("abracadabra, abracadabra");
  for (const int level : {0, 6}) {
    const Bytes stream = deflated(bytes, level, Z_DEFAULT_STRATEGY);
    for (std::size_t size = 0; size < stream.size(); ++size)
      EXPECT_FALSE(inflate(std::span(stream).first(size), bytes.size())) << size;
  }
}

/// zlib's own view of a stream: none if it is damaged or has another number of bytes.
std::optional<Bytes> by_zlib(const Bytes& stream, std::size_t size) {
  Bytes out(size + 1);
  uLongf got = out.size();
  const int result = uncompress(reinterpret_cast<Bytef*>(out.data()), &got,
                                reinterpret_cast<const Bytef*>(stream.data()), stream.size());
  out.resize(got);
  return result == Z_OK && got == size ? std::optional(out) : std::nullopt;
}

TEST(Inflate, RefusesDamageAsZlibDoes) {
  std::mt19937 random(2);
  Bytes bytes = samples()[1];
  bytes.resize(3000);
  for (const int strategy : {Z_DEFAULT_STRATEGY, Z_FIXED}) {
    const Bytes stream = deflated(bytes, 6, strategy);
    for (int i = 0; i < 5000; ++i) {
      Bytes damaged = stream;
      for (auto k = random() % 3; k < 3; ++k)
        damaged[random() % damaged.size()] = static_cast<std::byte>(random());
      ASSERT_EQ(inflate(damaged, bytes.size()), by_zlib(damaged, bytes.size())) << i;
    }
  }
}

}  // namespace
}  // namespace playhouse::client
