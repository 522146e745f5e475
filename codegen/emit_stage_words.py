"""docs/stage-words.md: every word of Stage 4 world files, and its support here."""

from __future__ import annotations

from codegen.emit_kinds_docs import _banner, _table
from codegen.kinds import Kind, Kinds

PAGE = "docs/stage-words.md"
VERDICTS = {"same": "same", "better": "better", "other": "other", "none": "only here", "later": "not yet"}


def emit(kinds: Kinds) -> dict[str, str]:
    lines = [_banner("kinds/"), "# Words of Stage, one by one", "",
             "Effect of each word of a Stage 4 world file compared with Stage: the **same**; **better**, where Stage has a fault or does not implement its manual;",
             "**other**: different; **nothing**: no effect, with the reason; **not yet**: not implemented. Words that Stage does not have are **only here**. Differences in behaviour are listed in",
             "[stage-compatibility.md](stage-compatibility.md), meanings of words in [kinds/](kinds/README.md), words of older versions in [worldfile.md](worldfile.md).", ""]
    for kind in kinds.all:
        rows = _rows(kind)
        if rows:
            lines += [f"## {kind.name}", "", *_table(["word", "here", "why"], rows)]
    return {PAGE: "\n".join(lines).rstrip() + "\n"}


def _rows(kind: Kind) -> list[list[str]]:
    rows = []
    for word in kind.words:
        later = word.use == "later" or not kind.simulated
        rows.append([f"`{word.name}{'[i]' if word.indexed else ''}`", VERDICTS["later" if later else word.stage], word.stage_why])
    told = {name: kind.silent_why.get(name, kind.silent_why.get("", "")) for name in kind.silent}
    for why in dict.fromkeys(told.values()):  # one row per reason
        names = ", ".join(f"`{name}`" for name in kind.silent if told[name] == why)
        rows.append([names, "nothing", why])
    return rows
