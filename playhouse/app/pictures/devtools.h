#pragma once

/// Chrome DevTools protocol (https://chromedevtools.github.io/devtools-protocol/):
/// calls to a browser and its pages, and their events.

#include <boost/json.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/app/pictures/browser.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class DevTools {
 public:
  /// Handles events of a browser or page that arrive while waiting for something else.
  using BrowserEvents = std::function<void(std::string_view event, const boost::json::object& about)>;

  /// The browser must be running, and outlive this.
  explicit DevTools(Browser& browser) : browser_(browser) {}
  void on_events(BrowserEvents events) { events_ = std::move(events); }
  /// Directs further calls to the page of that session.
  void attach(std::string session) { session_ = std::move(session); }

  /// Calls a method and returns its result. Fails, with a predicate for the
  /// browser's name, on timeout, on an error reply, and on malformed messages.
  Result<boost::json::object> call(std::string_view method, boost::json::object parameters, double seconds);
  /// A call without waiting for its reply.
  void tell(std::string_view method, boost::json::object parameters);
  /// Processes events until `done` is true.
  Result<void> wait(const std::function<bool()>& done, double seconds);

  /// Evaluates a JavaScript expression in the page, awaiting
  /// promises. Fails like call(), and on exceptions.
  Result<boost::json::value> evaluate(std::string_view expression, double seconds);

 private:
  /// Processes the next message: returns a reply, or none for an event.
  Result<std::optional<boost::json::object>> take_message(Browser::Deadline deadline);

  Browser& browser_;
  BrowserEvents events_;
  std::string session_;  // empty: the browser itself
  std::int64_t calls_ = 0;
};

}  // namespace playhouse::app
