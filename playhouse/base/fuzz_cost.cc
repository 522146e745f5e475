/// What an input costs, for all fuzzers: it is linked into each, around its LLVMFuzzerTestOneInput (--wrap,
/// in cmake/Playhouse.cmake). An input whose memory does not follow its size ends the fuzzer as a crash does:
/// all that it takes at once, and all that it takes in turn, which is a measure of time that no other program
/// on the machine disturbs. Time itself is libFuzzer's -timeout. Processes that an input forks have limits of
/// their own (mesh/cost.h), and are not counted. PLAYHOUSE_FUZZ_COST=1 prints what each input costs.

#include <pthread.h>
#include <sanitizer/allocator_interface.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int __real_LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int __wrap_LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// Seeds take up to 90 MiB at once and 160 MiB in turn, for worlds that they run; others 1 MiB. A chunk of a
// recording may unpack to 256 MiB, and is packed again.
constexpr std::int64_t kAtOnce = 768 << 20, kAtOnceEach = 4096;
constexpr std::int64_t kInTurn = std::int64_t{2} << 30, kInTurnEach = 256 << 10;

struct Cost {
  std::atomic<std::int64_t> at_once = 0, most = 0, in_turn = 0;  // B
  std::int64_t most_at_once = 0, most_in_turn = 0;               // allowed
  std::atomic<bool> is_counted = false;
};
Cost cost;

[[noreturn]] void end_as_a_crash(const char* what, std::int64_t bytes, std::int64_t allowed) {
  cost.is_counted = false;
  std::fprintf(stderr, "fuzz_cost: the input takes %lld bytes %s, and may take %lld by its size\n",
               static_cast<long long>(bytes), what, static_cast<long long>(allowed));
  std::abort();
}

void took(const volatile void*, std::size_t size) {
  if (!cost.is_counted.load(std::memory_order_relaxed)) return;
  const auto bytes = static_cast<std::int64_t>(size);
  const std::int64_t at_once = cost.at_once += bytes, in_turn = cost.in_turn += bytes;
  if (at_once > cost.most) cost.most = at_once;
  if (at_once > cost.most_at_once) end_as_a_crash("at once", at_once, cost.most_at_once);
  if (in_turn > cost.most_in_turn) end_as_a_crash("in turn", in_turn, cost.most_in_turn);
}

void gave_back(const volatile void* memory) {
  if (memory == nullptr || !cost.is_counted.load(std::memory_order_relaxed)) return;
  cost.at_once -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(const_cast<const void*>(memory)));
}

bool begin() {
  pthread_atfork(nullptr, nullptr, [] { cost.is_counted = false; });
  if (__sanitizer_install_malloc_and_free_hooks(took, gave_back) == 0) std::abort();
  return std::getenv("PLAYHOUSE_FUZZ_COST") != nullptr;
}

}  // namespace

int __wrap_LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool prints = begin();
  const auto bytes = static_cast<std::int64_t>(size);
  cost.most_at_once = kAtOnce + kAtOnceEach * bytes;
  cost.most_in_turn = kInTurn + kInTurnEach * bytes;
  cost.at_once = cost.most = cost.in_turn = 0;
  cost.is_counted = true;
  const int result = __real_LLVMFuzzerTestOneInput(data, size);
  cost.is_counted = false;
  if (prints)
    std::fprintf(stderr, "fuzz_cost: %zu bytes: %lld KiB at once, %lld in turn\n", size,
                 static_cast<long long>(cost.most >> 10), static_cast<long long>(cost.in_turn >> 10));
  return result;
}
