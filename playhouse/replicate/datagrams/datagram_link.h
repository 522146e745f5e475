#pragma once

/// DatagramLink: test fixture: a DatagramViewer and a DatagramObserver after their
/// handshake, over a lossy network in virtual time, and a small world to replicate.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/replicate/datagrams/datagram_observer.h"
#include "playhouse/replicate/datagrams/datagram_viewer.h"
#include "playhouse/replicate/scene_text.h"
#include "playhouse/replicate/small_world.h"

namespace playhouse::replicate {

struct LinkFaults {
  double loss = 0, duplication = 0;  // chance of each
  double delay = 0.02, jitter = 0;   // s
};

class DatagramLink {
 public:
  static constexpr std::uint64_t kNonce = 7, kSession = 11;
  static constexpr double kPeriod = 0.033;

  DatagramLink(SmallWorld& small, LinkFaults faults, std::uint64_t seed, Terms terms = {64000, 30})
      : faults(faults),
        small_(small),
        rng_(seed),
        layout_(small.layout()),
        observer(kNonce, terms, "", 0),
        viewer(kSession, terms, layout_,
               pack_text(scene_text(small.world.scene(), "null", small.prototypes, *layout_)), 0) {
    observer.receive(encode(Welcome{kNonce, kSession, terms}), 0);
    capture_now();
  }

  /// One frame: captures and sends the state, then delivers what is due.
  void frame() {
    capture_now();
    time += kPeriod;
    viewer.offer(snapshot, changes_, time, [this](std::span<const std::byte> datagram) {
      sent_bytes += datagram.size() + limits::kDatagramHeadBytes;
      if (datagram.size() > longest) longest = datagram.size();
      if (on_sent) on_sent(datagram);
      carry(datagram, true);
    });
    while (const auto datagram = observer.next(time))
      if (!observer_is_dead) carry(*datagram, false);
    deliver();
  }

  /// Runs frames until the observer's replica equals the snapshot, at most so many.
  bool settle(int frames) {
    for (; frames > 0 && !viewer.holds(snapshot); --frames) frame();
    return viewer.holds(snapshot);
  }

  void capture_now() {
    if (layout_->population != small_.world.population()) layout_ = small_.layout({}, layout_.get());
    capture(small_.world, pace, layout_, {}, snapshot);
  }

  LinkFaults faults;
  world::Pace pace;
  double time = 0;
  std::size_t sent_bytes = 0, longest = 0;
  bool observer_is_dead = false;
  bool somebody_else_writes = false;  // spoofs the observer: its own packets may be rejected
  std::function<void(std::span<const std::byte>)> on_sent;
  Snapshot snapshot;

 private:
  void carry(std::span<const std::byte> datagram, bool to_observer) {
    const int copies = (rng_.uniform() < faults.loss ? 0 : 1) + (rng_.uniform() < faults.duplication ? 1 : 0);
    for (int copy = 0; copy < copies; ++copy)
      on_its_way_.emplace(time + faults.delay + faults.jitter * rng_.uniform(),
                          std::pair(to_observer, std::vector(datagram.begin(), datagram.end())));
  }

  void deliver() {
    while (!on_its_way_.empty() && on_its_way_.begin()->first <= time) {
      const auto each = on_its_way_.extract(on_its_way_.begin());
      const auto& [to_observer, datagram] = each.mapped();
      if (to_observer) {
        if (!observer_is_dead) observer.receive(datagram, time);
        continue;
      }
      const Result<Datagram> parsed = parse_datagram(datagram);
      PLAYHOUSE_ASSERT(parsed.ok());
      const Result<void> taken = viewer.receive(std::get<PacketOf>(*parsed).rest, time);
      PLAYHOUSE_ASSERT(taken.ok() || somebody_else_writes);
    }
  }

  SmallWorld& small_;
  Rng rng_;
  std::shared_ptr<const Layout> layout_;
  ChangesTexts changes_;
  std::multimap<double, std::pair<bool, std::vector<std::byte>>> on_its_way_;

 public:
  DatagramObserver observer;
  DatagramViewer viewer;
};

}  // namespace playhouse::replicate
