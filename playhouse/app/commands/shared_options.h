#pragma once

/// Options that several commands have, each defined once.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "playhouse/app/commands/option_texts.h"
#include "playhouse/app/commands/options.h"

namespace playhouse::app {

/// An option with one text, which `parse` converts to `value`.
template <typename Read, typename Value>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, Result<Read> (*parse)(const std::string&),
                        Value& value, const std::string& help) {
  const auto read = [name, parse, &value](const std::string& text) {
    Result<Read> parsed = parse(text);
    if (!parsed) throw CLI::ValidationError(name, parsed.error().text);
    value = std::move(*parsed);
  };
  return app.add_option_function<std::string>(name, read, help);
}

void add_engine(CLI::App& app, std::string& engine);
void add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help = "seed of all random numbers");
void add_workers(CLI::App& app, unsigned& workers, const std::string& help = "worker threads");
/// For commands with a result, which does not depend on the number of threads.
inline constexpr const char* kWorkersOfARun = "worker threads; the result does not depend on it";
void add_allowed_libraries(CLI::App& app, Running& running);
void add_bind(CLI::App& app, std::string& address);
/// `otherwise`: what keeps others from that, for the help.
void add_insecure(CLI::App& app, bool& insecure, const std::string& otherwise = {});
/// For programs without access control: throws unless nobody else reaches the address, or that is meant.
void check_bind_insecure(const std::string& bind, bool insecure);
/// For callbacks of commands: throws if others could come in without a token and nobody has said that they may.
void check_access(const Serving& serving);
/// --token of a Player client.
void add_auth_key(CLI::App& app, std::string& token);
/// Listening address, access control and limits of viewers and observers.
void add_hosts(CLI::App& app, Serving& serving);
/// Ports and access of a served world.
void add_serving(CLI::App& app, Serving& serving);
void add_recording(CLI::App& app, Running& running);
/// Options of a run.
void add_running(CLI::App& app, Running& running);

}  // namespace playhouse::app
