/** The exception of this library: a part of playerc++.h, which programs include alone as well. */
#ifndef LIBPLAYERCPP_PLAYERERROR_H
#define LIBPLAYERCPP_PLAYERERROR_H

#include <iostream>
#include <string>

namespace PlayerCc {

/** What a call that failed throws. */
class PlayerError {
 public:
  PlayerError(const std::string fun = "", const std::string str = "", const int code = -1)
      : fun_(fun), str_(str), code_(code) {}
  std::string GetErrorFun() const { return fun_; }
  std::string GetErrorStr() const { return str_; }
  int GetErrorCode() const { return code_; }

 private:
  std::string fun_, str_;
  int code_;
};

inline std::ostream &operator<<(std::ostream &os, const PlayerError &error) {
  return os << error.GetErrorFun() << "(" << error.GetErrorCode() << "): " << error.GetErrorStr();
}

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_PLAYERERROR_H */
