#pragma once

/// The options of each command: every function adds those of its command to `app`, and
/// keeps what was parsed in `options`, which must outlive the parsing.
/// Commands that run a world are in options_of_runs.cc, the others in options_of_tools.cc.

#include <CLI/CLI.hpp>

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

void add_run(CLI::App& app, RunOptions& options);
void add_replay(CLI::App& app, ReplayOptions& options);
void add_export(CLI::App& app, ExportOptions& options);
void add_serve(CLI::App& app, ServeOptions& options);
void add_node(CLI::App& app, NodeOptions& options);
void add_robot(CLI::App& app, RobotOptions& options);
void add_gym(CLI::App& app, GymOptions& options);
void add_verify(CLI::App& app, VerifyOptions& options);
void add_devices(CLI::App& app, DevicesOptions& options);
void add_watch(CLI::App& app, WatchOptions& options);
void add_observe(CLI::App& app, ObserveOptions& options);
void add_drive(CLI::App& app, DriveOptions& options);
void add_emulate(CLI::App& app, EmulateOptions& options);
void add_check(CLI::App& app, CheckOptions& options);
void add_convert(CLI::App& app, ConvertOptions& options);
void add_picture(CLI::App& app, PictureOptions& options);
void add_film(CLI::App& app, FilmOptions& options);
void add_kinds(CLI::App& app, KindsOptions& options);
void add_drivers(CLI::App& app, DriversOptions& options);
void add_bench(CLI::App& app, BenchOptions& options);

}  // namespace playhouse::app
