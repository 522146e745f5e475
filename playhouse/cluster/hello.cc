#include "playhouse/cluster/hello.h"

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

constexpr const char* kMagic = "playhouse cluster 2";

}  // namespace

std::vector<std::byte> hello(std::string_view token) {
  std::vector<std::byte> body;
  Packer to(body);
  to.text(kMagic);
  to.text(PLAYHOUSE_VERSION);
  to.text(token);
  return body;
}

std::string why_not_joined(std::span<const std::byte> body, std::string_view token) {
  Unpacker in(body);
  const std::string magic = in.text(), version = in.text();
  if (!in.ok() || magic != kMagic) return "it does not speak the protocol of clusters";
  if (version == PLAYHOUSE_VERSION) {
    const std::string its = in.text();
    return in.ok() && (token.empty() || its == token)
               ? ""
               : "its token is not that of the run; node --token takes it";
  }
  return "it is version " + in_quotes(version) + " of Playhouse, the run " + in_quotes(PLAYHOUSE_VERSION);
}

}  // namespace playhouse::cluster
