#include "playhouse/device/client.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/wire/header.h"

namespace playhouse::device {
namespace {

constexpr std::uint8_t kCmd = static_cast<std::uint8_t>(wire::MessageType::kCmd);
constexpr std::uint8_t kReq = static_cast<std::uint8_t>(wire::MessageType::kReq);

}  // namespace

DeviceClient::DeviceClient(Opener& opener, Driver& owner, std::size_t devices)
    : opener_(opener), owner_(owner), used_(devices) {}

Subscription& DeviceClient::latest(std::size_t device, std::uint8_t subtype) {
  return *used_[device].subscriptions.emplace_back(std::make_unique<Subscription>(subtype, 1));
}

Subscription& DeviceClient::queue(std::size_t device, std::size_t limit) {
  return *used_[device].subscriptions.emplace_back(std::make_unique<Subscription>(std::nullopt, limit));
}

void DeviceClient::use(std::size_t device, DeviceId id, Driver& driver) {
  PLAYHOUSE_ASSERT(device < used_.size() && used_[device].driver == nullptr);
  used_[device].id = id;
  used_[device].driver = &driver;
  if (std::ranges::find(held_, id) == held_.end()) held_.push_back(id);
}

void DeviceClient::join(DataFlow& flow) {
  flow.add(*this, held_);
}

bool DeviceClient::ready() const {
  return std::ranges::all_of(used_, [](const Used& used) { return used.driver->ready(used.id); });
}

void DeviceClient::prepare(Driver::Prepared heard) {
  // Shared by the pending ones: the last one reports.
  struct Pending {
    std::size_t left;
    Driver::Prepared heard;
    Result<void> outcome;
  };
  const auto pending = std::make_shared<Pending>(Pending{used_.size() + 1, std::move(heard), {}});
  const auto report = [pending](const Result<void>& outcome) {
    if (!outcome && pending->outcome) pending->outcome = outcome.error();
    if (--pending->left == 0) pending->heard(pending->outcome);
  };
  for (const Used& used : used_)
    used.driver->ready(used.id) ? report({}) : used.driver->prepare(used.id, report);
  report({});
}

Result<void> DeviceClient::open() {
  for (const Used& used : used_)
    for (const auto& subscription : used.subscriptions) subscription->clear();
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Result<void> held = opener_.hold(held_[i], &owner_);
    if (held) continue;
    while (i > 0) opener_.release(held_[--i], &owner_);
    return held;
  }
  open_ = true;
  return {};
}

void DeviceClient::close() {
  if (!open_.exchange(false)) return;
  for (const DeviceId id : held_) opener_.release(id, &owner_);
}

Taken DeviceClient::command(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body) {
  if (!open_) return Taken::kNo;
  return used_[device].driver->command({used_[device].id, kCmd, subtype, body});
}

void DeviceClient::ask(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body,
                       Heard heard) {
  forward(device, subtype, body, replier_for(std::move(heard)));
}

void DeviceClient::forward(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body,
                           Replier replier) {
  used_[device].driver->request({used_[device].id, kReq, subtype, body}, std::move(replier));
}

bool DeviceClient::capable(std::size_t device, std::uint8_t type, std::uint8_t subtype) const {
  return used_[device].driver->capable(used_[device].id, type, subtype);
}

void DeviceClient::barrier(Replier replier) {
  // Shared by the pending barriers: replies when the last one is done.
  const std::shared_ptr<Replier> all(new Replier(std::move(replier)), [](Replier* done) {
    done->ack();
    delete done;
  });
  for (const Used& used : used_)
    used.driver->barrier(replier_for([all](const std::optional<std::vector<std::byte>>&) {}));
}

Replier DeviceClient::replier_for(Heard heard) {
  const std::lock_guard lock(mutex_);
  asked_[next_ticket_] = std::move(heard);
  return {*this, next_ticket_++};
}

void DeviceClient::answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) {
  Heard heard;
  {
    const std::lock_guard lock(mutex_);
    const auto found = asked_.find(ticket);
    PLAYHOUSE_ASSERT(found != asked_.end());  // a replier replies once
    heard = std::move(found->second);
    asked_.erase(found);
  }
  heard(ack ? std::optional(std::move(body)) : std::nullopt);
}

void DeviceClient::read(std::span<const Publication* const> fresh, std::vector<Publication>& more) {
  if (!open_) return;
  for (const Publication* publication : fresh) {
    for (const Used& used : used_) {
      if (used.id != publication->device) continue;
      for (const auto& subscription : used.subscriptions) subscription->put(*publication);
    }
  }
  if (news_) news_(more);
}

}  // namespace playhouse::device
