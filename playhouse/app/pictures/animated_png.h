#pragma once

/// Films as animated PNG: further frames are in chunks of their own (PNG Specification, Third Edition,
/// chunks acTL, fcTL and fdAT), so that viewers without animation support show the first frame.

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/app/pictures/picture_of_world.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class AnimatedPng {
 public:
  /// A looping film of so many frames of equal size, each shown for `period` seconds.
  AnimatedPng(std::uint64_t pictures, double period) : pictures_(pictures), period_(period) {}

  /// Fails if the file would exceed limits::kFilmBytes.
  Result<void> add(const scene::RgbImage& picture);
  /// The file, once all frames were added.
  std::string take();

 private:
  void add_chunk(std::string_view type, std::string_view content);
  void add_frame(const scene::RgbImage& picture);

  std::uint64_t pictures_, added_ = 0;
  double period_;
  std::uint32_t sequence_ = 0;  // of fcTL and fdAT
  std::string file_;
};

}  // namespace playhouse::app
