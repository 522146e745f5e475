#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "playhouse/net/simulated.h"
#include "playhouse/observers/cookie.h"
#include "playhouse/observers/observer_client.h"
#include "playhouse/observers/observer_server.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/world/population/population.h"

namespace playhouse::observers {
namespace {

using replicate::SmallWorld;

/// A server in virtual time, whose world takes a step and is shown every 50 ms.
class Observers : public testing::Test {
 protected:
  void open(ObserverOptions options = {}) {
    options.bind = "10.0.0.1";
    options.port = 7000;
    server_ = std::make_unique<ObserverServer>(network_, std::move(options), feed_);
    ASSERT_EQ(*server_->listen(), 7000);
  }

  void run_for(double seconds, bool moves = true) {
    for (const double end = network_.now() + seconds; network_.now() < end;) {
      if (moves) small_.tick();
      if (feed_.wants_show()) feed_.show(small_.world, {});
      network_.run_for(0.05);
    }
  }

  std::unique_ptr<ObserverClient> join(const std::string& host = "10.0.0.2", const std::string& token = "",
                                       std::uint32_t bytes = 0) {
    return *ObserverClient::open(
        network_, there(), {bytes, 30}, token, [] {}, host);
  }

  static net::Endpoint there() { return *net::parse_endpoint("10.0.0.1", 7000); }

  void expect_same(replicate::DatagramObserver& observer) {
    ASSERT_FALSE(observer.ended()) << *observer.ended();
    const world::World& world = small_.world;
    ASSERT_EQ(observer.world().models().size(), world.models.size());
    for (const world::ModelRow row : world.models.rows())
      EXPECT_EQ(observer.world().models().at(world.models.id[row].value).state,
                replicate::model_state(world, row));
  }

  /// A socket of no observer, which notes what comes.
  std::unique_ptr<net::DatagramSocket> stranger(const std::string& host = "10.0.0.66") {
    return *network_.open_datagrams(host, 0, [this](const net::Endpoint&, std::span<const std::byte> bytes) {
      heard_.emplace_back(bytes.begin(), bytes.end());
    });
  }

