#include "playhouse/cluster/node.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::cluster {
namespace {

Error unexpected() {
  return {"", "does not speak the protocol of clusters"};
}

}  // namespace

Node::Node(MessageStream stream, std::string token, Seconds patience)
    : stream_(std::move(stream)), token_(std::move(token)), patience_(patience) {
  stream_.accept_up_to(limits::kClusterMessageBytes);
}

/// A run may be paused for as long as its user likes: without patience, waits for ever for a message to
/// begin.
Result<NodeMessage> Node::next(std::optional<Seconds> patience) {
  const Result<NodeMessage> message = stream_.wait(patience);
  if (!message || message->type != NodeMessageType::kRefusal) return message;
  Unpacker in(message->body);
  return Error{"", "refuses this node: " + escaped(in.text())};
}

/// False: the run has ended.
Result<bool> Node::join(const NodeEngineMaker& make) {
  if (const Result<void> sent = stream_.send(NodeMessageType::kHello, {hello(token_)}, kPatience); !sent)
    return sent.error();
  const Result<NodeMessage> world = next(patience_);
  if (!world) return world.error();
  if (world->type == NodeMessageType::kEnd) return false;
  if (world->type != NodeMessageType::kWorld) return unexpected();
  Result<world::SavedRun> run = world::decode_saved_run(world->body);
  if (!run) return Error{"", "sent a world that " + run.error().text};
  const Result<world::Engine*> engine = make(std::move(*run));
  if (!engine) {
    Bytes why;
    Packer(why).text(engine.error().line());
    static_cast<void>(stream_.send(NodeMessageType::kRefusal, {why}, kPatience));
    return Error{"", "runs a world that this node cannot: " + engine.error().line()};
  }
  engine_ = *engine;
  engine_->divide(this);
  if (const Result<void> sent = stream_.send(NodeMessageType::kReady, {}, kPatience); !sent)
    return sent.error();
  return true;
}

Result<void> Node::prepare(const Step& step) {
  world::World& world = engine_->world();
  if (!step.state.empty())
    if (const Result<void> loaded = world::load_whole(world, step.state); !loaded)
      return Error{"", "sent a state that " + loaded.error().text};
  for (Unpacker in(step.changes); !in.at_end();) {
    const Result<world::Change> change = world::unpack_change(in);
    if (!change) return Error{"", "sent a step that " + change.error().text};
    if (!world::apply(world, *change))
      return Error{"", fmt::format("sent a change \"{}\" that cannot be made here", world::name_of(*change))};
  }
  share_ = step.share;
  hashes_.reset();
  if (step.check) hashes_ = Hashes{world.hash(), world.sensed_hash()};
  return {};
}

Result<Node::Summary> Node::run(const NodeEngineMaker& make) {
  const Result<bool> joined = join(make);
  if (!joined) return joined.error();
  Summary summary;
  if (!*joined) return summary;
  for (;;) {
    const Result<NodeMessage> message = next();
    if (!message) return message.error();
    if (message->type == NodeMessageType::kEnd) return summary;
    if (message->type != NodeMessageType::kStep) return unexpected();
    const Result<Step> step = decode_step(message->body);
    if (!step) return step.error();
    if (const Result<void> prepared = prepare(*step); !prepared) return prepared.error();
    if (summary.ticks++ == 0) summary.from = engine_->world().time();
    shared_ = {};
    engine_->step();
    if (!shared_) return shared_.error();
    summary.to = engine_->world().time();
  }
}

void Node::run(world::DividedWork& work) {
  shared_ = share(work);
}

Result<void> Node::share(world::DividedWork& work) {
  Bytes head, results;
  if (hashes_) {
    Packer(head).u64(hashes_->done);
    Packer(head).u64(hashes_->sensed);
  }
  work.compute(share_, results);
  if (const Result<void> sent = stream_.send(NodeMessageType::kShare, {head, results}, kPatience); !sent)
    return sent;
  for (std::size_t i = 1; i < share_.count; ++i) {
    const Result<NodeMessage> others = next();
    if (!others) return others.error();
    if (others->type != NodeMessageType::kResults) return unexpected();
    Unpacker in(others->body);
    const auto index = static_cast<std::size_t>(in.varint());
    if (!in.ok() || index >= share_.count || index == share_.index ||
        !work.take({index, share_.count}, in.bytes(in.left())))
      return Error{"", "sent invalid results"};
  }
  return {};
}

}  // namespace playhouse::cluster
