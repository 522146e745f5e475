#!/usr/bin/env python3
"""Generates docs/drivers/, a page for each driver of configuration files and their list, from `playhouse drivers --json`. With
--check it writes nothing, and exits with 1 if a page is out of date.

    tools/driver_pages.py            # needs build/playhouse, or the program in PLAYHOUSE_PROGRAM"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
from typing import Any, Dict, Iterable, List, Optional

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.environ.get("PLAYHOUSE_PROGRAM", str(ROOT / "build" / "playhouse"))
FOLDER = ROOT / "docs" / "drivers"
NOTE = "<!-- Made by tools/driver_pages.py of what `playhouse drivers --json` prints. Do not edit. -->\n"
EVERY = "Every section has `name` and `provides`, and may have `requires` and `alwayson` ([configuration.md](../configuration.md))."
OF_EMULATORS = "A section has `name` and `requires` ([configuration.md](../configuration.md)), and `playhouse emulate` writes it ([hardware.md](../hardware.md))."
INTERFACES = {path.stem.split("_", 1)[1]: path.stem for path in (ROOT / "interfaces").glob("[0-9]*_*.toml")}
# Headings that say what the drivers do.
HEADINGS = set(re.findall(r'^## driver "(\w+)"$', (ROOT / "docs" / "drivers.md").read_text(), re.MULTILINE))
HARDWARE = set(re.findall(r"^## (\w+)$", (ROOT / "docs" / "hardware.md").read_text(), re.MULTILINE))

Entry = Dict[str, Any]


def cell(text: Optional[str]) -> str:
    return (text or "").replace("|", "\\|")


def code(text: Optional[str]) -> str:
    return f"`{cell(text)}`" if text else ""


def table(head: List[str], rows: Iterable[List[str]]) -> List[str]:
    lines = ["| " + " | ".join(each) + " |" for each in rows]
    return ["| " + " | ".join(head) + " |", "|---" * len(head) + "|", *lines, ""]


def interface(device: Entry) -> str:
    name = device["interface"]
    return "any" if name is None else f"[{name}](../interfaces/{INTERFACES[name]}.md)"


def devices_of(driver: Entry, what: str) -> List[List[str]]:
    return [[what, interface(device), code(device["key"]), device["many"], cell(device["doc"])] for device in driver[what]]


def default_of(option: Entry) -> str:
    return code(option["default"]) or cell(option["default_told"])


def option_row(option: Entry) -> List[str]:
    kind = cell(option["type"]) or "no effect"
    return [code(option["name"]), kind, cell(option["unit"]), default_of(option), cell(option["limits"]), cell(option["doc"])]


def page_of(driver: Entry) -> str:
    name = driver["name"]
    lines = [NOTE + f"# {name}", "", driver["doc"], ""]
    if driver["other_name"]:
        lines += [f"`{driver['other_name']}` is the same driver.", ""]
    if name in HEADINGS:
        lines += [f"[drivers.md](../drivers.md#driver-{name}) says what it does.", ""]
    if name.removesuffix("_emulator") in HARDWARE:
        lines += [f"[hardware.md](../hardware.md#{name.removesuffix('_emulator')}) says what it does, and what it was tested against.", ""]
    devices = devices_of(driver, "provides") + devices_of(driver, "requires")
    lines += ["## Devices", "", *table(["", "interface", "key", "how many", ""], devices)]
    lines += ["## Options", "", EVERY if driver["provides"] else OF_EMULATORS, ""]
    if driver["options"]:
        lines += table(["option", "value", "unit", "default", "limits", "meaning"], map(option_row, driver["options"]))
    if driver["properties"]:
        rows = [[code(each["name"]), each["type"], cell(each["doc"])] for each in driver["properties"]]
        lines += ["## Properties of its devices", "", *table(["property", "type", "meaning"], rows)]
    return "\n".join(lines).rstrip("\n") + "\n"


def in_short(devices: List[Entry]) -> str:
    return ", ".join(dict.fromkeys(code(device["interface"]) or "any" for device in devices))


def index_of(drivers: List[Entry]) -> str:
    rows = [[f"[{driver['name']}]({driver['name']}.md)", cell(driver["doc"]), in_short(driver["provides"]),
             in_short(driver["requires"])] for driver in drivers]
    return "\n".join([
        NOTE + "# Drivers of configuration files", "",
        "Each page lists the devices that a driver provides and requires, and its options with units, defaults and limits;",
        "`playhouse drivers NAME` prints the same. [drivers.md](../drivers.md) says what they do, and",
        "[configuration.md](../configuration.md) what a section is. Units are the defaults; `unit_length` and `unit_angle` of a file",
        "change those of lengths and angles.", "",
        *table(["driver", "description", "provides", "requires"], rows)]).rstrip("\n") + "\n"


def pages() -> Dict[str, str]:
    printed = subprocess.run([PROGRAM, "drivers", "--json"], capture_output=True, text=True, check=True).stdout
    drivers = [json.loads(line) for line in printed.splitlines()]
    made = {f"{driver['name']}.md": page_of(driver) for driver in drivers}
    return {**made, "README.md": index_of(drivers)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if a page is out of date")
    check = parser.parse_args().check
    wanted = pages()
    there = {path.name: path.read_text() for path in FOLDER.glob("*.md")}
    stale = sorted(name for name in {*wanted, *there} if wanted.get(name) != there.get(name))
    if check:
        for name in stale:
            print(f"docs/drivers/{name} is out of date: tools/driver_pages.py makes it", file=sys.stderr)
        return 1 if stale else 0
    FOLDER.mkdir(exist_ok=True)
    for name in stale:
        (FOLDER / name).write_text(wanted[name]) if name in wanted else (FOLDER / name).unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
