// Any bytes as a recording whose tables are written: files appear in the folder alone, whatever its topics
// are called, and nothing else is written.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

#include "playhouse/base/assert.h"
#include "playhouse/record/csv.h"
#include "playhouse/record/testing/memory_source.h"

namespace {

namespace files = std::filesystem;

/// A folder until the program exits.
struct OuterFolder {
  OuterFolder() { PLAYHOUSE_ASSERT(mkdtemp(name.data()) != nullptr); }
  ~OuterFolder() {
    std::error_code ignored;
    files::remove_all(name, ignored);
  }
  OuterFolder(const OuterFolder&) = delete;
  OuterFolder& operator=(const OuterFolder&) = delete;

  std::string name = files::temp_directory_path() / "playhouse_export_fuzz_XXXXXX";
};

/// A folder in a folder, so that what escapes from the inner one is seen.
const std::string& outer_folder() {
  static const OuterFolder folder;
  return folder.name;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace playhouse;
  const std::string inner = outer_folder() + "/tables";
  const record::MemorySource source(std::as_bytes(std::span(data, size)));
  const Result<record::CsvTables> written = record::write_csv(source, inner);
  PLAYHOUSE_ASSERT(written.ok() || !written.error().text.empty());
  std::size_t tables = 0;
  for (const auto& entry : files::recursive_directory_iterator(outer_folder())) {
    PLAYHOUSE_ASSERT(entry.path() == inner || entry.path().string().starts_with(inner + "/"));
    tables += entry.is_regular_file() ? 1 : 0;
  }
  PLAYHOUSE_ASSERT(!written || tables == written->tables);
  files::remove_all(outer_folder());
  files::create_directory(outer_folder());
  return 0;
}
