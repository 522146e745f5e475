"""Links of documents to files that are not there."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

LINK = re.compile(r"\]\(([^)#\s:]+)(?:#[^)\s]*)?\)")  # not to other machines, nor within a document


def dead(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for name in LINK.findall(line):
            if not (path.parent / name).exists():
                yield f"{path.relative_to(ROOT)}:{number}: there is no {name}"
