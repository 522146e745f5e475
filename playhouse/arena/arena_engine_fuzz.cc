/// Any world runs in this engine (stage/fuzz_engine.h).

#include "playhouse/arena/engine.h"
#include "playhouse/stage/fuzz_engine.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse;
  return stage::fuzz::fuzz_engine(
      bytes, size, [](const scene::SceneDesc& scene) { return arena::make_engine(scene, {}); });
}
