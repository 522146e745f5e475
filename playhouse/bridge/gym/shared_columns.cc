#include "playhouse/bridge/gym/shared_columns.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "playhouse/base/formats.h"
#include "playhouse/base/version.h"

namespace playhouse::drivers::gym {
namespace {

constexpr std::size_t kAlignment = 64;  // of each column: a cache line
constexpr char kMagic[8] = {'p', 'l', 'h', 's', 'g', 'y', 'm', '\0'};

struct Head {
  char magic[8];
  std::uint32_t format, columns;
  std::uint64_t bytes;  // total size
  char build[40];       // base/version.h
};
struct Entry {
  char name[32];
  char dtype[8];
  std::uint32_t rows, columns;
  std::uint64_t offset;  // from the start of the memory
  std::uint64_t unused;
};
static_assert(sizeof(Head) == 64 && sizeof(Entry) == 64);

template <std::size_t N>
void put(char (&field)[N], std::string_view text) {
  std::memcpy(field, text.data(), std::min(text.size(), N - 1));
}

std::size_t aligned(std::size_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

Error system_error() {
  return Error{"", "no shared memory: " + std::generic_category().message(errno)};
}

}  // namespace

SharedColumns::~SharedColumns() {
  if (memory_ != nullptr) munmap(memory_, bytes_);
  if (descriptor_ >= 0) close(descriptor_);
}

Result<void> SharedColumns::make(std::span<const ColumnFormat> columns) {
  bytes_ = sizeof(Head) + columns.size() * sizeof(Entry);
  for (const ColumnFormat& column : columns) {
    offsets_.push_back(bytes_);
    bytes_ += aligned(std::size_t{column.rows} * std::max(column.columns, 1u) * column.value_bytes);
  }
  descriptor_ = memfd_create("playhouse gym", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (descriptor_ < 0 || ftruncate(descriptor_, static_cast<off_t>(bytes_)) != 0) return system_error();
  // The learning program has the descriptor, too: what it cuts off would end this program by SIGBUS.
  if (fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) return system_error();
  void* const memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  if (memory == MAP_FAILED) return system_error();
  memory_ = static_cast<std::byte*>(memory);

  Head head{{}, formats::kGym, static_cast<std::uint32_t>(columns.size()), bytes_, {}};
  std::memcpy(head.magic, kMagic, sizeof kMagic);
  put(head.build, build());
  std::memcpy(memory_, &head, sizeof head);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Entry entry{{}, {}, columns[i].rows, columns[i].columns, offsets_[i], 0};
    put(entry.name, columns[i].name);
    put(entry.dtype, columns[i].dtype);
    std::memcpy(memory_ + sizeof head + i * sizeof entry, &entry, sizeof entry);
  }
  return {};
}

}  // namespace playhouse::drivers::gym
