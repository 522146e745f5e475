#include "playhouse/server/out_queue.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::server {

void OutQueue::add(Frame frame) {
  const QueueAction action = rules_.action_for(frame);
  if (action == QueueAction::kIgnore) return;
  if (frame.is_answer()) {
    add_answer(std::move(frame), action);
  } else {
    add_data(std::move(frame), action);
  }
}

void OutQueue::add_data(Frame frame, QueueAction action) {
  const std::uint64_t code = frame.kind();
  QueuedKind& kind = kinds_[code];
  if (action == QueueAction::kReplace && kind.waiting > 0) remove_data(kind.newest);
  data_bytes_ += frame.bytes->size();
  data_.push_back({{next_number_++, std::move(frame)}, data_.end(), data_.end()});
  const QueuePlace place = std::prev(data_.end());
  if (kind.waiting > 0) {
    place->older = kind.newest;
    kind.newest->newer = place;
  } else {
    kind.oldest = place;
  }
  kind.newest = place;
  count(code, kind.waiting + 1, kind.lost);
  while (over_limits()) drop_one();
}

void OutQueue::count(std::uint64_t code, std::size_t waiting, std::uint64_t lost) {
  QueuedKind& kind = kinds_.at(code);
  if (kind.waiting > 0) shares_.erase({kind.waiting, kind.lost, code});
  kind.waiting = waiting;
  kind.lost = lost;
  if (kind.waiting > 0) shares_.insert({kind.waiting, kind.lost, code});
}

// The newest message of each kind always fits by count, though not by bytes.
bool OutQueue::over_limits() const {
  if (data_.empty()) return false;
  return data_bytes_ > limits::kSessionQueueBytes ||
         (data_.size() > limits::kSessionQueueMessages && shares_.begin()->waiting > 1);
}

// The kind with the most messages loses its oldest; ties go to the one with the fewest losses.
void OutQueue::drop_one() {
  const std::uint64_t code = shares_.begin()->kind;
  const QueuedKind& kind = kinds_.at(code);
  remove_data(kind.oldest);
  count(code, kind.waiting, kind.lost + 1);
  count_lost(1);
}

// Saturates: the wire field is 32 bit.
void OutQueue::count_lost(std::uint64_t messages) {
  dropped_ += messages;
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  unreported_drops_ = static_cast<std::uint32_t>(std::min(kMost, unreported_drops_ + messages));
}

void OutQueue::add_answer(Frame frame, QueueAction action) {
  if (action == QueueAction::kReplace) {
    const auto old = std::find_if(answers_.rbegin(), answers_.rend(), [&](const QueuedFrame& entry) {
      return entry.frame.kind() == frame.kind();
    });
    if (old != answers_.rend()) {
      answer_bytes_ -= old->frame.bytes->size();
      answers_.erase(std::next(old).base());
    }
  }
  answer_bytes_ += frame.bytes->size();
  answers_.push_back({next_number_++, std::move(frame)});
}

void OutQueue::request_data(Frame answer) {
  answer_bytes_ += answer.bytes->size();
  answers_.push_front({0, std::move(answer)});
  data_requested_ = true;
  data_delivered_ = false;
}

void OutQueue::forget(std::uint16_t interf, std::uint16_t index) {
  const std::uint64_t first = Frame{.interf = interf, .index = index, .type = wire::MessageType{0}}.kind();
  const std::uint64_t last = first | 0xFFFF;  // all types and subtypes
  for (auto next = kinds_.lower_bound(first); next != kinds_.end() && next->first <= last;) {
    while (next->second.waiting > 0) remove_data(next->second.oldest);
    next = kinds_.erase(next);
  }
}

void OutQueue::add_notice(std::uint16_t interf, std::uint16_t index, Frame frame) {
  notice_bytes_ += frame.bytes->size();
  notice_numbers_[{interf, index}] = next_number_;
  notices_[next_number_++] = {interf, index, std::move(frame)};
}

void OutQueue::replace_device(std::uint16_t interf, std::uint16_t index) {
  const auto number = notice_numbers_.find({interf, index});
  if (number == notice_numbers_.end()) return;
  Frame notice = take_notice(number->second);
  answer_bytes_ += notice.bytes->size();
  answers_.push_back({next_number_++, std::move(notice)});
}

