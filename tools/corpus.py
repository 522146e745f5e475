#!/usr/bin/env python3
"""The inputs that fuzzers start from, many in a file of text: tests/fuzz/NAME.txt is those of NAME_fuzz. Below the name of each
stand its bytes, a line of them a line, as Python writes them. To take one out, or to give it another name, edit the file.

corpus.py add NAME FILE...       takes files in, under their names; one of the same name is replaced
corpus.py unpack NAME FOLDER     writes the inputs to a folder, which has nothing else then
"""

import ast
import pathlib
import shutil
import sys

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests/fuzz"


def to_text(inputs):
    return "".join(f"{name}\n" + "".join(f"  {line!r}\n" for line in inputs[name].splitlines(keepends=True)) for name in sorted(inputs))


def from_text(text):
    inputs = {}
    for line in text.splitlines():
        if line.startswith(" "):
            inputs[name] += ast.literal_eval(line.strip())
        else:
            name = line
            inputs[name] = b""
    return inputs


def read(name):
    path = FOLDER / f"{name}.txt"
    return from_text(path.read_text()) if path.exists() else {}


def add(name, *files):
    inputs = read(name) | {pathlib.Path(file).name: pathlib.Path(file).read_bytes() for file in files}
    (FOLDER / f"{name}.txt").write_text(to_text(inputs))


def unpack(name, folder):
    if not (FOLDER / f"{name}.txt").exists() and not (FOLDER / name).exists():
        sys.exit(f"corpus.py: there are no inputs for {name}: tests/fuzz/{name}.txt is missing")
    shutil.rmtree(folder, ignore_errors=True)
    pathlib.Path(folder).mkdir(parents=True)
    for each, content in read(name).items():
        (pathlib.Path(folder) / each).write_bytes(content)


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["add", name, _, *_]:
            add(name, *sys.argv[3:])
        case ["unpack", name, folder]:
            unpack(name, folder)
        case _:
            sys.exit(__doc__)
