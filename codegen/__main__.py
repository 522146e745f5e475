"""python3 -m codegen            writes all files generated from interfaces/, kinds/ and viewer/, and worlds/looks/
python3 -m codegen --check    writes nothing; fails if one is missing, edited or left over
python3 -m codegen --list     prints their paths
python3 -m codegen --catalogue laser,power FILE
                              writes the table of messages of a program that knows these interfaces alone (PLAYHOUSE_INTERFACES)

Every build writes them (cmake/Codegen.cmake, web/package.json), since git has none (docs/adr/0026).
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

from codegen import (emit_c, emit_changes, emit_commands, emit_cpp, emit_cpp_fields, emit_docs, emit_engine_words, emit_java,
                     emit_kind_lists, emit_kinds_cpp, emit_kinds_docs, emit_lisp, emit_looks, emit_playerc, emit_python, emit_stage_words,
                     emit_tables, emit_tcl, emit_typescript, emit_views, emit_wire_fields)
from codegen.checks import SchemaError
from codegen.commands import load_commands
from codegen.kinds import load_kinds
from codegen.model import load
from codegen.proxies import build_proxies, c, cpp, java, lisp, python, tcl, typescript

ROOT = Path(__file__).resolve().parent.parent
EMITTERS = [emit_c, emit_cpp, emit_cpp_fields, emit_docs, emit_java, emit_lisp, emit_playerc, emit_python, emit_tcl, emit_typescript,
            emit_wire_fields]  # of interfaces/
PROXY_EMITTERS = [c, cpp, java, lisp, python, tcl, typescript]
KIND_EMITTERS = [emit_changes, emit_engine_words, emit_kind_lists, emit_kinds_cpp, emit_kinds_docs, emit_stage_words, emit_tables, emit_views]
# Folders owned by the emitters: other files there are left over, also of emitters that are no more.
OWNED = ["playhouse/*/generated", emit_c.FOLDER, emit_c.SOURCES, emit_docs.FOLDER, emit_java.FOLDER, emit_kinds_docs.FOLDER, emit_lisp.FOLDER, c.FOLDER,
         emit_looks.FOLDER, cpp.FOLDER, emit_playerc.FOLDER, emit_python.FOLDER, emit_tcl.FOLDER, emit_typescript.FOLDER, emit_views.WEB_FOLDER]


def wanted() -> dict[str, str]:
    schema = load(ROOT / "interfaces")
    files: dict[str, str] = {}
    for emitter in EMITTERS:
        files |= emitter.emit(schema)
    proxies = build_proxies(schema)
    for emitter in PROXY_EMITTERS:
        files |= emitter.emit(proxies)
    kinds = load_kinds(ROOT / "kinds", schema)
    for emitter in KIND_EMITTERS:
        files |= emitter.emit(kinds)
    return files | emit_commands.emit(load_commands(ROOT / "viewer" / "commands.toml")) | emit_looks.emit()


def left_over(files: dict[str, str]) -> list[str]:
    found = [p.relative_to(ROOT).as_posix() for pattern in OWNED for folder in ROOT.glob(pattern)
             for p in folder.rglob("*") if p.is_file()]
    return sorted(p for p in found if p not in files and not p.startswith(".") and "/." not in p
                  and "__pycache__" not in p)


def stale(files: dict[str, str]) -> list[str]:
    out = []
    for path, content in files.items():
        target = ROOT / path
        if not target.exists():
            out.append(f"{path}: is missing")
        elif target.read_text(encoding="utf-8") != content:
            out.append(f"{path}: is not what the definitions say")
    return out + [f"{path}: is left over" for path in left_over(files)]


def replace(target: Path, content: str) -> None:
    """In one step: other builds of this tree may write it, too, or read it."""
    target.parent.mkdir(parents=True, exist_ok=True)
    new = target.with_name(f".{target.name}.{os.getpid()}")
    new.write_text(content, encoding="utf-8")
    os.replace(new, target)


def write(files: dict[str, str]) -> int:
    """How many files changed; the others keep their time, so that nothing is built anew for them."""
    changed = 0
    for path, content in files.items():
        target = ROOT / path
        if target.exists() and target.read_text(encoding="utf-8") == content:
            continue
        replace(target, content)
        changed += 1
    for path in left_over(files):
        (ROOT / path).unlink(missing_ok=True)
        changed += 1
    return changed


def write_catalogue(names: list[str], target: Path) -> int:
    schema = load(ROOT / "interfaces")
    known = [interface.name for interface in schema.interfaces]
    for name in names:
        if name not in known:
            print(f"invalid PLAYHOUSE_INTERFACES: there is no interface {name}; there are {', '.join(known)}", file=sys.stderr)
            return 1
    content = emit_cpp.catalogue(schema.restricted({"player", *names}))
    if not target.exists() or target.read_text(encoding="utf-8") != content:
        replace(target, content)
    return 0


def main(arguments: list[str]) -> int:
    if len(arguments) == 3 and arguments[0] == "--catalogue":
        return write_catalogue(arguments[1].split(","), Path(arguments[2]))
    if arguments not in ([], ["--check"], ["--list"]):
        print(__doc__, end="", file=sys.stderr)
        return 2
    try:
        files = wanted()
    except SchemaError as error:
        print(error, file=sys.stderr)
        return 1
    if arguments == ["--list"]:
        print("\n".join(sorted(files)))
        return 0
    if not arguments:
        print(f"codegen: {len(files)} files, {write(files)} changed")
        return 0
    problems = stale(files)
    for problem in problems:
        print(problem, file=sys.stderr)
    if problems:
        print("generated files are out of date: run python3 -m codegen", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
