#include "playhouse/app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "playhouse/app/commands/command_table.h"
#include "playhouse/app/commands/options.h"
#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/version.h"

namespace playhouse::app {
namespace {

constexpr const char* kExamples = R"(Examples:
  playhouse run worlds/cave.world                    robots, Player clients on 6665, a page on 8080
  playhouse run my.world --port 7000 --web off       Player clients alone
  playhouse run my.world --fast --headless --duration 60 --json
                                                     a minute of simulated time, as fast as possible
  playhouse run my.world --engine arena              the same world with rigid-body physics
  playhouse run my.world --save-at 60 minute.run     save the state after a minute
  playhouse run --from minute.run                    resume it
  playhouse run my.world --save-at 60 later.world    save the world after a minute as a world file
  playhouse run my.world --record my.mcap            record it, for Foxglove, ROS and the next three
  playhouse run --again my.mcap                      repeat it bit-identically
  playhouse replay my.mcap                           replay it in the page, with its time on a slider
  playhouse export my.mcap --csv                     export it as tables
  playhouse verify my.world --ticks 100              compare runs with different numbers of workers
  playhouse serve simple.cfg                         serve the devices of a Player configuration file
  playhouse node lab                                 share the work of a run --cluster on another machine
  playhouse robot my.toml --server lab               spawn a robot in the world of another machine
  playhouse devices 127.0.0.1:6665                   list the devices of a server
  playhouse watch 127.0.0.1 laser:0                  print a device's data as JSON lines
  playhouse observe 127.0.0.1                        print poses as JSON lines, by UDP (run --observers)
  playhouse drive 127.0.0.1 guest                    drive a robot by the keyboard
  playhouse check my.world                           report errors in a file
  playhouse convert old.world -o new.world           convert a world of an older version of Stage
  playhouse convert plan.png --scale 0.05 -o w.world convert a floor plan or a ROS map.yaml to a world
  playhouse picture my.world --at 10 -o a.png        render it from above after ten seconds
  playhouse kinds ranger                             list the words of a ranger
  playhouse drivers vfh                              list the options of a driver
  playhouse bench laser --robots 1000                print one line of figures
`playhouse COMMAND --help` lists all options. Documentation: docs/cli.md)";

int print(const HelpText& answer) {
  fmt::print("{}", answer.text);
  return kDone;
}

std::vector<std::string_view> command_names(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool looks_like_flag(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && !(word[1] >= '0' && word[1] <= '9') && word[1] != '.';
}

/// CLI11 reports unknown words without suggestions, so they are checked first.
Result<void> check_words(const CLI::App& app, std::span<const char* const> words) {
  const CLI::App* scope = &app;
  std::size_t next = 0;
  if (!words.empty() && !looks_like_flag(words[0])) {
    const std::vector<std::string_view> commands = command_names(app);
    const std::string_view command = words[0];
    if (std::ranges::find(commands, command) == commands.end()) {
      return Error{"", fmt::format("unknown command {}{}; see playhouse --help", in_quotes(command),
                                   did_you_mean(command, commands))};
    }
    scope = app.get_subcommand(words[0]);
    next = 1;
  }
  const std::vector<std::string> names = flag_names(*scope);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  for (const std::string_view word : words.subspan(next)) {
    if (word == "--") break;  // end of options
    if (!looks_like_flag(word)) continue;
    const std::string_view flag = word.substr(0, word.find('='));
    if (std::ranges::find(candidates, flag) != candidates.end()) continue;
    const bool is_letter = flag.size() == 2;  // -p: no suggestions, every letter is similar
    return Error{"", fmt::format("unknown option {}{}", flag,
                                 is_letter ? "; playhouse COMMAND --help lists them"
                                           : did_you_mean(flag, candidates))};
  }
  return {};
}

/// An empty value, as of an unset variable of a script, would count as an option that is not given.
Result<void> check_values(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->parse_order()) {
      if (option->get_expected_min() == 0) continue;  // --lock-step alone: CLI11 adds an empty value
      if (std::ranges::find(option->results(), "") != option->results().end())
        return Error{"", option->get_name() + " needs a value, found \"\""};
    }
  }
  return {};
}

}  // namespace

Result<CommandLine> parse_command_line(std::span<const char* const> words) {
  CLI::App app("A robot device server and simulator: Player clients and Stage worlds.", "playhouse");
  app.set_version_flag("-V,--version",
                       fmt::format("playhouse {} (commit {}, Player protocol 3.1)", version(), commit()));
  app.footer(kExamples);
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, std::function<CommandLine()>>> added;
  for (const Command& command : commands()) {
    CLI::App* const sub = app.add_subcommand(command.name, command.summary);
    sub->footer(command.examples);
    added.emplace_back(sub, command.add(*sub));
  }

  if (words.empty()) return CommandLine(HelpText{app.help()}, print);
  if (const Result<void> known = check_words(app, words); !known) return known.error();
  try {
    // CLI11 expects reversed arguments.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return CommandLine(HelpText{commands.empty() ? app.help() : commands.front()->help(app.get_name())},
                       print);
  } catch (const CLI::CallForVersion& version) {
    return CommandLine(HelpText{std::string(version.what()) + "\n"}, print);
  } catch (const CLI::ArgumentMismatch& error) {
    // E.g. "--port: 1 required UINT missing", "--port: At Most 1 required but received 2"
    const std::string_view text = error.what();
    const bool twice = text.find("At Most") != std::string_view::npos;
    return Error{"", fmt::format("{} {}", text.substr(0, text.find(':')),
                                 twice ? "is given more than once" : "needs a value")};
  } catch (const CLI::ParseError& error) {
    return Error{"", error.what()};
  }
  if (const Result<void> valued = check_values(app); !valued) return valued.error();
  for (const auto& [command, asked_for] : added)
    if (command->parsed()) return asked_for();
  PLAYHOUSE_ASSERT(false);  // a command is required
}

}  // namespace playhouse::app
