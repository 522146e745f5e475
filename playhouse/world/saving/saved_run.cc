#include "playhouse/world/saving/saved_run.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/formats.h"
#include "playhouse/base/hash.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/version.h"

namespace playhouse::world {
namespace {

constexpr std::string_view kMagic = "playhouse saved run ";
constexpr std::size_t kLongestLine = 100;  // of the head, so that no error shows a whole file

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

/// Takes a line from the front of `text`, without its end; none: it is not there, or too long.
std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.substr(0, kLongestLine).find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
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
  append(bytes, std::to_string(formats::kSavedRun) + "\n");
  append(bytes, build());
  append(bytes, "\n");
  Packer(bytes).u64(hash_of(body));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

Result<SavedRun> decode_saved_run(std::span<const std::byte> bytes) {
  std::string_view rest = text_of(bytes);
  if (!rest.starts_with(kMagic)) return Error{{}, "is not a saved run"};
  rest.remove_prefix(kMagic.size());
  const std::optional<std::string_view> format = take_line(rest);
  if (format && *format != std::to_string(formats::kSavedRun))
    return Error{{},
                 "is a saved run of format " + in_quotes(*format) + "; this program reads format " +
                     std::to_string(formats::kSavedRun)};
  const std::optional<std::string_view> writer = format ? take_line(rest) : std::nullopt;
  if (!writer || rest.size() < sizeof(std::uint64_t)) return Error{{}, "is cut: it ends in its head"};
  Unpacker head(bytes.last(rest.size()));
  const std::uint64_t expected = head.u64();
  const std::span<const std::byte> body = bytes.last(head.left());
  if (hash_of(body) != expected)
    return Error{{}, "is cut or damaged: its bytes are not those that were written"};

  Unpacker in(body);
  SavedRun run;
  run.build = *writer;
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
