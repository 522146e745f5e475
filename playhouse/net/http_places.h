#pragma once

/// The connections of one HTTP server; for the .cc files of net only. A connection that waits for its peer
/// (to send a request, to read an answer, to close) gives way to a newcomer; one that became a viewer does
/// not.

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/net/fair_share.h"

namespace playhouse::net {

class HttpPlaces;

/// What a connection holds from when it is accepted until its socket is closed, whoever has the socket by
/// then.
class HttpPlace {
 public:
  /// Closes another connection first, if there are too many.
  HttpPlace(std::shared_ptr<HttpPlaces> places, const std::string& peer);
  ~HttpPlace();
  HttpPlace(const HttpPlace&) = delete;
  HttpPlace& operator=(const HttpPlace&) = delete;

  /// The connection waits from now on, and `close` ends it for a newcomer; it is called once at most.
  void gives_way(std::function<void()> close);
  /// Nobody takes this place.
  void stays() { close_ = nullptr; }

 private:
  friend HttpPlaces;
  std::shared_ptr<HttpPlaces> places_;
  const std::string network_;
  std::chrono::steady_clock::time_point waits_since_;
  std::function<void()> close_;
};

class HttpPlaces {
 public:
  void add(HttpPlace& place);
  void remove(HttpPlace& place);

 private:
  /// Those that give way: all, or those of one network.
  std::vector<HttpPlace*> waiting(std::string_view network = {}) const;
  void close_one_of(const std::vector<HttpPlace*>& waiting);

  std::vector<HttpPlace*> all_;
  bool full_ = false;  // and the log says so
};

}  // namespace playhouse::net
