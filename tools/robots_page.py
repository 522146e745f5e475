#!/usr/bin/env python3
"""Generates docs/robots.md and its pictures from worlds/*.inc, as parsed by the program. With --check it writes nothing, and
exits with 1 if a file is out of date.

    tools/robots_page.py            # needs build/playhouse, or the program in PLAYHOUSE_PROGRAM"""

import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from typing import Any, Dict, Iterator, List, Tuple

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.environ.get("PLAYHOUSE_PROGRAM", str(ROOT / "build" / "playhouse"))
KINDS = ("position", "ranger", "fiducial", "model")
# Controller of each in its example, one that suits its sensors (docs/controllers.md).
CONTROLLERS = {"pioneer2dx": "expand_pioneer", "swarmbot": "expand_swarm", "footbot": "diffusion"}

Point = Tuple[float, float]
Pose = Tuple[float, float, float]  # x, y [m], heading [rad]


class Section:
    """A section of a world file in the output of `playhouse convert`: type, words and nested sections."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.words: Dict[str, Any] = {}
        self.parts: List[Section] = []

    def numbers(self, word: str, default: List[float]) -> List[float]:
        return self.words.get(word, default)


def tokens_of(text: str) -> Iterator[str]:
    return (match[0] for match in re.finditer(r'"[^"]*"|\[[^\]]*\]|[()]|[^\s()\[\]"]+(?:\[\d+\])?', text))


def value_of(token: str) -> Any:
    if token[0] == "[":
        return [float(word) if re.match(r"[-\d.]", word) else word.strip('"') for word in token[1:-1].split()]
    return token.strip('"') if token[0] == '"' else float(token)


def filled(section: Section, tokens: Iterator[str]) -> Section:
    """Reads to the end of the section."""
    for token in tokens:
        if token == ")":
            break
        following = next(tokens)
        if following == "(":
            section.parts.append(filled(Section(token), tokens))
        else:
            section.words[token] = value_of(following)
    return section


def read_world(text: str) -> Section:
    """The only robot of a world, with the words of its macro."""
    tokens = tokens_of(text)
    macros: Dict[str, Section] = {}
    for token in tokens:
        if token == "define":
            name, base = next(tokens), next(tokens)
            next(tokens)
            macros[name] = filled(Section(base), tokens)
        elif next(tokens) == "(":
            found = filled(Section(token), tokens)
            if token not in macros:
                return found
            robot = macros[token]
            robot.words.update(found.words)
            return robot
    raise ValueError("no robot in what the program wrote")


def converted(name: str, folder: str) -> Section:
    world = pathlib.Path(folder) / "one.world"
    includes = "".join(f'include "{file.name}"\n' for file in sorted((ROOT / "worlds").glob("*.inc")))
    world.write_text(f'{includes}{name}( name "it" )\n')
    done = subprocess.run([PROGRAM, "convert", world], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return read_world(done.stdout)


# --- what the files say


def described(file: pathlib.Path) -> str:
    """The comment at the head of the file, up to its first empty line."""
    lines = []
    for line in file.read_text().splitlines():
        if line.strip("# ") == "" or not line.startswith("#"):
            break
        lines.append(line[2:])
    return " ".join(lines)


def defines(file: pathlib.Path) -> Dict[str, Tuple[str, str]]:
    """The macros of a file: base type, and the comment before the macro or after its use in the head."""
    text = file.read_text()
    found = {}
    for match in re.finditer(r"((?:^#.*\n)*)^define (\w+) (\w+)", text, re.MULTILINE):
        comment = " ".join(line.lstrip("# ") for line in match[1].splitlines())
        use = re.search(rf"^#   {match[2]}\(.*?\)\s{{2,}}(.*)$", text, re.MULTILINE)
        found[match[2]] = (match[3], use[1] if use else comment)
    return found


def named(about: str) -> str:
    return re.sub(r"<name>(\S*)", r"`NAME\1`", about)


def story(file: pathlib.Path, name: str, about: str) -> List[str]:
    """What a robot is: the head of its file and what is said of the macro, or the latter alone if it is a sentence."""
    if re.match(r"An? .*\.$", about):
        return [named(about)]
    return [described(file), *([f"`{name}`: {named(about)}."] if about else [])]


def kind_of(name: str, macros: Dict[str, Tuple[str, str]]) -> str:
    while name in macros:
        name = macros[name][0]
    return name


# --- what a robot is


def sensor_defaults() -> Dict[str, List[float]]:
    done = subprocess.run([PROGRAM, "kinds", "sensor", "--json"], capture_output=True, text=True, check=True)
    words = {word["name"]: word["default"] for word in json.loads(done.stdout)["words"] if word["default"] is not None}
    return {name: value_of(words[name]) for name in ("range", "fov", "samples", "pose")}


def number(value: float) -> str:
    return f"{value:.4g}"


def sensors_told(robot: Section, defaults: Dict[str, Any]) -> List[str]:
    told = []
    for ranger in (part for part in robot.parts if part.kind == "ranger"):
        alike: Dict[str, int] = {}
        for sensor in (part for part in ranger.parts if part.kind == "sensor"):
            near, far = sensor.words.get("range", defaults["range"])
            beams, fov = int(sensor.words.get("samples", defaults["samples"])), sensor.words.get("fov", defaults["fov"])
            many = f"{beams} beams over {number(fov)} degrees" if beams > 1 else "one beam"
            line = f"{many}, {number(near)} to {number(far)} m"
            alike[line] = alike.get(line, 0) + 1
        told += [f"{count} sensors of {line}" if count > 1 else f"a sensor of {line}" for line, count in alike.items()]
    return told


def rows_of(robot: Section, defaults: Dict[str, Any]) -> List[Tuple[str, str]]:
    length, width, height = robot.words["size"]
    rows = [("size", f"{number(length)} m × {number(width)} m × {number(height)} m")]
    if "mass" in robot.words:
        rows.append(("mass", f"{number(robot.words['mass'])} kg"))
    bounds = robot.words.get("velocity_bounds")
    if bounds:
        rows.append(("speed", f"up to {number(bounds[1])} m/s and {number(bounds[7])} degrees/s"))
    rows.append(("drive", robot.words.get("drive", "diff")))
    rows.append(("sensors", "; ".join(sensors_told(robot, defaults)) or "none"))
    return rows


# --- the picture


def moved(pose: Pose, point: Point) -> Point:
    x, y, heading = pose
    return (x + math.cos(heading) * point[0] - math.sin(heading) * point[1], y + math.sin(heading) * point[0] + math.cos(heading) * point[1])


def placed(section: Section, pose: Pose) -> Pose:
    x, y, _, degrees = section.numbers("pose", [0, 0, 0, 0])
    return (*moved(pose, (x, y)), pose[2] + math.radians(degrees))


def outlines(section: Section) -> List[List[Point]]:
    """Of its own body, in its frame: blocks stretched together over its size, or the box itself."""
    length, width = section.numbers("size", [0, 0, 0])[:2]
    at_x, at_y, _, degrees = section.numbers("origin", [0, 0, 0, 0])
    body = (at_x, at_y, math.radians(degrees))
    blocks = [[value for word, value in part.words.items() if word.startswith("point[")] for part in section.parts if part.kind == "block"]
    if not blocks:
        blocks = [[[0, 0], [1, 0], [1, 1], [0, 1]]] if length * width > 0 else []
    points = [point for block in blocks for point in block]
    if not points or length * width == 0:
        return []
    (low_x, high_x), (low_y, high_y) = ((min(p[k] for p in points), max(p[k] for p in points)) for k in (0, 1))
    return [[moved(body, ((x - low_x) / (high_x - low_x) * length - length / 2, (y - low_y) / (high_y - low_y) * width - width / 2))
             for x, y in block] for block in blocks]


class Picture:
    """A robot from above, x to the right, two and a half times as wide as it is; the reach of its sensors is cut off there."""

    def __init__(self, robot: Section) -> None:
        self.half = 1.25 * max(robot.words["size"][:2])
        self.shapes: List[str] = []
        self.beams: List[str] = []

    def polygon(self, points: List[Point], paint: str) -> str:
        scale = 120 / self.half
        return '<polygon points="' + " ".join(f"{120 + x * scale:.1f},{120 - y * scale:.1f}" for x, y in points) + f'" {paint}/>'

    def add(self, section: Section, pose: Pose, color: str, defaults: Dict[str, Any]) -> None:
        color = section.words.get("color", color)
        for outline in outlines(section):
            self.shapes.append(self.polygon([moved(pose, p) for p in outline], f'fill="{color.lower()}" stroke="#333"'))
        for part in section.parts:
            if part.kind == "sensor":
                self.add_beams(part, pose, defaults)
            elif part.kind != "block":
                self.add(part, placed(part, pose), color, defaults)

    def add_beams(self, sensor: Section, pose: Pose, defaults: Dict[str, Any]) -> None:
        """The cone of a sensor, from where it begins to measure."""
        x, y, _, degrees = sensor.words.get("pose", defaults["pose"])
        near, far = sensor.words.get("range", defaults["range"])
        at = (*moved(pose, (x, y)), pose[2] + math.radians(degrees))
        half = math.radians(sensor.words.get("fov", defaults["fov"])) / 2
        far = min(far, 3 * self.half)
        bearings = [half * (k / 12 - 1) for k in range(25)]
        rim = [moved(at, (far * math.cos(b), far * math.sin(b))) for b in bearings]
        start = [moved(at, (near * math.cos(b), near * math.sin(b))) for b in reversed(bearings)] if near > 0 else [at[:2]]
        self.beams.append(self.polygon(rim + start, 'fill="#3a7bd5" fill-opacity="0.12" stroke="#3a7bd5" stroke-opacity="0.35"'))

    def svg(self, robot: Section) -> str:
        length = robot.words["size"][0]
        bar = 240 / (2 * self.half) * length
        return "\n".join([
            '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 240 270" width="240" height="270" font-family="sans-serif" font-size="12">',
            '<rect width="240" height="270" fill="white"/>', '<svg width="240" height="240">', *self.beams, *self.shapes, "</svg>",
            f'<path d="M{120 - bar / 2:.1f} 248h{bar:.1f}m0 -3v6m{-bar:.1f} 0v-6" stroke="#333" fill="none"/>',
            f'<text x="120" y="264" text-anchor="middle" fill="#333">{number(length)} m</text>', "</svg>", ""])


def picture_of(robot: Section, defaults: Dict[str, Any]) -> str:
    picture = Picture(robot)
    picture.add(robot, (0, 0, 0), "gray", defaults)
    return picture.svg(robot)


# --- the page


def example_of(name: str, file: str) -> List[str]:
    controller = f' ctrl "{CONTROLLERS[name]}"' if name in CONTROLLERS else ""
    return ["```", f'include "{file}"', 'include "map.inc"', "interval_sim 100", "window( center [0 0] scale 60 )",
            'model( name "walls" size [8 8 0.6] boundary 1 noblocks 1 )', "crate( pose [2 1 0 30] )", 'beacon( name "home" pose [-2 -2 0 0] )',
            f'{name}( name "r0" pose [0 0 0 0]{controller} )', f'{name}( name "r1" pose [-1 1 0 90]{controller} )',
            f'{name}( name "r2" pose [1 -1 0 180]{controller} )', "```"]


def written() -> Dict[pathlib.Path, str]:
    """All generated files, by path."""
    defaults = sensor_defaults()
    files: Dict[pathlib.Path, str] = {}
    robots, others = [], []
    with tempfile.TemporaryDirectory() as folder:
        by_file = {file: defines(file) for file in sorted((ROOT / "worlds").glob("*.inc"))}
        macros = {name: macro for found in by_file.values() for name, macro in found.items()}
        for file, found in by_file.items():
            for name, (_, about) in found.items():
                kind = kind_of(name, macros)
                if kind not in KINDS:
                    continue
                if kind != "position":
                    others.append(f"| `{name}` | {kind} | [{file.name}](../worlds/{file.name}) | {named(about)} |")
                    continue
                robot = converted(name, folder)
                if "size" not in robot.words:  # what robots have in common
                    continue
                files[ROOT / "docs" / "images" / "robots" / f"{name}.svg"] = picture_of(robot, defaults)
                robots += ["", f"## {name}", "", f"![{name} from above](images/robots/{name}.svg)", "",
                           *story(file, name, about), "", "| | |", "|---|---|",
                           *[f"| {what} | {told} |" for what, told in rows_of(robot, defaults)],
                           f"| file | [{file.name}](../worlds/{file.name}) |", "", *example_of(name, file.name)]
    page = ["# Robots", "", "<!-- Generated by tools/robots_page.py from worlds/*.inc: edit those. -->", "",
            "Ready-made robots for any world: `include` finds their files from any folder ([worldfile.md](worldfile.md#text)). Pictures show them from",
            "above, facing right; blue areas are the coverage of sensors, clipped at the edge. Each example is a complete world: save it, and run it with `playhouse run`.",
            *robots, "", "## Sensors and environment", "", "| macro | kind | file | description |", "|---|---|---|---|", *others, ""]
    files[ROOT / "docs" / "robots.md"] = "\n".join(page)
    return files


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only report which files differ")
    check = parser.parse_args().check
    differ = []
    for path, text in written().items():
        if check:
            if not path.is_file() or path.read_text(encoding="utf-8") != text:
                differ.append(str(path.relative_to(ROOT)))
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    if differ:
        sys.exit("not as tools/robots_page.py writes them: " + ", ".join(differ))


if __name__ == "__main__":
    main()