void OutQueue::drop_data() {
  while (!data_.empty()) drop_one();
}

void OutQueue::forget_data() {
  while (!data_.empty()) remove_data(data_.begin());
}

void OutQueue::clear() {
  data_.clear();
  kinds_.clear();
  shares_.clear();
  answers_.clear();
  notices_.clear();
  notice_numbers_.clear();
  data_bytes_ = answer_bytes_ = notice_bytes_ = 0;
  data_requested_ = data_delivered_ = false;
}

void OutQueue::remove_data(QueuePlace place) {
  const std::uint64_t code = place->frame.kind();
  QueuedKind& kind = kinds_.at(code);
  (place->older == data_.end() ? kind.oldest : place->older->newer) = place->newer;
  (place->newer == data_.end() ? kind.newest : place->newer->older) = place->older;
  count(code, kind.waiting - 1, kind.lost);
  data_bytes_ -= place->frame.bytes->size();
  data_.erase(place);
}

void OutQueue::take(std::vector<net::SharedBytes>& out, std::size_t max_bytes, double now) {
  std::size_t size = 0;
  while (size < max_bytes) {
    Frame frame;
    if (unasked_ && !data_.empty()) data_requested_ = true;
    if (round_is_over()) {
      frame = finish_round(now);
    } else if (may_send()) {
      frame = pop();
    } else {
      return;
    }
    size += frame.bytes->size();
    out.push_back(std::move(frame.bytes));
  }
}

// Replies do not wait for a round, nor do they start one for data.
bool OutQueue::may_send() const {
  return !answers_.empty() || may_tell() || may_send_data();
}

bool OutQueue::may_send_data() const {
  return !data_.empty() && (mode_ == DeliveryMode::kPush || data_requested_);
}

bool OutQueue::may_tell() const {
  return !notices_.empty() && !awaited_ && (mode_ == DeliveryMode::kPush || data_requested_ || unasked_);
}

// A round contains what was queued when its first data was sent,
// so that it ends even if data arrives faster than it is sent.
bool OutQueue::round_is_over() const {
  if (mode_ != DeliveryMode::kPull || !data_requested_ || !data_delivered_) return false;
  const bool answer_left = !answers_.empty() && answers_.front().number <= round_end_;
  const bool data_left = !data_.empty() && data_.front().number <= round_end_;
  const bool notice_left = may_tell() && notices_.begin()->first <= round_end_;
  return !answer_left && !data_left && !notice_left;
}

// Pops the oldest entry that may be sent now.
Frame OutQueue::pop() {
  constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t answer = answers_.empty() ? kNone : answers_.front().number;
  const std::uint64_t data = may_send_data() ? data_.front().number : kNone;
  if (may_tell() && notices_.begin()->first < std::min(answer, data))
    return take_notice(notices_.begin()->first);
  if (answer < data) {
    Frame frame = std::move(answers_.front().frame);
    answers_.pop_front();
    answer_bytes_ -= frame.bytes->size();
    return frame;
  }
  if (data_requested_ && !std::exchange(data_delivered_, true)) round_end_ = next_number_ - 1;
  Frame frame = data_.front().frame;
  remove_data(data_.begin());
  return frame;
}

// Also drops the statistics of the retired device.
Frame OutQueue::take_notice(std::uint64_t number) {
  const Notice notice = std::move(notices_.extract(number).mapped());
  notice_numbers_.erase({notice.interf, notice.index});
  notice_bytes_ -= notice.frame.bytes->size();
  forget(notice.interf, notice.index);
  return notice.frame;
}

Frame OutQueue::finish_round(double now) {
  data_requested_ = data_delivered_ = false;
  wire::Header header;
  header.interf = wire::player::kCode;
  header.type = wire::MessageType::kSynch;
  header.timestamp = now;
  const std::uint32_t lost = std::exchange(unreported_drops_, 0);
  if (lost == 0) {
    header.subtype = wire::player::kSynchOk;
    return make_frame(header, {});
  }
  header.subtype = wire::player::kSynchOverflow;
  return make_frame(header, wire::encode(wire::Uint32{lost}));
}

}  // namespace playhouse::server
