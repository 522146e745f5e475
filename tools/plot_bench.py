#!/usr/bin/env python3
"""Plots the cost per robot against the number of robots as an SVG, from the JSON lines of `playhouse bench`, and
prints the table of docs/benchmarks.md. Of several lines of one scenario and number of robots the lowest cost is used.

    for k in 1 2; do build/playhouse bench vaughan2008 --duration 10; build/playhouse bench diffusion --duration 10; done > lines.jsonl
    tools/plot_bench.py lines.jsonl docs/images/cost-of-a-robot.svg"""

import argparse
import json
import math
import pathlib
import sys
from typing import Any, Dict, List, Tuple

LEFT, RIGHT, TOP, BOTTOM = 70, 570, 40, 270
COLORS = ("#1f5fa8", "#b3452c", "#2f7d4f", "#7a4fa3", "#8a6d1f")
Lines = Dict[str, Dict[int, Dict[str, Any]]]    # by scenario and number of robots


def cheapest(texts: List[str]) -> Lines:
    lines: Lines = {}
    for text in texts:
        line = json.loads(text)
        of_scenario = lines.setdefault(line["scenario"], {})
        best = of_scenario.get(line["robots"])
        if best is not None and best["hash"] != line["hash"] and best["ticks"] == line["ticks"]:
            sys.exit(f"{line['scenario']} with {line['robots']} robots ended in two different states")
        if best is None or line["ns_per_robot_tick"] < best["ns_per_robot_tick"]:
            of_scenario[line["robots"]] = line
    return lines


def rounded(value: float) -> str:
    """To three digits, without an exponent."""
    return f"{float(f'{value:.3g}'):,.0f}" if value >= 100 else f"{value:.3g}"


def table(lines: Lines) -> str:
    rows = ["| scenario | robots | µs per robot and tick | real-time factor | rays/s | memory |", "|---|---|---|---|---|---|"]
    for scenario, populations in lines.items():
        for robots, line in sorted(populations.items()):
            per_second = line["rays"] / line["cpu_time"] / 1e6
            rows.append(f"| `{scenario}` | {robots:,} | {line['ns_per_robot_tick'] / 1000:.2f} | {rounded(line['sim_time'] / line['cpu_time'])} "
                        f"| {per_second:.1f} M | {line['memory_bytes'] / 1e6:.0f} MB |")
    return "\n".join(rows)


def drawn(lines: Lines) -> str:
    """Cost against population, both logarithmic; the vertical axis is two decades at least."""
    costs = [line["ns_per_robot_tick"] / 1000 for populations in lines.values() for line in populations.values()]
    most_robots = max(robots for populations in lines.values() for robots in populations)
    low = math.floor(math.log10(min(costs)))
    high = max(low + 2, math.ceil(math.log10(max(costs))))
    decades = max(1, math.ceil(math.log10(most_robots)))

    def place(robots: float, cost: float) -> Tuple[float, float]:
        return (LEFT + (RIGHT - LEFT) * math.log10(robots) / decades,
                BOTTOM - (BOTTOM - TOP) * (math.log10(cost) - low) / (high - low))

    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 320" font-family="sans-serif" font-size="12">',
           '<rect width="640" height="320" fill="white"/>']
    for decade in range(decades + 1):
        x, _ = place(10 ** decade, 10 ** low)
        out += [f'<path d="M{x:.0f} {TOP}V{BOTTOM}" stroke="#eee"/>',
                f'<text x="{x:.0f}" y="{BOTTOM + 18}" text-anchor="middle">{10 ** decade:,}</text>']
    for decade in range(low, high + 1):
        _, y = place(1, 10 ** decade)
        out += [f'<path d="M{LEFT} {y:.0f}H{RIGHT}" stroke="#eee"/>',
                f'<text x="{LEFT - 8}" y="{y + 4:.0f}" text-anchor="end">{10.0 ** decade:g}</text>']
    out += [f'<path d="M{LEFT} {TOP}V{BOTTOM}H{RIGHT}" fill="none" stroke="#888"/>',
            f'<text x="{LEFT}" y="24">processor time of a tick per robot, µs</text>',
            f'<text x="{(LEFT + RIGHT) / 2:.0f}" y="{BOTTOM + 36}" text-anchor="middle">robots, each with the same room</text>']
    for (scenario, populations), color in zip(lines.items(), COLORS):
        points = [place(robots, line["ns_per_robot_tick"] / 1000) for robots, line in sorted(populations.items())]
        out.append('<polyline points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in points) + f'" fill="none" stroke="{color}" stroke-width="2"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in points]
        out.append(f'<text x="{points[-1][0] + 8:.0f}" y="{points[-1][1] + 4:.0f}" fill="{color}">{scenario}</text>')
    return "\n".join(out + ["</svg>", ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lines", type=pathlib.Path, help="what playhouse bench printed")
    parser.add_argument("svg", type=pathlib.Path, help="where the picture goes")
    arguments = parser.parse_args()
    try:
        lines = cheapest(arguments.lines.read_text(encoding="utf-8").splitlines())
        if not lines:
            sys.exit(f"{arguments.lines}: has no line of playhouse bench")
        arguments.svg.write_text(drawn(lines), encoding="utf-8")
    except OSError as fault:
        sys.exit(f"{fault.filename}: {fault.strerror}")
    except (ValueError, KeyError, TypeError):
        sys.exit(f"{arguments.lines}: has lines that playhouse bench did not write")
    print(table(lines))


if __name__ == "__main__":
    main()
