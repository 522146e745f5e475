#include "playhouse/world/saving/saved_run.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "playhouse/base/hash.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"

namespace playhouse::world {
namespace {

constexpr std::string_view kMagic = "playhouse saved run ";
constexpr std::string_view kVersion = "4\n";
constexpr std::size_t kHeadBytes = kMagic.size() + kVersion.size() + 8;  // plus the hash of the body

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(std::uint64_t{bytes.size()});
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    hash.add(word);
  }
  return hash.value();
}

void append(std::vector<std::byte>& out, std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<std::byte> encode(const SavedRun& run) {
  std::vector<std::byte> body;
  Packer out(body);
  out.u64(run.seed);
  out.text(run.engine);
  out.text(run.sources.path);
  out.varint(run.sources.search_path.size());
  for (const std::string& folder : run.sources.search_path) out.text(folder);
  out.varint(run.sources.files.size());
  for (const auto& [path, text] : run.sources.files) {
    out.text(path);
    out.text(text);
  }
  out.text(text_of(run.state));

  return with_head(body);
}

std::vector<std::byte> with_head(std::span<const std::byte> body) {
  std::vector<std::byte> bytes;
  append(bytes, kMagic);
  append(bytes, kVersion);
  Packer(bytes).u64(hash_of(body));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

Result<SavedRun> decode_saved_run(std::span<const std::byte> bytes) {
  const std::string_view text = text_of(bytes);
  if (!text.starts_with(kMagic)) return Error{{}, "is not a saved run"};
  const std::string_view rest = text.substr(kMagic.size());
  if (!rest.starts_with(kVersion)) {
    const std::string_view version = rest.substr(0, std::min(rest.find('\n'), std::size_t{8}));
    return Error{{},
                 "is a saved run of version " + in_quotes(version) + "; this program reads version " +
                     std::string(kVersion.substr(0, 1))};
  }
  if (bytes.size() < kHeadBytes) return Error{{}, "is cut: it ends in its head"};
  const std::uint64_t expected = Unpacker(bytes.subspan(kHeadBytes - 8)).u64();
  const std::span<const std::byte> body = bytes.subspan(kHeadBytes);
  if (hash_of(body) != expected)
    return Error{{}, "is cut or damaged: its bytes are not those that were written"};

  Unpacker in(body);
  SavedRun run;
  run.seed = in.u64();
  run.engine = in.text();
  run.sources.path = in.text();
  for (std::uint64_t n = in.varint(); n > 0 && in.ok(); --n) run.sources.search_path.push_back(in.text());
  for (std::uint64_t n = in.varint(); n > 0 && in.ok(); --n) {
    const std::string path = in.text();
    run.sources.files[path] = in.text();
  }
  const std::string state = in.text();
  const auto state_bytes = std::as_bytes(std::span(state));
  run.state.assign(state_bytes.begin(), state_bytes.end());
  if (!in.ok() || !in.at_end() || !run.sources.files.contains(run.sources.path))
    return Error{{}, "is damaged: its parts do not fit together"};
  return run;
}

}  // namespace playhouse::world
