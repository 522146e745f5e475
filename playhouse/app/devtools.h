#pragma once

/// The Chrome DevTools protocol (https://chromedevtools.github.io/devtools-protocol/): calls to a browser and
/// its pages, and the events that come in between.

#include <boost/json.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/app/browser.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class DevTools {
 public:
  /// Hears what a browser or its page tells by itself, while one waits for something else.
  using Events = std::function<void(std::string_view event, const boost::json::object& about)>;

  /// The browser has started, and outlives this.
  explicit DevTools(Browser& browser) : browser_(browser) {}
  void on_events(Events events) { events_ = std::move(events); }
  /// What is called from now on is for the page of that session.
  void attach(std::string session) { session_ = std::move(session); }

  /// What the browser answers to a method. Fails, with a text that goes on from the browser's name, where it
  /// does not within so many seconds, where it answers with an error, and where what it sends is no message.
  Result<boost::json::object> call(std::string_view method, boost::json::object parameters, double seconds);
  /// A call whose answer nobody waits for.
  void tell(std::string_view method, boost::json::object parameters);
  /// Until an event has made `done` true.
  Result<void> wait(const std::function<bool()>& done, double seconds);

  /// The value of an expression of JavaScript in the page, or what it promises. Fails as call(), and with
  /// what the page throws.
  Result<boost::json::value> evaluate(std::string_view expression, double seconds);

 private:
  /// Takes the next message: gives an answer, or none where it was an event.
  Result<std::optional<boost::json::object>> take_message(Browser::Deadline deadline);

  Browser& browser_;
  Events events_;
  std::string session_;  // empty: the browser itself
  std::int64_t calls_ = 0;
};

}  // namespace playhouse::app
