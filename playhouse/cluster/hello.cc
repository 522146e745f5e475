#include "playhouse/cluster/hello.h"

#include "playhouse/base/formats.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/version.h"

namespace playhouse::cluster {
namespace {

constexpr std::string_view kMagic = "playhouse cluster ";  // then the number of the format

}  // namespace

std::vector<std::byte> hello(std::string_view token) {
  std::vector<std::byte> body;
  Packer to(body);
  to.text(std::string(kMagic) + std::to_string(formats::kCluster));
  to.text(build());
  to.text(token);
  return body;
}

std::string why_not_joined(std::span<const std::byte> body, std::string_view token) {
  Unpacker in(body);
  const std::string magic = in.text();
  if (!in.ok() || !magic.starts_with(kMagic)) return "it does not speak the protocol of clusters";
  if (const std::string format = magic.substr(kMagic.size()); format != std::to_string(formats::kCluster))
    return "it speaks format " + in_quotes(format) + " of clusters, the run format " +
           std::to_string(formats::kCluster);
  // Results have to be the same to the bit, which other commits need not give.
  const std::string its_build = in.text();
  if (!in.ok() || its_build != build())
    return "it is Playhouse " + in_quotes(its_build) + ", the run " + in_quotes(build());
  const std::string its_token = in.text();
  return in.ok() && (token.empty() || its_token == token)
             ? ""
             : "its token is not that of the run; node --token takes it";
}

}  // namespace playhouse::cluster
