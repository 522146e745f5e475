// A learning program that asks for anything and writes anything into the shared memory: each request is
// answered once, and the world stays one. A byte for each step: a request of so many ticks, one to begin
// again, any request, or bytes for the memory, at an offset of two bytes.

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/bridge/gym/link.h"
#include "playhouse/run/simulation.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"

namespace playhouse::drivers::gym {
namespace {

constexpr const char* kWorld =
    "interval_sim 100\n"
    "define laser ranger( sensor( samples 3 fov 180 ) )\n"
    "position( name \"a\" laser() ) position( name \"b\" pose [2 0 0 0] laser() )\n";
constexpr int kSteps = 32;

class Program {
 public:
  Program() {
    std::array<int, 2> ends{};
    PLAYHOUSE_ASSERT(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
    socket_ = ends[0];
    link_ = std::make_unique<Link>(simulation_, ends[1]);
    PLAYHOUSE_ASSERT(link_->start());
    take_memory();
    ticks_ = std::thread([this] { simulation_.run(); });
  }
  ~Program() {
    close(socket_);
    ticks_.join();
    link_.reset();
    for (const geom::Pose& X_WM : simulation_.engine().world().models.X_WM)
      PLAYHOUSE_ASSERT(std::isfinite(X_WM.x) && std::isfinite(X_WM.y) && std::isfinite(X_WM.a));
    munmap(memory_.data(), memory_.size());
  }
  void ask(std::uint32_t verb, std::uint32_t ticks, std::uint64_t seed) {
    struct {
      std::uint32_t verb, ticks;
      std::uint64_t seed;
    } const request{verb, ticks, seed};
    PLAYHOUSE_ASSERT(send(socket_, &request, sizeof request, MSG_NOSIGNAL) == ssize_t{sizeof request});
    std::array<std::uint32_t, 2> head{};
    PLAYHOUSE_ASSERT(recv(socket_, head.data(), sizeof head, MSG_WAITALL) == ssize_t{sizeof head});
    PLAYHOUSE_ASSERT((head[0] != 0) == (head[1] != 0) && head[1] < 1000);
    std::string why(head[1], '\0');
    if (!why.empty())
      PLAYHOUSE_ASSERT(recv(socket_, why.data(), why.size(), MSG_WAITALL) ==
                       static_cast<ssize_t>(why.size()));
  }
  void write(std::size_t offset, std::span<const std::byte> bytes) {
    const auto to = memory_.subspan(offset % memory_.size());
    std::copy_n(bytes.begin(), std::min(bytes.size(), to.size()), to.begin());
  }

 private:
  static const scene::SceneDesc& the_scene() {
    static config::MemoryFiles files({}, {});
    static const Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "fuzz.world", files);
    PLAYHOUSE_ASSERT(scene.ok());
    return *scene;
  }
  void take_memory() {
    std::array<std::uint32_t, 2> ready{};
    iovec part{ready.data(), sizeof ready};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    PLAYHOUSE_ASSERT(recvmsg(socket_, &message, 0) == ssize_t{sizeof ready});
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof descriptor);
    struct stat status {};
    PLAYHOUSE_ASSERT(fstat(descriptor, &status) == 0);
    const auto bytes = static_cast<std::size_t>(status.st_size);
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    PLAYHOUSE_ASSERT(memory != MAP_FAILED);
    close(descriptor);
    memory_ = {static_cast<std::byte*>(memory), bytes};
  }

  run::Simulation simulation_{*stage::make_engine(the_scene(), {}),
                              {.speed = 0, .duration = 1e9, .lock_step = run::LockStep::LockStepOptions{}}};
  int socket_ = -1;
  std::unique_ptr<Link> link_;
  std::span<std::byte> memory_;
  std::thread ticks_;
};

std::uint32_t word(FuzzScript& script) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | script.byte();
  return value;
}

void play(FuzzScript script) {
  constexpr std::uint32_t kStep = 1, kStartAgain = 2;
  Program program;
  for (int step = 0; step < kSteps && !script.done(); ++step) {
    switch (script.byte() % 4) {
      case 0:
        program.ask(kStep, script.byte(), 0);
        break;
      case 1:
        program.ask(kStartAgain, 0, script.byte());
        break;
      case 2: {
        const std::uint32_t verb = word(script);
        if (verb != kStep) program.ask(verb, word(script), script.byte());  // a million ticks take too long
        break;
      }
      default: {
        const std::size_t offset = std::size_t{script.byte()} << 8;
        program.write(offset | script.byte(), script.take(script.byte()));
      }
    }
  }
}

}  // namespace
}  // namespace playhouse::drivers::gym

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::drivers::gym::play(playhouse::FuzzScript(std::as_bytes(std::span(data, size))));
  return 0;
}
