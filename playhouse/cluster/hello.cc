#include "playhouse/cluster/hello.h"

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

constexpr const char* kMagic = "playhouse cluster 1";

}  // namespace

std::vector<std::byte> hello() {
  std::vector<std::byte> body;
  Packer to(body);
  to.text(kMagic);
  to.text(PLAYHOUSE_VERSION);
  return body;
}

std::string why_not_joined(std::span<const std::byte> body) {
  Unpacker in(body);
  const std::string magic = in.text(), version = in.text();
  if (!in.ok() || magic != kMagic) return "it does not speak the protocol of clusters";
  if (version == PLAYHOUSE_VERSION) return {};
  return "it is version " + in_quotes(version) + " of Playhouse, the run " + in_quotes(PLAYHOUSE_VERSION);
}

}  // namespace playhouse::cluster
