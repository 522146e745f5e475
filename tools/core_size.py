#!/usr/bin/env python3
"""core_size.py [BUILD]: what the device server alone takes, as it was built in BUILD (build/core): bytes of the program, of its
parts by the symbols of an unstripped twin, and resident memory with one robot of made-up data and ten clients that read it.
One JSON line."""

import json
import pathlib
import re
import socket
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = {  # the first that a symbol's name has
    "codecs": r"playhouse::wire\b",
    "drivers": r"playhouse::drivers\b",
    "core": r"playhouse::",
}
ROBOT = 'driver( name "dummy" provides ["position2d:0" "laser:0" "power:0"] rate 10 )\n'
CLIENTS = 10


def part_of(name):
    return next((part for part, pattern in PARTS.items() if re.search(pattern, name)), "libraries")


def parts(build):
    """Of an unstripped twin. Constants without a name of their own count as libraries."""
    commands = subprocess.run(["ninja", "-C", build, "-t", "commands", "bin/player"], capture_output=True, text=True, check=True).stdout
    link = commands.splitlines()[-1].removeprefix(": && ").removesuffix(" && :")
    with tempfile.TemporaryDirectory() as folder:
        twin = f"{folder}/player"
        link = link.replace(" -s ", " ").replace("-o bin/player", f"-o {twin}")
        subprocess.run(link, shell=True, cwd=build, check=True, capture_output=True)
        symbols = subprocess.run(["nm", "-S", "-C", twin], capture_output=True, text=True, check=True).stdout
    sizes, seen = dict.fromkeys([*PARTS, "libraries"], 0), set()
    for line in symbols.splitlines():
        words = line.split(None, 3)
        if len(words) < 4 or words[2] in "bB" or words[0] in seen:
            continue
        seen.add(words[0])
        sizes[part_of(words[3])] += int(words[1], 16)
    return sizes


def open_all(port):
    """A client that reads every device of the robot."""
    client = socket.create_connection(("127.0.0.1", port))
    client.recv(32, socket.MSG_WAITALL)
    for interf in (2, 4, 6):
        body = struct.pack(">IIIIIII", 0, 0, interf, 0, 1, 0, 0)
        client.sendall(struct.pack(">IIIIIIdII", 0, 0, 1, 0, 3, 3, 0.0, 0, len(body)) + body)
    return client


def resident(program):
    """kB, once each client has had 20 kB of data."""
    with tempfile.NamedTemporaryFile("w", suffix=".cfg") as file:
        file.write(ROBOT)
        file.flush()
        with subprocess.Popen([program, "-p", "0", file.name], stdout=subprocess.PIPE, text=True) as player:
            port = int(player.stdout.readline().split()[3])
            clients = [open_all(port) for _ in range(CLIENTS)]
            for client in clients:
                client.recv(20_000, socket.MSG_WAITALL)
            status = pathlib.Path(f"/proc/{player.pid}/status").read_text()
            player.terminate()
    return int(re.search(r"VmRSS:\s+(\d+)", status)[1])


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/core").resolve()
    program = folder / "bin/player"
    print(json.dumps({"bench": "core_size", "bytes": program.stat().st_size, "resident_kb": resident(program), **parts(folder)}))
