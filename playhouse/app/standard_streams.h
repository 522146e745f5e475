#pragma once

namespace playhouse::app {

/// Opens what is closed of standard input, output and error on nothing: the next file or socket would get its
/// number, and what is printed would go there. Call first.
void keep_standard_streams();

/// Writes the rest of standard output and returns the exit code: `code`, or kFailed and a line if the output
/// was lost. A reader that left (`| head -1`) has seen what it wanted.
int finish_output(int code);

}  // namespace playhouse::app
