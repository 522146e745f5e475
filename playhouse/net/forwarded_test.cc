// Whom X-Forwarded-For names, of proxies that are trusted and of others. The truths are written out by hand.

#include "playhouse/net/forwarded.h"

#include <gtest/gtest.h>

#include <string>

namespace playhouse::net {
namespace {

class Forwarded : public ::testing::Test {
 protected:
  std::string client(const std::string& peer, std::string_view forwarded) const {
    const Result<std::string> client = proxies_.client_of(peer, forwarded);
    return client ? *client : client.error().text;
  }
  const TrustedProxies proxies_ = *TrustedProxies::parse("10.0.0.2,10.0.0.3, ::1");
};

TEST_F(Forwarded, by_a_trusted_proxy_names_the_last_client_that_is_no_proxy) {
  EXPECT_EQ(client("10.0.0.2:4242", "203.0.113.5"), "203.0.113.5:4242");
  EXPECT_EQ(client("10.0.0.2:4242", "127.0.0.1, 203.0.113.5"), "203.0.113.5:4242") << "the first is invented";
  EXPECT_EQ(client("10.0.0.2:4242", "nonsense,203.0.113.5 , 10.0.0.3"), "203.0.113.5:4242");
  EXPECT_EQ(client("10.0.0.2:4242", "203.0.113.5:80"), "203.0.113.5:4242");
  EXPECT_EQ(client("[::1]:4242", "2001:DB8::7"), "[2001:db8::7]:4242");
  EXPECT_EQ(client("[::1]:4242", "[2001:db8::7]"), "[2001:db8::7]:4242");
  EXPECT_EQ(client("[::1]:4242", "[2001:db8::7]:80"), "[2001:db8::7]:4242");
  EXPECT_EQ(client("[::ffff:10.0.0.2]:4242", "::ffff:203.0.113.5"), "203.0.113.5:4242");
  EXPECT_EQ(client("10.0.0.2:4242", "10.0.0.3, 10.0.0.2"), "10.0.0.3:4242") << "a proxy's own page";
  EXPECT_EQ(client("10.0.0.2:4242", ""), "10.0.0.2:4242");
}

TEST_F(Forwarded, by_anybody_else_is_ignored) {
  EXPECT_EQ(client("10.0.0.9:4242", "203.0.113.5"), "10.0.0.9:4242");
  EXPECT_EQ(client("10.0.0.9:4242", "nonsense"), "10.0.0.9:4242");
  EXPECT_EQ(*TrustedProxies().client_of("10.0.0.2:4242", "203.0.113.5"), "10.0.0.2:4242");
}

TEST_F(Forwarded, that_is_no_address_is_refused) {
  for (const char* text :
       {"unknown", "_hidden", "203.0.113", "203.0.113.5,", ",", " ", "203.0.113.5:", "203.0.113.5:x",
        "203.0.113.5:123456", "[203.0.113.5]", "[::1", "[::1]x", "[::1]:", "fe80::1%eth0", "0x7f.1",
        "203.0.113.05 10.0.0.1", "203.0.113.5;10.0.0.2", "\"203.0.113.5\""})
    EXPECT_FALSE(proxies_.client_of("10.0.0.2:4242", text)) << text;
  EXPECT_EQ(client("10.0.0.2:4242", "1.1.1.1, unknown"), "invalid address \"unknown\" in X-Forwarded-For");
}

TEST_F(Forwarded, needs_numeric_addresses_of_proxies) {
  EXPECT_EQ(TrustedProxies::parse("::1,localhost").error().text,
            "invalid proxy \"localhost\": a numeric address is valid");
  for (const char* text : {"", "10.0.0.2,", "10.0.0.2:80", "10.0.0.0/8", "[::1]"})
    EXPECT_FALSE(TrustedProxies::parse(text)) << text;
  std::string many = "10.0.1.0";
  for (int k = 1; k <= 16; ++k) many += ",10.0.1." + std::to_string(k);
  EXPECT_EQ(TrustedProxies::parse(many).error().text, "too many proxies: up to 16 are possible");
}

}  // namespace
}  // namespace playhouse::net
