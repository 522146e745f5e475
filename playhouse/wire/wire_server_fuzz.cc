// Bytes from a server: a banner, then messages.

#include "playhouse/wire/fuzz_stream.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream = std::as_bytes(std::span(data, size));
  if (size >= playhouse::limits::kBannerBytes) {
    playhouse::wire::fuzz_stream(stream.subspan(playhouse::limits::kBannerBytes));
  }
  return 0;
}
