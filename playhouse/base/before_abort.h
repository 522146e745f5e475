#pragma once

namespace playhouse {

/// Hook that runs before a failed assertion is reported, on the failing thread; if it returns
/// false, nothing is reported. Default: none. The log uses it to flush pending lines.
void set_before_abort(bool (*task)());

}  // namespace playhouse
