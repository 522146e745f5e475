#include "playhouse/replicate/datagrams/datagram_viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "playhouse/replicate/importance.h"
#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/row_code.h"
#include "playhouse/replicate/scene_text.h"

namespace playhouse::replicate {
namespace {

constexpr std::size_t kStateHeadBytes = 12;   // tick and flags, at most
constexpr std::size_t kGroupBytes = 2;        // age and end
constexpr std::size_t kSayingsBytes = 16384;  // of one text
constexpr std::size_t kFewWaiting = 32768;    // bytes of texts; above it changes are merged into a later text
constexpr double kSignOfLife = 1;             // s
constexpr double kFarPeriod = 1;              // s between two states of what is out of view
constexpr double kSilence = 1, kQuietPeriod = 0.5;  // s: who is not heard of for the first gets little
constexpr double kEarly = 0.005;  // s that a frame may be before its time: timers are not exact

std::size_t varint_bytes(std::uint64_t value) {
  std::size_t bytes = 1;
  for (; value >= 0x80; value >>= 7) ++bytes;
  return bytes;
}

}  // namespace

DatagramViewer::DatagramViewer(std::uint64_t session, Terms terms, std::shared_ptr<const Layout> layout,
                               std::shared_ptr<const PackedText> scene, double now)
    : channel_(session, limits::kObserverCommandBytes),
      terms_(terms),
      told_(std::move(layout)),
      bucket_(terms.bytes_per_second, limits::kDatagramBytes + limits::kDatagramHeadBytes, now),
      heard_(now) {
  channel_.post(std::move(scene));
  rows_.resize(told_->id.size());
  first_told_at_ = channel_.texts().posted();
  for (const world::ModelRow row : rows_.rows()) {
    rows_[row].start = rows_[row].acknowledged = rows_[row].sent = told_->start[row];
    rows_[row].told_at = first_told_at_;
  }
}

Result<void> DatagramViewer::receive(std::span<const std::byte> rest, double now) {
  const Result<ReceivedPacket> heard = channel_.receive(rest, now);
  if (!heard) return heard.error();
  if (!heard->is_new) return {};
  heard_ = now;
  owes_ack_ = owes_ack_ || heard->has_text;
  for (;;) {
    const Result<std::optional<ReceivedText>> text = channel_.next_text();
    if (!text) return text.error();
    if (!*text) return {};
    const Result<void> done = execute((*text)->text);
    if (done) continue;
    notice(done.error().text);
    if (++faults_ >= limits::kViewerFaults) return Error{"", "too many invalid commands"};
  }
}

Result<void> DatagramViewer::execute(const std::string& text) {
  const Result<Command> command = parse_command(text);
  if (!command) return command.error();
  if (const auto* look = std::get_if<Look>(&*command)) {
    wish_.view = view_of(*look);
    return {};
  }
  if (const auto* select = std::get_if<Select>(&*command)) {
    wish_.selected = select->model;
    return {};
  }
  return Error{"", "an observer looks and selects; for the rest there is the page"};
}

void DatagramViewer::notice(std::string_view text) {
  if (channel_.texts().waiting() < kFewWaiting) post(fmt::format("{{\"notice\":{}}}", quoted(text)));
}

void DatagramViewer::offer(const Snapshot& snapshot, ChangesTexts& changes, double now, const Send& send) {
  bucket_.refill(now);
  settle(now);
  const bool is_silent = now - heard_ > kSilence;
  if (is_silent && now < quiet_due_) return;
  quiet_due_ = now + kQuietPeriod;
  follow(snapshot, changes);
  map_rows(snapshot);
  say(snapshot);
  candidates_.clear();
  next_candidate_ = 0;
  if (now >= frame_due_ - kEarly) {
    frame_due_ = std::max(frame_due_ + 1.0 / terms_.frames_per_second, now);
    prioritise(snapshot, now);
  }
  bool must = owes_ack_ || now >= life_due_ || told_paused_ != snapshot.pace.paused ||
              (!told_whole_ && is_whole(snapshot, 0));
  while (send_packet(snapshot, now, must, send) && !is_silent) must = false;
}

void DatagramViewer::settle(double now) {
  const Settled settled = channel_.settle(now);
  const auto each_row = [&](Seq seq, auto&& then) {
    const auto sent = sent_rows_.find(seq);
    if (sent == sent_rows_.end()) return;
    for (const SentRow& each : sent->second) {
      const auto row = told_->row(each.id);
      if (row && seq > rows_[row].floor) then(rows_[row], each.state);
    }
  };
  for (const Seq seq : settled.lost)
    each_row(seq, [seq](ReplicatedModel& row, const ModelState&) {
      row.is_lost = row.is_lost || row.sent_seq == seq;
    });
  for (const Seq seq : settled.acknowledged) {
    each_row(seq, [seq](ReplicatedModel& row, const ModelState& state) {
      if (seq > row.acknowledged_seq) {
        row.acknowledged = state;
        row.acknowledged_seq = seq;
      }
      if (row.sent_seq == seq) row.is_lost = false;
    });
    sent_rows_.erase(seq);
  }
  sent_rows_.erase(sent_rows_.begin(), sent_rows_.lower_bound(channel_.oldest()));
}

/// Sends the population difference once earlier text is nearly delivered; changes meanwhile are merged.
void DatagramViewer::follow(const Snapshot& snapshot, ChangesTexts& changes) {
  if (told_ == snapshot.layout || channel_.texts().waiting() >= kFewWaiting) return;
  const auto text = changes.text(told_, snapshot.layout);
  if (text) post(*text);
  const Layout& to = *snapshot.layout;
  world::ByModel<ReplicatedModel> rows(to.id.size());
  compare(
      *told_, to, [&](world::ModelRow before) { said_.erase(told_->id[before]); },
      [&](world::ModelRow before, world::ModelRow now) { rows[now] = rows_[before]; },
      [&](world::ModelRow now) {
        rows[now].start = rows[now].acknowledged = rows[now].sent = to.start[now];
        rows[now].floor = channel_.sent();
        rows[now].told_at = channel_.texts().posted();
      });
  rows_ = std::move(rows);
  told_ = snapshot.layout;
  said_number_.reset();
}

void DatagramViewer::map_rows(const Snapshot& snapshot) {
  if (mapped_ == snapshot.layout && now_row_.size() == rows_.size() && told_ == snapshot.layout) return;
  mapped_ = snapshot.layout;
  now_row_.assign(rows_.size(), {});
  compare(
      *told_, *mapped_, [](world::ModelRow) {},
      [&](world::ModelRow before, world::ModelRow now) { now_row_[before] = now; }, [](world::ModelRow) {});
}

/// Sends changed texts of models that the observer knows.
void DatagramViewer::say(const Snapshot& snapshot) {
  if (said_number_ == snapshot.said || channel_.texts().waiting() >= kFewWaiting) return;
  std::string news;
  bool all = told_ == snapshot.layout;
  const auto tell = [&](world::ModelId id, const std::string& text) {
    if (news.size() >= kSayingsBytes) return all = false;
    fmt::format_to(std::back_inserter(news), "{}[{},{}]", news.empty() ? "" : ",", id.value, quoted(text));
    return true;
  };
  std::map<world::ModelId, std::string> left = said_;  // texts that are not in the snapshot any more
  for (const Said& said : snapshot.says) {
    const world::ModelId id = snapshot.layout->id[said.model];
    left.erase(id);
    if (!told_->row(id)) continue;
    const auto held = said_.find(id);
    if (held != said_.end() && held->second == said.text) continue;
    if (tell(id, said.text)) said_[id] = said.text;
  }
  for (const auto& [id, text] : left)
    if (tell(id, {})) said_.erase(id);
  if (!news.empty()) post(fmt::format("{{\"says\":[{}]}}", news));
  if (all) said_number_ = snapshot.said;
}

/// Collects rows with changes, sorted by accumulated priority.
void DatagramViewer::prioritise(const Snapshot& snapshot, double now) {
  world::ModelRow selected;  // its root
  if (wish_.selected)
    if (const auto row = snapshot.layout->row(*wish_.selected)) selected = snapshot.layout->root[row];
  for (const world::ModelRow told : rows_.rows()) {
    ReplicatedModel& row = rows_[told];
    const world::ModelRow is = now_row_[told];
    if (!is || row.told_at > channel_.texts().taken()) continue;
    if (row.sent == snapshot.models[is] && !row.is_lost) continue;
    const geom::Vec2 at = place_of(snapshot, is);
    const bool is_selected = selected == snapshot.layout->root[is];
    if (!is_selected && is_out_of_view(wish_, at) && now - row.sent_time < kFarPeriod) continue;
    row.gathered += importance(wish_, is_selected, at, change_of(row.acknowledged, snapshot.models[is]));
    candidates_.push_back({row.gathered, told});
  }
  std::ranges::sort(candidates_, [](const SendCandidate& a, const SendCandidate& b) {
    return std::tuple(-a.gathered, a.row) < std::tuple(-b.gathered, b.row);
  });
}

/// Sends a packet if there is something to send, or if `must`. False: nothing was sent.
bool DatagramViewer::send_packet(const Snapshot& snapshot, double now, bool must, const Send& send) {
  const bool rows_wait = next_candidate_ < candidates_.size();
  if (!rows_wait && !channel_.texts().ready() && !must) return false;
  const double most = bucket_.left() - static_cast<double>(limits::kDatagramHeadBytes);
  if (most < kLeastPacket) return false;
  const std::size_t room = std::min(limits::kDatagramBytes, static_cast<std::size_t>(most));
  // Upper bound on the header: 10 + 8 + 8 + 4 + 10 + 3 + 10 bytes.
  constexpr std::size_t kHead = 53;
  const std::size_t texts_room = rows_wait ? room * 3 / 4 : room;
  const Seq seq = channel_.write(now, texts_room - kHead, packet_);
  write_rows(snapshot, now, seq, room - packet_.size());
  bucket_.spend(static_cast<double>(packet_.size() + limits::kDatagramHeadBytes));
  owes_ack_ = false;
  life_due_ = now + kSignOfLife;
  told_paused_ = snapshot.pace.paused;
  send(packet_);
  return true;
}

/// Appends the state: its header, and as many rows as fit.
void DatagramViewer::write_rows(const Snapshot& snapshot, double now, Seq seq, std::size_t room) {
  if (room < kStateHeadBytes) return;
  room -= kStateHeadBytes;
  Packer pack(packet_);
  pack.varint(snapshot.tick);
  const std::size_t flags = packet_.size();
  pack.u8(snapshot.pace.paused ? kStatePaused : 0);
  fields_.clear();
  written_.clear();
  std::vector<SentRow> sent;
  for (; next_candidate_ < candidates_.size(); ++next_candidate_) {
    const world::ModelRow told = candidates_[next_candidate_].row;
    if (!add_row(snapshot, seq, told, room)) break;
    ReplicatedModel& row = rows_[told];
    row.sent = snapshot.models[now_row_[told]];
    row.sent_seq = seq;
    row.sent_time = now;
    row.gathered = 0;
    row.is_lost = false;
    sent.push_back({told_->id[told], row.sent});
  }
  if (is_whole(snapshot, seq)) {
    packet_[flags] |= std::byte{kStateWhole};
    told_whole_ = true;
  }
  if (sent.empty()) return;
  pack_rows();
  sent_rows_[seq] = std::move(sent);
}

/// True if with packet `seq` (0: none) the observer has received a state of every model of the scene that
/// differs from its announcement. Later models do not count: in a run that spawns steadily some are always
/// unknown.
bool DatagramViewer::is_whole(const Snapshot& snapshot, Seq seq) {
  if (was_whole_) return true;
  if (channel_.texts().taken() < first_told_at_) return false;
  bool is_known = true;  // before this packet
  for (const world::ModelRow told : rows_.rows()) {
    const ReplicatedModel& row = rows_[told];
    const world::ModelRow is = now_row_[told];
    if (!is || row.acknowledged_seq > 0 || row.told_at > first_told_at_) continue;
    if (row.sent_seq == 0 && snapshot.models[is] == row.start) continue;
    if (row.sent_seq != seq) return false;
    is_known = false;
  }
  was_whole_ = is_known;
  return true;
}

/// Returns false if the row does not fit. The size is an upper bound, because rows are sorted later.
bool DatagramViewer::add_row(const Snapshot& snapshot, Seq seq, world::ModelRow told, std::size_t& room) {
  const ReplicatedModel& row = rows_[told];
  const ModelState& to = snapshot.models[now_row_[told]];
  const bool has_baseline = row.acknowledged_seq > 0 && seq - row.acknowledged_seq <= kOldestBaseline;
  const ModelState& from = has_baseline ? row.acknowledged : row.start;
  const std::uint8_t age = has_baseline ? static_cast<std::uint8_t>(seq - row.acknowledged_seq) : 0;
  std::uint8_t mask = changed_fields(from, to);
  if (mask == 0) mask = 1;  // back to the baseline: send a zero delta, to supersede the last state sent
  const std::size_t begin = fields_.size();
  Packer pack(fields_);
  write_fields(mask, from, to, pack);
  const bool is_new_group = std::ranges::find(written_, age, &Written::age) == written_.end();
  const std::size_t most_of_id = varint_bytes(2 * std::uint64_t{told_->ids_given});
  const std::size_t size = 1 + most_of_id + (fields_.size() - begin) + (is_new_group ? kGroupBytes : 0);
  if (size > room) {
    fields_.resize(begin);
    return false;
  }
  room -= size;
  written_.push_back({age, mask, told_->id[told].value, static_cast<std::uint32_t>(begin),
                      static_cast<std::uint32_t>(fields_.size())});
  return true;
}

void DatagramViewer::pack_rows() {
  std::ranges::sort(written_, [](const Written& a, const Written& b) {
    return std::tuple(a.age, a.id) < std::tuple(b.age, b.id);
  });
  Packer pack(packet_);
  for (std::size_t k = 0; k < written_.size();) {
    const std::uint8_t age = written_[k].age;
    pack.u8(age);
    for (std::uint32_t id = 0; k < written_.size() && written_[k].age == age; id = written_[k++].id) {
      pack.u8(written_[k].mask);
      pack.zigzag(static_cast<std::int64_t>(written_[k].id) - static_cast<std::int64_t>(id));
      packet_.insert(packet_.end(), fields_.begin() + written_[k].begin, fields_.begin() + written_[k].end);
    }
    pack.u8(0);
  }
}

bool DatagramViewer::holds(const Snapshot& snapshot) const {
  if (told_ != snapshot.layout || channel_.texts().waiting() > 0 || said_number_ != snapshot.said)
    return false;
  for (const world::ModelRow row : rows_.rows())
    if (rows_[row].acknowledged != snapshot.models[row] || rows_[row].sent != snapshot.models[row])
      return false;
  return true;
}

}  // namespace playhouse::replicate
