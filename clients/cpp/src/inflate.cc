#include "inflate.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace playhouse::client {
namespace {

constexpr std::size_t kLongestCode = 15;  // bits
constexpr unsigned kEndOfBlock = 256;
constexpr unsigned kFirstLength = 257;
constexpr unsigned kFault = 0xFFFF;  // in place of a symbol

/// Reads bits, the lowest of each byte first. Beyond the end they are 0, and `over()`.
class Bits {
 public:
  explicit Bits(std::span<const std::byte> bytes) : bytes_(bytes) {}

  unsigned take(unsigned count) {
    unsigned value = 0;
    for (unsigned i = 0; i < count; ++i, ++at_) {
      if (at_ < 8 * bytes_.size()) value |= (std::to_integer<unsigned>(bytes_[at_ / 8]) >> at_ % 8 & 1) << i;
    }
    return value;
  }
  void skip_to_byte() { at_ = (at_ + 7) / 8 * 8; }
  bool over() const { return at_ > 8 * bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;  // bits
};

/// A canonical prefix code: codes of one length are consecutive numbers, after those of shorter ones. Holds
/// the number of codes of each length, and their symbols in the order of the codes.
class Code {
 public:
  /// `lengths` are bits per symbol, 0 for those that do not occur.
  explicit Code(std::span<const std::uint8_t> lengths) {
    for (const std::uint8_t length : lengths) ++counts_[length];
    counts_[0] = 0;
    std::array<std::size_t, kLongestCode + 2> next{};
    for (std::size_t length = 1; length <= kLongestCode; ++length)
      next[length + 1] = next[length] + counts_[length];
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
      if (lengths[symbol] > 0) symbols_[next[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
  }

  /// False if there are more codes than their lengths allow.
  bool sound() const {
    int left = 1;
    for (std::size_t length = 1; length <= kLongestCode && left >= 0; ++length)
      left = 2 * left - counts_[length];
    return left >= 0;
  }

  /// kFault for bits that are no code.
  unsigned take(Bits& in) const {
    int code = 0, first = 0, index = 0;  // the first code of a length, and its place among the symbols
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      code |= static_cast<int>(in.take(1));
      if (code - first < counts_[length]) return symbols_[static_cast<std::size_t>(index + code - first)];
      index += counts_[length];
      first = 2 * (first + counts_[length]);
      code *= 2;
    }
    return kFault;
  }

 private:
  std::array<int, kLongestCode + 1> counts_{};
  std::array<std::uint16_t, 288> symbols_{};
};

struct Codes {
  Code literals, distances;
};

/// Uncompresses into a vector of at most `size` bytes. Steps return false for a fault.
class Inflater {
 public:
  Inflater(std::span<const std::byte> deflated, std::size_t size) : in_(deflated), size_(size) {}

  bool run() {
    for (bool last = false; !last;) {
      last = in_.take(1) == 1;
      const unsigned kind = in_.take(2);
      const bool done = kind == 0   ? copy_block()
                        : kind == 1 ? take_block(fixed_codes())
                                    : take_coded_block(kind);
      if (!done || in_.over()) return false;
    }
    return out_.size() == size_;
  }

  std::uint32_t adler() {  // big-endian, after the last block
    in_.skip_to_byte();
    std::uint32_t sum = 0;
    for (int i = 0; i < 4; ++i) sum = sum << 8 | in_.take(8);
    return sum;
  }
  std::vector<std::byte>& out() { return out_; }

 private:
  bool copy_block() {
    in_.skip_to_byte();
    const unsigned length = in_.take(16), inverted = in_.take(16);
    if (length != (inverted ^ 0xFFFF) || length > size_ - out_.size()) return false;
    for (unsigned i = 0; i < length; ++i) out_.push_back(static_cast<std::byte>(in_.take(8)));
    return true;
  }

  static Codes fixed_codes() {
    std::array<std::uint8_t, 288> lengths;
    std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
    std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
    std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
    std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
    std::array<std::uint8_t, 30> distances;
    distances.fill(5);
    return {Code(lengths), Code(distances)};
  }

