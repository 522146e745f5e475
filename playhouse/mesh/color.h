#pragma once

namespace playhouse::mesh {

/// sRGB to linear, both from 0 to 1.
/// Source: IEC 61966-2-1, with the power of 2.4 as a square and a fifth root.
inline double linear_of_srgb(double channel) {
  if (channel <= 0.04045) return channel < 0 ? 0 : channel / 12.92;
  const double base = (channel + 0.055) / 1.055, square = base * base;
  double root = 1;  // fifth root by Newton's method
  for (int i = 0; i < 24; ++i) root -= (root - square / (root * root * root * root)) / 5;
  return square * root;
}

}  // namespace playhouse::mesh
