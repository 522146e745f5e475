#include <string>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/record/csv.h"

namespace playhouse::app {

int export_tables(const ExportOptions& options) {
  const Result<std::unique_ptr<record::Source>> source = record::open_source(options.file);
  if (!source) return fail_in_file(source.error());
  std::string folder = options.folder;
  constexpr std::string_view kEnding = ".mcap";
  if (folder.empty())
    folder = options.file.ends_with(kEnding) ? options.file.substr(0, options.file.size() - kEnding.size())
                                             : options.file + ".tables";
  const Result<record::CsvTables> written = record::write_csv(**source, folder);
  if (!written)
    return written.error().where.empty() ? fail_in_file({escaped(options.file), written.error().text})
                                         : fail_at(written.error());
  for (const std::string& why : written->left_out) warn(escaped(options.file) + ": " + why);
  if (written->cut)
    warn(escaped(options.file) + ": was not finished; what follows its last whole chunk is lost");
  log::info("{} tables with {} rows in {}", written->tables, written->rows, escaped(folder));
  return kDone;
}

}  // namespace playhouse::app
