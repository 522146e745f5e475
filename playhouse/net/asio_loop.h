#pragma once

/// The inside of IoLoop, for the .cc files of net only: they share its io_context.

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <functional>
#include <list>
#include <optional>

#include "playhouse/net/io_loop.h"

namespace playhouse::net {

struct IoLoop::Impl {
  boost::asio::io_context context{1};
  std::optional<boost::asio::signal_set> signals;
  std::function<void(int)> signal_task;
  /// Connections that have sent everything and wait for their peers to end; each entry ends one. The longest
  /// waiting is the first.
  using Lingering = std::list<std::function<void()>>;
  Lingering lingering;
  bool finishing = false;  // stops when none is left

  /// The entry stays until leave(), which `end` calls too. Over limits::kLingering the first one is ended.
  Lingering::iterator linger(std::function<void()> end);
  void leave(Lingering::iterator place);
  /// Closes all lingering connections to free file descriptors.
  void end_lingering();
  void end_first();

  /// Every connection reads into this; valid for one `received` call.
  std::array<std::byte, 65536> read_buffer;
};

}  // namespace playhouse::net