  /// A block with codes of its own, whose lengths come first, themselves coded.
  bool take_coded_block(unsigned kind) {
    if (kind != 2) return false;
    const unsigned literals = in_.take(5) + 257, distances = in_.take(5) + 1, codes = in_.take(4) + 4;
    if (literals > 286 || distances > 30) return false;
    constexpr std::array<std::uint8_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                     11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::array<std::uint8_t, 19> bits{};
    for (unsigned i = 0; i < codes; ++i) bits[kOrder[i]] = static_cast<std::uint8_t>(in_.take(3));
    std::vector<std::uint8_t> lengths;
    if (!take_lengths(Code(bits), literals + distances, lengths)) return false;
    const std::span<const std::uint8_t> all(lengths);
    return take_block({Code(all.first(literals)), Code(all.subspan(literals))});
  }

  bool take_lengths(const Code& code, std::size_t count, std::vector<std::uint8_t>& lengths) {
    if (!code.sound()) return false;
    while (lengths.size() < count) {
      const unsigned symbol = code.take(in_);
      if (symbol == kFault || (symbol == 16 && lengths.empty())) return false;
      const std::uint8_t length = symbol < 16    ? static_cast<std::uint8_t>(symbol)
                                  : symbol == 16 ? lengths.back()
                                                 : std::uint8_t{0};
      const unsigned times = symbol < 16    ? 1
                             : symbol == 16 ? 3 + in_.take(2)
                             : symbol == 17 ? 3 + in_.take(3)
                                            : 11 + in_.take(7);
      lengths.insert(lengths.end(), times, length);
    }
    return lengths.size() == count;
  }

  bool take_block(const Codes& codes) {
    if (!codes.literals.sound() || !codes.distances.sound()) return false;
    for (;;) {
      const unsigned symbol = codes.literals.take(in_);
      if (symbol == kEndOfBlock) return true;
      if (symbol == kFault || in_.over() || out_.size() == size_) return false;
      if (symbol < kEndOfBlock) {
        out_.push_back(static_cast<std::byte>(symbol));
      } else if (!repeat(symbol - kFirstLength, codes.distances)) {
        return false;
      }
    }
  }

  /// Repeats bytes from before: `symbol` says how many, the next code how far back they are.
  bool repeat(unsigned symbol, const Code& distances) {
    if (symbol > 28) return false;
    // Symbols come in groups of four (of two for distances), each with one more bit beside the symbol.
    const unsigned extra = symbol < 8 || symbol == 28 ? 0 : symbol / 4 - 1;
    const unsigned least = symbol < 8 ? symbol : symbol == 28 ? 255 : (4 + symbol % 4) << extra;
    const std::size_t length = 3 + least + in_.take(extra);
    const unsigned far = distances.take(in_);
    if (far > 29) return false;
    const unsigned far_extra = far < 4 ? 0 : far / 2 - 1;
    const std::size_t distance = 1 + (far < 4 ? far : (2 + far % 2) << far_extra) + in_.take(far_extra);
    if (distance > out_.size() || length > size_ - out_.size()) return false;
    for (std::size_t i = 0; i < length; ++i) out_.push_back(out_[out_.size() - distance]);
    return true;
  }

  Bits in_;
  std::size_t size_;
  std::vector<std::byte> out_;
};

std::uint32_t adler_of(std::span<const std::byte> bytes) {
  constexpr std::uint32_t kModulus = 65521;
  std::uint32_t low = 1, high = 0;
  for (const std::byte byte : bytes) {
    low = (low + std::to_integer<std::uint32_t>(byte)) % kModulus;
    high = (high + low) % kModulus;
  }
  return high << 16 | low;
}

}  // namespace

std::optional<std::vector<std::byte>> inflate(std::span<const std::byte> stream, std::size_t size) {
  if (stream.size() < 2) return std::nullopt;
  const unsigned method = std::to_integer<unsigned>(stream[0]), flags = std::to_integer<unsigned>(stream[1]);
  const bool known = (method & 0x0F) == 8 && (method << 8 | flags) % 31 == 0 && (flags & 0x20) == 0;
  if (!known) return std::nullopt;
  Inflater inflater(stream.subspan(2), size);
  if (!inflater.run() || inflater.adler() != adler_of(inflater.out())) return std::nullopt;
  return std::move(inflater.out());
}

}  // namespace playhouse::client
