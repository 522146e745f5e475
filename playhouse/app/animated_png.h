#pragma once

/// Films as animated PNG: a PNG file whose further pictures are in chunks of their own (PNG Specification,
/// Third Edition, chunks acTL, fcTL and fdAT), so that programs that know no animation show the first.

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/app/picture_of_world.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class AnimatedPng {
 public:
  /// A film of so many pictures of one size, each shown for `period` seconds, over and over.
  AnimatedPng(std::uint64_t pictures, double period) : pictures_(pictures), period_(period) {}

  /// Fails on a file of more than limits::kFilmBytes.
  Result<void> add(const Picture& picture);
  /// The file, when all pictures are in it.
  std::string take();

 private:
  void add_chunk(std::string_view type, std::string_view content);
  void add_frame(const Picture& picture);

  std::uint64_t pictures_, added_ = 0;
  double period_;
  std::uint32_t sequence_ = 0;  // of fcTL and fdAT
  std::string file_;
};

}  // namespace playhouse::app
