// Any bytes are changes of a running world, or are refused: 't' is a tick, anything else begins a packed
// change. What is applied is packed and unpacked to the same bytes, and does the same to a second world; what is refused
// has no effect.

#include <cstdint>
#include <span>

#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/changes/packed_change.h"

namespace {

using namespace playhouse;

constexpr const char* kWorld = R"(
define eye ranger( sensor( range [0 3] samples 3 ) )
define robot position( eye() gripper( pose [0.2 0 0 0] ) wifi() joules 1000 blinkenlight() )
robot( name "a" ) robot( name "b" pose [2 0 0 0] ctrl "wander" )
actuator( name "arm" pose [0 3 0 0] model() ) camera( pose [3 3 0 0] width 4 height 4 ) model( name "box" pose [1 1 0 0] )
imu( pose [4 4 0 0] ) lightindicator( pose [4 5 0 0] ) fiducial( pose [5 5 0 0] )
)";
constexpr std::size_t kModels = 256;
constexpr int kTicks = 8;

const scene::SceneDesc& the_scene() {
  static config::MemoryFiles files({}, {});
  static const Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "fuzz.world", files);
  PLAYHOUSE_ASSERT(scene.ok());
  return *scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto engine = stage::make_engine(the_scene(), {.seed = 1}),
             other = stage::make_engine(the_scene(), {.seed = 1});
  PLAYHOUSE_ASSERT(engine.ok() && other.ok());
  world::Journal journal((*engine)->world()), second((*other)->world());
  std::span<const std::byte> left = std::as_bytes(std::span(bytes, size));
  int ticks = 0;
  while (!left.empty() && ticks < kTicks && journal.world().models.size() < kModels) {
    if (left[0] == std::byte{'t'}) {
      left = left.subspan(1);
      (*engine)->step(), (*other)->step(), ++ticks;
      continue;
    }
    Unpacker in(left);
    const Result<world::Change> change = world::unpack_change(in);
    PLAYHOUSE_ASSERT(change.ok() || !change.error().text.empty());
    if (!change) break;
    left = left.last(in.left());
    // A state that is damaged may leave a world that cannot go on: stage_saved_run_fuzz.cc loads states.
    if (std::holds_alternative<world::changes::Load>(*change)) continue;
    std::vector<std::byte> packed, again;
    world::pack(*change, packed);
    Unpacker from(packed);
    world::pack(*world::unpack_change(from), again);
    PLAYHOUSE_ASSERT(packed == again);
    const std::uint64_t before = journal.world().hash();
    const bool is_done = journal.apply(*change);
    PLAYHOUSE_ASSERT(is_done == second.apply(*change));
    PLAYHOUSE_ASSERT(is_done || journal.world().hash() == before);
    PLAYHOUSE_ASSERT(journal.world().hash() == second.world().hash());
  }
  return 0;
}
