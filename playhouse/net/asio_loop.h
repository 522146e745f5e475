#pragma once

/// The inside of IoLoop, for the .cc files of net only: they share its io_context.

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <functional>
#include <optional>

#include "playhouse/net/io_loop.h"

namespace playhouse::net {

struct IoLoop::Impl {
  boost::asio::io_context context{1};
  std::optional<boost::asio::signal_set> signals;
  std::function<void(int)> signal_task;
  /// Every connection reads into this; valid for one `received` call.
  std::array<std::byte, 65536> read_buffer;
};

}  // namespace playhouse::net
