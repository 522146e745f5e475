#!/usr/bin/env python3
"""qemu_ppc.py PROGRAM [ARGUMENT...]: runs a static program for 32-bit PowerPC by qemu-ppc.

glibc's sin(), cos(), tan() and atan2() keep the rounding mode by `mffscrn` and `mffscrni`, of Power ISA 3.0. Older processors
ignore the bits that tell these from `mffs`, and glibc relies on it; qemu 7.2, of Debian 12, raises an illegal instruction
instead. A copy of the program has `mffs` in their place, so that it does what it does on a machine of its kind.
Source: Power ISA 3.0B, 4.6.9; QEMU 8.1, "target/ppc: Fix fallback to MFFS* instructions on pre 3.0 ISAs"."""

import os
import pathlib
import struct
import sys
import tempfile

MFFS = 0xFC00048E  # opcode 63, extended opcode 583, field 11-15 is 0
NAME = 0xFC1F07FF  # the bits that name an instruction of this form
MFFSCRN, MFFSCRNI = MFFS | 22 << 16, MFFS | 23 << 16
TARGET_REGISTER = 0x1F << 21  # where the status goes
LOAD, EXECUTABLE = 1, 1


def text_segments(program):
    """Offset and length in the file, of what is executed."""
    if program[:6] != b"\x7fELF\x01\x02":
        sys.exit(f"qemu_ppc.py: {sys.argv[1]}: not a 32-bit big-endian ELF file")
    offset, = struct.unpack_from(">I", program, 28)
    size, count = struct.unpack_from(">HH", program, 42)
    for header in range(offset, offset + size * count, size):
        kind, start, _, _, length, _, flags, _ = struct.unpack_from(">8I", program, header)
        if kind == LOAD and flags & EXECUTABLE:
            yield start, length


def as_on_older_processors(program):
    patched = bytearray(program)
    for start, length in text_segments(program):
        for at in range(start, start + length - 3, 4):
            word, = struct.unpack_from(">I", program, at)
            if word & NAME in (MFFSCRN, MFFSCRNI):
                struct.pack_into(">I", patched, at, MFFS | word & TARGET_REGISTER)
    return bytes(patched)


def copy_for_qemu(path):
    """Beside the program; made again when the program is newer."""
    copy = path.with_name(path.name + ".qemu")
    if not copy.exists() or copy.stat().st_mtime <= path.stat().st_mtime:
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
            file.write(as_on_older_processors(path.read_bytes()))
        os.chmod(file.name, 0o755)
        os.replace(file.name, copy)
    return copy


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: qemu_ppc.py PROGRAM [ARGUMENT...]")
    program = pathlib.Path(sys.argv[1])
    os.execvp("qemu-ppc", ["qemu-ppc", "-0", str(program), str(copy_for_qemu(program)), *sys.argv[2:]])


if __name__ == "__main__":
    main()
