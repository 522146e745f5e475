#include "playhouse/web_server/host_names.h"

#include <gtest/gtest.h>

namespace playhouse::web_server {
namespace {

const HostNames names("robo.lab.example", {"robots.example"});

TEST(HostNames, has_addresses_and_the_machine_by_each_of_its_names) {
  for (const char* const ours :
       {"localhost", "localhost:8080", "127.0.0.1:8080", "[::1]:8080", "robo", "ROBO:80", "robo.local",
        "robo.lab.example:8080", "robots.example", "Robots.Example:443"})
    EXPECT_TRUE(names.has(ours)) << ours;
  for (const char* const other : {"", "evil.example", "robo.evil.example", "lab.example", "[::1", "1.2.3"})
    EXPECT_FALSE(names.has(other)) << other;
}

TEST(HostNames, are_controlled_by_pages_that_came_from_the_same_name_and_port) {
  EXPECT_TRUE(names.may_control("http://robo:8080", "robo:8080", false));
  EXPECT_FALSE(names.may_control("http://robo:8081", "robo:8080", false));
  EXPECT_FALSE(names.may_control("http://robo", "robo.local", false));
  EXPECT_FALSE(names.may_control("null", "robo:8080", false));
}

TEST(HostNames, have_a_proxy_that_speaks_tls_only_before_those_that_were_told) {
  EXPECT_TRUE(names.may_control("https://robots.example", "robots.example", false));
  EXPECT_FALSE(names.may_control("https://robo:8080", "robo:8080", false));
}

TEST(HostNames, are_controlled_by_encrypted_pages_alone_where_we_speak_tls) {
  EXPECT_TRUE(names.may_control("https://robo:8080", "robo:8080", true));
  EXPECT_FALSE(names.may_control("http://robo:8080", "robo:8080", true));
}

}  // namespace
}  // namespace playhouse::web_server
