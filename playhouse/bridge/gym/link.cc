#include "playhouse/bridge/gym/link.h"

#include <sys/socket.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include "playhouse/base/limits.h"

namespace playhouse::drivers::gym {
namespace {

enum Verb : std::uint32_t { kStep = 1, kStartAgain = 2 };

/// Reply header, followed by the error text; without a text: success.
struct Answer {
  std::uint32_t failed = 0;
  std::uint32_t bytes = 0;
};

}  // namespace

struct Link::Request {
  std::uint32_t verb = 0;
  std::uint32_t ticks = 0;  // for kStep
  std::uint64_t seed = 0;   // for kStartAgain
};

Link::~Link() {
  shutdown(socket_, SHUT_RDWR);
  if (listener_.joinable()) listener_.join();
  close(socket_);
}

Result<void> Link::start() {
  if (const Result<void> begun = agents_.begin(); !begun) {
    answer(begun.error().text);
    return begun;
  }
  if (const Result<void> sent = send_memory(); !sent) return sent;
  listener_ = std::thread([this] { listen(); });
  return {};
}

Result<void> Link::send_memory() const {
  Answer ready;
  iovec part{&ready, sizeof ready};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* const head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = SOL_SOCKET;
  head->cmsg_type = SCM_RIGHTS;
  head->cmsg_len = CMSG_LEN(sizeof(int));
  const int descriptor = agents_.columns().descriptor();
  std::memcpy(CMSG_DATA(head), &descriptor, sizeof descriptor);
  if (sendmsg(socket_, &message, MSG_NOSIGNAL) == sizeof ready) return {};
  return Error{"", "--socket: " + std::generic_category().message(errno)};
}

/// False at end of stream.
bool Link::receive(Request& request) const {
  auto* at = reinterpret_cast<char*>(&request);
  for (std::size_t left = sizeof request; left > 0;) {
    const ssize_t got = recv(socket_, at, left, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    left -= static_cast<std::size_t>(got);
  }
  return true;
}

void Link::listen() {
  for (Request request; receive(request);) carry_out(request);
  simulation_.requests().stop();
}

/// Posts the change, then the step that it precedes.
void Link::carry_out(const Request& request) {
  const bool is_step = request.verb == kStep;
  if (!is_step && request.verb != kStartAgain) return answer("there is no such request");
  if (is_step && (request.ticks == 0 || request.ticks > limits::kStepTicks))
    return answer(fmt::format("a step has 1 to {} ticks", limits::kStepTicks));
  const auto change = [this, is_step, seed = request.seed](world::Journal& journal) {
    why_not_.clear();
    if (is_step) return agents_.act(journal);
    if (const Result<void> started = simulation_.restart(seed); !started) {
      why_not_ = started.error().line();
    } else {
      agents_.reset_all(journal);
    }
  };
  // One at a time, so it may exceed the queue's limit.
  simulation_.requests().post_always(change, {});
  simulation_.lock_step()->step(this, "the learning program", is_step ? request.ticks : 1,
                                [this](const std::optional<std::string>& why_not) {
                                  if (why_not) return answer(*why_not);
                                  agents_.observe();
                                  answer(why_not_);
                                });
}

/// Does not block, since the peer is waiting for it; disconnection is detected by recv().
void Link::answer(const std::string& why_not) const {
  const Answer head{!why_not.empty(), static_cast<std::uint32_t>(why_not.size())};
  std::vector<char> bytes(sizeof head + why_not.size());
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, why_not.data(), why_not.size());
  static_cast<void>(send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

}  // namespace playhouse::drivers::gym
