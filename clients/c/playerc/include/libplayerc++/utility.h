/** Where a server is by default, angles and limits: a part of playerc++.h, which programs include alone as well. */
#ifndef LIBPLAYERCPP_UTILITY_H
#define LIBPLAYERCPP_UTILITY_H

#include <cmath>
#include <string>

namespace PlayerCc {

const std::string PLAYER_HOSTNAME("localhost");
const int PLAYER_PORTNUM = 6665;

inline double rtod(double radians) {
  return radians * 180.0 / M_PI;
}
inline double dtor(double degrees) {
  return degrees * M_PI / 180.0;
}
inline double normalize(double angle) {
  return std::atan2(std::sin(angle), std::cos(angle));
}
template <typename T>
T min(T a, T b) {
  return a < b ? a : b;
}
template <typename T>
T max(T a, T b) {
  return a > b ? a : b;
}
/** The nearest number to `value` within [low, high]. */
template <typename T>
T limit(T value, T low, T high) {
  return value < low ? low : value > high ? high : value;
}

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_UTILITY_H */
