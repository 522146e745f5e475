#include "playhouse/net/websocket_handshake.h"

#include <boost/beast/websocket.hpp>
#include <utility>

namespace playhouse::net {

void answer_handshake(WebSocketStream& stream,
                      const boost::beast::http::request<boost::beast::http::empty_body>& request,
                      std::function<void(const boost::beast::error_code&)> done) {
  stream.async_accept(request, std::move(done));
}

}  // namespace playhouse::net
