#pragma once

/// Asio, on which net is built: that of Boost, or the standalone one in a build without Boost
/// (PLAYHOUSE_STANDALONE_ASIO). Internal to net.

#if defined(PLAYHOUSE_STANDALONE_ASIO)
#include <asio/connect.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/ip/v6_only.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/post.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <system_error>
#else
#include <boost/asio/connect.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/error_code.hpp>
#endif

namespace playhouse::net {

#if defined(PLAYHOUSE_STANDALONE_ASIO)
namespace asio = ::asio;
using error_code = std::error_code;
#else
namespace asio = boost::asio;
using error_code = boost::system::error_code;
#endif

}  // namespace playhouse::net