  net::SimulatedNetwork network_{42};
  SmallWorld small_{20};
  replicate::SnapshotFeed feed_{small_.world, {}, [this] { return network_.now(); }};
  std::unique_ptr<ObserverServer> server_;
  std::vector<std::vector<std::byte>> heard_;
};

TEST_F(Observers, hold_the_world_over_a_network_that_loses_half_of_all) {
  open();
  network_.datagrams = {.loss = 0.5, .duplication = 0.2, .delay = 0.02, .jitter = 0.1};
  const auto one = join(), other = join("10.0.0.3");
  run_for(6);
  ASSERT_TRUE(world::spawn(small_.world, SmallWorld::robot(0), {1, 2, 0, 3}).ok());
  run_for(2);
  run_for(15, false);
  EXPECT_EQ(server_->status().observers, 2u);
  expect_same(one->observer());
  expect_same(other->observer());
  EXPECT_GT(one->observer().packets_missing(), one->observer().packets() / 2);
}

TEST_F(Observers, come_late_leave_and_are_gone_when_they_vanish) {
  open();
  auto one = join();
  run_for(1);
  const auto late = join("10.0.0.3");
  run_for(1);
  run_for(0.5, false);
  expect_same(late->observer());
  one->leave();
  one.reset();
  run_for(1);
  EXPECT_EQ(server_->status().observers, 1u);
  network_.datagrams.loss = 1;
  run_for(limits::kObserverQuietSeconds + 1);
  EXPECT_EQ(server_->status().observers, 0u);
  EXPECT_FALSE(feed_.wants_show());
  EXPECT_EQ(late->observer().ended(), "nothing was heard of it for 10 s");
}

TEST_F(Observers, are_told_when_the_program_ends) {
  open();
  const auto one = join();
  run_for(1);
  server_->say_goodbye("the run has ended");
  run_for(0.1);
  EXPECT_EQ(one->observer().ended(), "the run has ended");
}

TEST_F(Observers, need_the_token_of_a_guest_and_who_was_sent_out_of_the_page_is_out_here) {
  server::GuestBook book{{server::GuestRole::kHuman, "blue-chair-7", "Bob"}};
  open({.guests = book});
  const auto nobody = join("10.0.0.2"), wrong = join("10.0.0.3", "red-chair-9");
  const auto bob = join("10.0.0.4", "blue-chair-7");
  run_for(1);
  EXPECT_EQ(nobody->observer().ended(), "--token with the token that you were given is needed");
  EXPECT_TRUE(wrong->observer().ended());
  EXPECT_TRUE(bob->observer().has_joined());
  EXPECT_EQ(server_->status().refused, 2u);
  book.send_out("blue-chair-7");
  const auto again = join("10.0.0.5", "blue-chair-7");
  run_for(1);
  EXPECT_EQ(again->observer().ended(), server::kSentOut);
}

TEST_F(Observers, are_ended_when_they_are_sent_out_and_do_not_come_again_without_the_token) {
  server::GuestBook book{{server::GuestRole::kHuman, "blue-chair-7", "Bob"},
                         {server::GuestRole::kHuman, "red-chair-77", "Eve"},
                         {server::GuestRole::kObserver, "*", ""}};
  open({.guests = book});
  const auto bob = join("10.0.0.4", "blue-chair-7"), same = join("10.0.0.4"),
             eve = join("10.0.0.4", "red-chair-77"), other = join("10.0.0.5");
  run_for(1);
  EXPECT_EQ(server_->status().observers, 4u);
  book.send_out("blue-chair-7");
  book.send_out_network("10.0.0.4:1");
  server_->end_sent_out();
  run_for(1);
  EXPECT_EQ(bob->observer().ended(), server::kSentOut);
  EXPECT_EQ(same->observer().ended(), server::kSentOut);
  EXPECT_FALSE(eve->observer().ended()) << "another token";
  EXPECT_FALSE(other->observer().ended());
  const auto again = join("10.0.0.4"), elsewhere = join("10.0.0.6", "blue-chair-7");
  run_for(1);
  EXPECT_EQ(again->observer().ended(), server::kSentOut);
  EXPECT_EQ(elsewhere->observer().ended(), server::kSentOut);
}

TEST_F(Observers, of_one_address_take_half_of_the_places_at_most) {
  open({.observers = 4});
  std::vector<std::unique_ptr<ObserverClient>> same;
  for (int k = 0; k < 3; ++k) same.push_back(join("10.0.0.2"));
  run_for(1);
  EXPECT_EQ(server_->status().observers, 2u);
  const auto other = join("10.0.0.3");
  run_for(1);
  EXPECT_TRUE(other->observer().has_joined());
  EXPECT_EQ(same.back()->observer().ended(), "limit reached: 2 observers from one address");
}

TEST_F(Observers, are_no_more_than_their_limit_and_get_no_more_than_the_program_gives) {
  open({.observers = 1, .bytes_per_second = 5000});
  const auto one = join("10.0.0.2", "", 100000);
  run_for(1);
  const auto two = join("10.0.0.3");
  run_for(1);
  EXPECT_EQ(one->observer().terms().bytes_per_second, 5000u);
  EXPECT_EQ(two->observer().ended(), "limit reached: 1 observers");
}

TEST_F(Observers, who_does_not_prove_its_address_gets_no_more_than_it_sends) {
  open();
  const auto spoofer = stranger();
  std::size_t sent = 0;
  const auto send = [&](const replicate::Datagram& datagram) {
    const auto bytes = replicate::encode(datagram);
    sent += bytes.size();
    spoofer->send(there(), bytes);
  };
  for (std::uint64_t k = 0; k < 50; ++k) {
    send(replicate::Hello{1, k});
    send(replicate::Hello{9, k});  // of another format
    send(replicate::JoinRequest{1, k, k, {64000, 30}, ""});
    send(replicate::PacketOf{k, {}});
    send(replicate::Bye{k, "bye"});
  }
  run_for(1);
  std::size_t got = 0;
  for (const auto& datagram : heard_) got += datagram.size();
  const auto refusal = replicate::parse_datagram(heard_[1]);
  ASSERT_TRUE(refusal && std::holds_alternative<replicate::Refusal>(*refusal));
  EXPECT_EQ(std::get<replicate::Refusal>(*refusal).why, "this observer speaks format 9, the run format 1");
  EXPECT_EQ(heard_.size(), 100u);  // one answer for each hello
  EXPECT_LE(got, sent);
  EXPECT_EQ(server_->status().observers, 0u);
}

TEST_F(Observers, a_cookie_is_good_for_its_address_and_for_seconds) {
  const Cookies cookies({1, 2});
  const net::Endpoint here = *net::parse_endpoint("10.0.0.2", 5), there = *net::parse_endpoint("10.0.0.2", 6);
  const std::uint64_t cookie = cookies.make(here, 7, 100);
  EXPECT_TRUE(cookies.is_good(cookie, here, 7, 100));
  EXPECT_TRUE(cookies.is_good(cookie, here, 7, 100 + Cookies::kLifeSeconds));
  EXPECT_FALSE(cookies.is_good(cookie, here, 7, 100 + 2 * Cookies::kLifeSeconds));
  EXPECT_FALSE(cookies.is_good(cookie, there, 7, 100));
  EXPECT_FALSE(cookies.is_good(cookie, here, 8, 100));
  EXPECT_FALSE(Cookies({1, 3}).is_good(cookie, here, 7, 100));
}

TEST_F(Observers, a_session_is_of_its_address_and_number_alone) {
  open();
  const auto one = join();
  run_for(1);
  const auto other = stranger();
  for (std::uint64_t session = 0; session < 100; ++session) {
    other->send(there(), replicate::encode(replicate::Bye{session, "bye"}));
    other->send(there(), replicate::encode(replicate::PacketOf{session, {}}));
  }
  run_for(1);
  EXPECT_EQ(server_->status().observers, 1u);
  EXPECT_GE(server_->status().ignored, 200u - 100u);
  EXPECT_FALSE(one->observer().ended());
}

TEST_F(Observers, rubbish_is_ignored) {
  open();
  const auto one = join();
  run_for(1);
  const auto other = stranger("10.0.0.2");  // of the same host
  Rng rng(5);
  for (int k = 0; k < 1000; ++k) {
    std::vector<std::byte> bytes(rng.bits() % 100);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(rng.bits());
    if (!bytes.empty()) bytes[0] = std::byte{'P'};
    if (bytes.size() > 1) bytes[1] = static_cast<std::byte>(rng.bits() % 9);
    other->send(there(), bytes);
  }
  run_for(1);
  run_for(1, false);
  expect_same(one->observer());
}

}  // namespace
}  // namespace playhouse::observers
