#include "playhouse/app/pictures/devtools.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "playhouse/base/in_quotes.h"

namespace playhouse::app {
namespace {

namespace json = boost::json;

Browser::Deadline in(double seconds) {
  return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                std::chrono::duration<double>(seconds));
}

/// A text member of a message; empty if missing.
std::string_view text_of(const json::object& message, std::string_view key) {
  const json::value* const value = message.if_contains(key);
  const json::string* const text = value == nullptr ? nullptr : value->if_string();
  return text == nullptr ? std::string_view() : std::string_view(*text);
}

/// An object member of a message; null if missing.
const json::object* object_of(const json::object& message, std::string_view key) {
  const json::value* const value = message.if_contains(key);
  return value == nullptr ? nullptr : value->if_object();
}

/// Message of an exception: "Error: it is too large\n    at draw (...)" is "it is too large".
std::string_view said_by(std::string_view thrown) {
  thrown = thrown.substr(0, thrown.find('\n'));
  constexpr std::string_view kError = "Error: ";
  if (thrown.starts_with(kError)) thrown.remove_prefix(kError.size());
  return thrown;
}

std::string thrown_in(const json::object& details) {
  const json::object* const exception = object_of(details, "exception");
  const std::string_view about = exception == nullptr ? "" : text_of(*exception, "description");
  return "cannot draw it: " + escaped(about.empty() ? text_of(details, "text") : said_by(about));
}

}  // namespace

Result<json::object> DevTools::call(std::string_view method, json::object parameters, double seconds) {
  tell(method, std::move(parameters));
  const std::int64_t id = calls_;
  const Browser::Deadline deadline = in(seconds);
  for (;;) {
    const Result<std::optional<json::object>> answer = take_message(deadline);
    if (!answer) return answer.error();
    const json::value* const of = *answer ? (*answer)->if_contains("id") : nullptr;
    if (of == nullptr || *of != id) continue;  // an event, or the reply of a tell()
    if (const json::object* const error = object_of(**answer, "error"))
      return Error{"", fmt::format("refuses {}: {}", method, escaped(text_of(*error, "message")))};
    const json::object* const result = object_of(**answer, "result");
    return result == nullptr ? json::object() : *result;
  }
}

void DevTools::tell(std::string_view method, json::object parameters) {
  json::object message{{"id", ++calls_}, {"method", method}, {"params", std::move(parameters)}};
  if (!session_.empty()) message["sessionId"] = session_;
  browser_.send(json::serialize(message));
}

Result<void> DevTools::wait(const std::function<bool()>& done, double seconds) {
  const Browser::Deadline deadline = in(seconds);
  while (!done())
    if (const auto message = take_message(deadline); !message) return message.error();
  return {};
}

Result<std::optional<json::object>> DevTools::take_message(Browser::Deadline deadline) {
  const Result<std::string> bytes = browser_.receive(deadline);
  if (!bytes) return bytes.error();
  boost::system::error_code failed;
  json::value message = json::parse(*bytes, failed);
  if (failed || !message.is_object())
    return Error{"", "sent an invalid message: " + in_quotes(std::string_view(*bytes).substr(0, 80))};
  json::object& content = message.get_object();
  const std::string_view event = text_of(content, "method");
  if (event.empty()) return std::optional(std::move(content));
  if (event == "Inspector.targetCrashed" || event == "Target.detachedFromTarget")
    return Error{"", "lost its page: it crashed"};
  const json::object* const about = object_of(content, "params");
  if (events_) events_(event, about == nullptr ? json::object() : *about);
  return std::optional<json::object>();
}

Result<json::value> DevTools::evaluate(std::string_view expression, double seconds) {
  const Result<json::object> answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}},
           seconds);
  if (!answer) return answer.error();
  if (const json::object* const details = object_of(*answer, "exceptionDetails"))
    return Error{"", thrown_in(*details)};
  const json::object* const result = object_of(*answer, "result");
  const json::value* const value = result == nullptr ? nullptr : result->if_contains("value");
  return value == nullptr ? json::value() : *value;
}

}  // namespace playhouse::app
