#pragma once

namespace playhouse::device_server {

/// Opens closed standard streams on /dev/null: otherwise the next file or
/// socket would get their descriptors, and output would go there. Call first.
void keep_standard_streams();

/// Flushes standard output and returns the exit code: `code`, or kFailed with
/// a message if output was lost. A closed pipe (`| head -1`) is not an error.
int finish_output(int code);

}  // namespace playhouse::device_server
