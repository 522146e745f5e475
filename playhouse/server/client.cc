#include "playhouse/server/client.h"

#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"

namespace playhouse::server {
namespace {

constexpr std::size_t kWriteBytes = 256u
                                    << 10;  // of one gathered write; the rest stays where it can be replaced
constexpr double kLastAnswers = 5;          // s; timeout for the next reply to a client that has half-closed

}  // namespace

std::string host_of(const net::Connection& connection) {
  return net::is_local(connection.peer()) ? "" : net::network_of(connection.peer());
}

void Client::start(const net::SharedBytes& banner) {
  session_.caller().expect_alive_by([this] { connection_->expect_alive(); });
  connection_->start(*this);
  connection_->send(std::span(&banner, 1));
  silence_ = network_.after(limits::kSilentSeconds, [this] { owner_.remove_silent(*this); });
}

void Client::received(std::span<const std::byte> bytes) {
  session_.receive(bytes);
  if (session_.has_message()) connection_->pause();  // back-pressure until the session has caught up
  owner_.make_room();
  owner_.schedule();
}

void Client::drained() {
  if (end_ && !lost_) begin_end();  // it still reads: restart the timeout
  session_.mark_due();
  owner_.schedule();
}

void Client::lost() {
  lost_ = true;
  session_.lose_peer();
  begin_end();
  session_.mark_due();
  owner_.schedule();
}

// The peer may have half-closed, to read the remaining replies.
void Client::closed(const std::string& why) {
  log::debug("{}: {}", session_.peer(), why);
  input_over_ = true;
  if (!end_) begin_end();
  session_.mark_due();
  owner_.schedule();
}

void Client::begin_end() {
  end_ = network_.after(kLastAnswers, [this] { owner_.remove(serial_); });
}

std::size_t Client::advance() {
  const std::size_t worked = session_.work();
  if (worked > 0 && session_.caller().rights().reads) silence_.reset();
  owner_.deliver_outbox();  // drivers may have replied synchronously
  if (!session_.broken().empty() && !std::exchange(input_over_, true)) {
    log::warn("{}: closed: {}", session_.peer(), session_.broken());
    owner_.broke(*this);
    connection_->pause();
    begin_end();
  }
  pump();
  session_.unmark_due();
  if (session_.can_work()) {
    session_.mark_due();
  } else if (input_over_ && !session_.has_message()) {
    session_.leave();
    if (at_end()) remove();
  } else if (owner_.is_over() && has_everything()) {
    remove();
  } else if (!session_.has_message()) {
    connection_->resume();
  }
  return worked;
}

// Closes only after all pending replies are sent, unless the peer is lost.
bool Client::at_end() const {
  if (lost_) return true;
  return !session_.waits_for_answers() && !session_.has_output() && connection_->in_flight_bytes() == 0;
}

// After the run: data in PULL mode still has to be requested.
bool Client::has_everything() const {
  return !session_.has_message() && session_.messages_waiting() == 0 && at_end();
}

void Client::tell_unread() const {
  if (session_.data_waiting() > 0)
    log::warn("{}: {} data messages were not read before the end", session_.peer(), session_.data_waiting());
}

void Client::remove() {
  connection_->close_after_flush();
  owner_.remove(serial_);
}

// If a write is pending, `drained` calls this again.
void Client::pump() {
  if (connection_->in_flight_bytes() > 0) return;
  parts_.clear();
  session_.take(parts_, kWriteBytes);
  if (!parts_.empty()) connection_->send(parts_);
  parts_.clear();
}

}  // namespace playhouse::server
