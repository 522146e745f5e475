#pragma once

namespace playhouse {

/// `task` runs before a failed assertion is told, on the thread that found it; false from it: say nothing and
/// end. None at first. The log sees to it that what was said before is written.
void set_before_abort(bool (*task)());

}  // namespace playhouse
