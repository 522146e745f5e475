/// The bytes of a client of the page's server, whole and in small pieces. The answers are the same, each is
/// one of HTTP/1.1, there is one for each request, and nothing follows a refusal.

#include <charconv>
#include <string>
#include <string_view>

#include "playhouse/base/assert.h"
#include "playhouse/net/fuzz_connection.h"

namespace playhouse::net {
namespace {

class Service final : public HttpService {
 public:
  Result<void> serves(const std::string& host) override {
    if (host == "stranger") return Error{"", "no stranger here"};
    return {};
  }
  HttpReply get(const HttpRequest& request) override {
    PLAYHOUSE_ASSERT(request.path.starts_with('/') && request.path.find('?') == std::string::npos);
    PLAYHOUSE_ASSERT(request.host != "stranger" && request.host.find_first_of("/ @,") == std::string::npos);
    ++answers;
    HttpReply reply;
    reply.etag = "\"1\"";
    reply.text = std::make_shared<const std::string>("asked for " + request.host + request.path);
    return reply;
  }
  Result<void> may_upgrade(const HttpRequest&) override { return Error{"", "no viewers here"}; }
  void upgraded(std::unique_ptr<WebSocket>, const HttpRequest&) override { PLAYHOUSE_ASSERT(false); }

  int answers = 0;
};

/// "HTTP/1.1 200 " and the like; no text of a refusal begins so.
bool is_status_line(std::string_view text) {
  return text.starts_with("HTTP/1.1 ") && text.size() > 13 && text[12] == ' ' &&
         text.substr(9, 3).find_first_not_of("0123456789") == std::string_view::npos;
}

std::size_t length_of(std::string_view head) {
  constexpr std::string_view kName = "\r\nContent-Length: ";
  const std::size_t at = head.find(kName);
  std::size_t length = 0;
  if (at != std::string_view::npos) {
    const std::string_view value = head.substr(at + kName.size());
    std::from_chars(value.data(), value.data() + value.size(), length);
  }
  return length;
}

/// What follows the first answer.
std::string_view after_answer(std::string_view answers) {
  const std::size_t end = answers.find("\r\n\r\n");
  PLAYHOUSE_ASSERT(is_status_line(answers) && end != std::string_view::npos);
  const std::string_view body = answers.substr(end + 4);
  if (body.empty() || is_status_line(body)) return body;  // to HEAD: a length and no body
  const std::size_t length = length_of(answers.substr(0, end));
  PLAYHOUSE_ASSERT(length > 0 && length <= body.size());
  return body.substr(length);
}

/// The answers without the refusal at their end; `served`: how many the service gave.
std::string_view checked(std::string_view answers, int served) {
  std::string_view rest = answers;
  while (rest.starts_with("HTTP/1.1 200 ") || rest.starts_with("HTTP/1.1 304 ")) {
    rest = after_answer(rest);
    --served;
  }
  PLAYHOUSE_ASSERT(served == 0);
  PLAYHOUSE_ASSERT(rest.empty() || after_answer(rest).empty());
  return answers.substr(0, answers.size() - rest.size());
}

/// What was served of it. Where the bytes make no request, the pieces may decide what is said of it.
std::string answers_to(std::span<const std::byte> bytes, std::size_t piece) {
  Service service;
  FuzzConnection connection(service);
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(piece, bytes.size())))
    connection.send(bytes.first(std::min(piece, bytes.size())));
  connection.finish();
  while (!connection.forgotten()) connection.turn();
  connection.turn();
  PLAYHOUSE_ASSERT(connection.closed());
  return std::string(checked(connection.received, service.answers));
}

}  // namespace
}  // namespace playhouse::net

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const std::string at_once = playhouse::net::answers_to(bytes, bytes.size());
  PLAYHOUSE_ASSERT(playhouse::net::answers_to(bytes, 1 + size / 64) == at_once);
  return 0;
}
