#include <cstdio>
#include <string>

#include "playhouse/app/commands/commands.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/record/change_list.h"
#include "playhouse/record/csv.h"

namespace playhouse::app {

namespace {

void warn_if_cut(bool is_cut, const std::string& file) {
  if (is_cut) warn(escaped(file) + ": was not finished; what follows its last whole chunk is lost");
}

int print_changes(const record::ByteSource& source, const std::string& file) {
  const Result<record::ChangeCount> listed = record::list_changes(
      source, [](std::string_view line) { std::fwrite(line.data(), 1, line.size(), stdout); });
  if (!listed) return fail_in_file({escaped(file), listed.error().text});
  warn_if_cut(listed->cut, file);
  return kDone;
}

}  // namespace

int export_tables(const ExportOptions& options) {
  if (!options.csv && !options.changes) return fail({"export", "needs --csv or --changes"}, kUsage);
  const Result<std::unique_ptr<record::ByteSource>> source = record::open_source(options.file);
  if (!source) return fail_in_file(source.error());
  if (options.changes) return print_changes(**source, options.file);
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
  warn_if_cut(written->cut, options.file);
  log::info("{} tables with {} rows in {}", written->tables, written->rows, escaped(folder));
  return kDone;
}

}  // namespace playhouse::app
