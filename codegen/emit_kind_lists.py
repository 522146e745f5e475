"""Lists of what is written per kind elsewhere, so that a kind adds a file and changes none: playhouse/stage/generated/."""

from __future__ import annotations

from codegen.emit_kinds_cpp import BANNER
from codegen.kinds import Kind, Kinds

FOLDER = "playhouse/stage/generated"


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/senses.h": _senses(kinds)}


def measuring(kinds: Kinds) -> list[Kind]:
    """Those that measure, when they are due."""
    return [k for k in kinds.simulated() if any(c.name == "measured_tick" for c in k.state.columns)]


def _senses(kinds: Kinds) -> str:
    found = measuring(kinds)
    lines = [BANNER.rstrip(), "#pragma once", "", "/// The sense phase of each kind that measures; playhouse/stage/sense_NAME.cc defines it.", "",
             "#include <memory>", "", '#include "playhouse/stage/sense_phase.h"', "", "namespace playhouse::stage {", "",
             "/// `workers` is how many threads may measure at once."]
    lines += [f"std::unique_ptr<SensePhase> make_{k.name}_sense(unsigned workers);" for k in found]
    lines += ["", "inline void add_senses(Senses& senses, unsigned workers) {"]
    lines += [f"  senses.add(make_{k.name}_sense(workers));" for k in found]
    return "\n".join([*lines, "}", "", "}  // namespace playhouse::stage", ""])
