// Bytes from a client: messages from the first byte on.

#include "playhouse/wire/fuzz_stream.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::wire::fuzz_stream(std::as_bytes(std::span(data, size)));
  return 0;
}
