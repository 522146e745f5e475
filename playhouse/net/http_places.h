#pragma once

/// Connection slots of an HTTP server; internal to net.
/// Connections that wait for their peer (to send a request, read
/// a reply, close) can be evicted by new ones; viewers cannot.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/net/fair_share.h"

namespace playhouse::net {

class HttpPlaces;

/// RAII slot of a connection, from accept until
/// its socket is closed, by any owner.
class HttpPlace {
 public:
  /// Evicts another connection first if the server is full.
  HttpPlace(std::shared_ptr<HttpPlaces> places, const std::string& peer);
  ~HttpPlace();
  HttpPlace(const HttpPlace&) = delete;
  HttpPlace& operator=(const HttpPlace&) = delete;

  /// Makes the connection evictable from now on; `close` is called at most once.
  void gives_way(std::function<void()> close);
  /// Makes the connection non-evictable.
  void stays() { close_ = nullptr; }

 private:
  friend HttpPlaces;
  std::shared_ptr<HttpPlaces> places_;
  const std::string network_;
  double waits_since_ = 0;  // s
  std::function<void()> close_;
};

class HttpPlaces {
 public:
  void add(HttpPlace& place);
  void remove(HttpPlace& place);

 private:
  /// Evictable connections, all or of one network.
  std::vector<HttpPlace*> waiting(std::string_view network = {}) const;
  void close_one_of(const std::vector<HttpPlace*>& waiting);

  std::vector<HttpPlace*> all_;
  bool full_ = false;  // has been logged
};

}  // namespace playhouse::net
