#pragma once

/// The .cfg driver "cmdsplitter": tells several devices of an interface what it is told; the first of them answers and
/// has the data.

#include <cstddef>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/forwarder.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct CmdSplitterOptions {
  bool asks_first_only = false;
};

Result<CmdSplitterOptions> cmd_splitter_options(SectionFields fields);

class CmdSplitter final : public Forwarder {
 public:
  CmdSplitter(Shell& shell, const CmdSplitterOptions& options, std::size_t devices);

 private:
  device::Taken take(const device::Message& message) override;

  const std::size_t devices_;
};

extern const DriverDefinition kCmdSplitterDriver;

}  // namespace playhouse::drivers
