#include "playhouse/net/http_places.h"

#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/monotonic.h"

namespace playhouse::net {

HttpPlace::HttpPlace(std::shared_ptr<HttpPlaces> places, const std::string& peer)
    : places_(std::move(places)), network_(network_of(peer)) {
  places_->add(*this);
}

HttpPlace::~HttpPlace() {
  places_->remove(*this);
}

void HttpPlace::gives_way(std::function<void()> close) {
  waits_since_ = monotonic_seconds();
  close_ = std::move(close);
}

void HttpPlaces::add(HttpPlace& place) {
  const std::vector<HttpPlace*> of_network = waiting(place.network_);
  const bool many = of_network.size() >= limits::kHttpConnectionsPerAddress;
  // Logged once per episode, against flooding the log.
  if ((many || all_.size() >= limits::kHttpConnections) && !std::exchange(full_, true))
    log::warn("web: many connections ({}, {} from {}): those that wait longest are closed", all_.size(),
              of_network.size(), place.network_);
  if (many) close_one_of(of_network);
  for (auto all = waiting(); all_.size() >= limits::kHttpConnections && !all.empty(); all = waiting())
    close_one_of(all);
  all_.push_back(&place);
}

void HttpPlaces::remove(HttpPlace& place) {
  std::erase(all_, &place);
  if (all_.size() < limits::kHttpConnections / 4) full_ = false;
}

std::vector<HttpPlace*> HttpPlaces::waiting(std::string_view network) const {
  std::vector<HttpPlace*> result;
  for (HttpPlace* place : all_) {
    if (place->close_ && (network.empty() || place->network_ == network)) result.push_back(place);
  }
  return result;
}

void HttpPlaces::close_one_of(const std::vector<HttpPlace*>& waiting) {
  std::vector<Holder> holders;
  holders.reserve(waiting.size());
  for (const HttpPlace* place : waiting) holders.push_back({place->network_, place->waits_since_});
  HttpPlace& place = *waiting[gives_way(holders)];
  remove(place);
  std::exchange(place.close_, nullptr)();
}

}  // namespace playhouse::net
