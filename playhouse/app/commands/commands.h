#pragma once

/// The commands of the program. Each returns the exit code.

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

int run(const RunOptions& options);
int replay(const ReplayOptions& options);
int export_tables(const ExportOptions& options);
int serve(const ServeOptions& options);
int gym(const GymOptions& options);
int verify(const VerifyOptions& options);
int node(const NodeOptions& options);
int robot(const RobotOptions& options);
int devices(const DevicesOptions& options);
int watch(const WatchOptions& options);
int observe(const ObserveOptions& options);
int drive(const DriveOptions& options);
int emulate(const EmulateOptions& options);
int check(const CheckOptions& options);
int convert(const ConvertOptions& options);
int picture(const PictureOptions& options);
int film(const FilmOptions& options);
int kinds(const KindsOptions& options);
int drivers(const DriversOptions& options);
int bench(const BenchOptions& options);

}  // namespace playhouse::app
