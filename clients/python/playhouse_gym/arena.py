"""A world in a separate process, stepped through a socket, with its arrays in shared memory."""

import array
import mmap
import numbers
import operator
import os
import pathlib
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import time
import weakref
from typing import Any, Dict, Optional, Union

import numpy as np

_HEAD = struct.Struct("<8sIIQ40s")
_ENTRY = struct.Struct("<32s8sIIQ8x")
_REQUEST = struct.Struct("<IIQ")
_ANSWER = struct.Struct("<II")
_MAGIC, _FORMAT = b"plhsgym\0", 1  # formats::kGym of playhouse/base/formats.h
_STEP, _START_AGAIN = 1, 2
_SEEDS = 1 << 64
MOST_TICKS = 1 << 20  # of a step
_ENDING, _ENDING_RECORD = 10.0, 600.0  # s; longer with a recording, which is completed first


class ArenaError(RuntimeError):
    """The program cannot be started, has ended, or refuses a request."""


def find_program() -> str:
    """PLAYHOUSE_PROGRAM, or `playhouse` in PATH, or the build of the checkout of this file."""
    named = os.environ.get("PLAYHOUSE_PROGRAM")
    built = pathlib.Path(__file__).resolve().parents[3] / "build" / "playhouse"
    found = named or shutil.which("playhouse") or (str(built) if built.exists() else None)
    if found is None:
        raise ArenaError("there is no program playhouse: set PLAYHOUSE_PROGRAM, or give its path")
    return found


def whole_number(what: str, value: int, most: int) -> int:
    """`value`, if it is a whole number from 1 to `most`; else a ValueError that begins with `what`."""
    if not isinstance(value, numbers.Integral) or not 1 <= value <= most:
        raise ValueError(f"{what}: a whole number from 1 to {most} is expected, not {value!r}")
    return int(value)


class Arena:
    """Columns of all agents, the top-level robots with a range finder, in the order of the world file:

    actions    float32 [agents, 3]      to be written: velocities along x, y (m/s) and about z (rad/s)
    reset_mask bool [agents]            to be written: the agent is moved to a free position before the next tick, at rest
    ranges     float32 [agents, beams]  m, of its first range finder
    pose       float64 [agents, 3]      x, y (m), heading (rad) in the world
    odometry   float64 [agents, 3]      the same, as estimated by the robot
    velocity   float64 [agents, 3]      m/s, m/s, rad/s
    stalled    bool [agents]            an obstacle blocked its last motion
    range_max  float32 [agents]         m, maximum range

    They are views of shared memory: the next step overwrites them. For one thread.
    """

    def __init__(
        self,
        world: Union[str, "os.PathLike[str]"],
        *,
        program: Optional[str] = None,
        engine: str = "stage",
        seed: Optional[int] = None,
        workers: int = 1,
        web: Optional[int] = None,
        record: Union[str, "os.PathLike[str]", None] = None,
        timeout: float = 120.0,
    ) -> None:
        """`engine`: simulation engine, "stage" or "arena". `seed`: seed of the world; None: 1. `web`: port of the
        page. `record`: an MCAP file that records all steps; it is complete after close(). `timeout` (s): limit on the
        time without an answer of the program."""
        command = [program or find_program(), "gym", os.fspath(world), "--engine", engine, "--workers", str(workers)]
        command += [] if seed is None else ["--seed", str(seed)]
        command += [] if web is None else ["--web", str(web)]
        command += [] if record is None else ["--record", os.fspath(record)]
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        self._said = tempfile.TemporaryFile()
        try:
            # In its own process group: Ctrl-C reaches this program only, whose end terminates the other.
            self._process = subprocess.Popen(
                [*command, "--socket", str(theirs.fileno())], pass_fds=(theirs.fileno(),), stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL, stderr=self._said, start_new_session=True)
        except OSError as error:
            ours.close()
            self._said.close()
            raise ArenaError(f"cannot start {command[0]}: {error}") from error
        finally:
            theirs.close()
        self._socket: Optional[socket.socket] = ours
        self._recorded = record
        self._web = web
        self._page: Optional[str] = None
        patience = _ENDING if record is None else _ENDING_RECORD
        self._finalizer = weakref.finalize(self, _end, ours, self._process, self._said, patience)
        ours.settimeout(timeout)
        try:
            self._columns = self._receive_columns()
        except BaseException:
            self._finalizer()
            raise
        for name in ("actions", "ranges", "pose", "odometry", "velocity", "range_max"):
            setattr(self, name, self._columns[name])
        self.reset_mask = self._columns["reset"].view(np.bool_)
        self.stalled = self._columns["stalled"].view(np.bool_)

    actions: np.ndarray
    ranges: np.ndarray
    pose: np.ndarray
    odometry: np.ndarray
    velocity: np.ndarray
    range_max: np.ndarray

    @property
    def agents(self) -> int:
        """Number of agents."""
        return int(self.ranges.shape[0])

    @property
    def beams(self) -> int:
        return int(self.ranges.shape[1])

    @property
    def tick(self) -> int:
        return int(self._columns["tick"][0])

    @property
    def time(self) -> float:
        """Simulated time since the start or the last start_again(). [s]"""
        return float(self._columns["time"][0])

    @property
    def interval(self) -> float:
        """Duration of a tick. [s]"""
        return float(self._columns["interval"][0])

    @property
    def page(self) -> Optional[str]:
        """The address of the page, if there is one."""
        if self._web is not None and self._page is None:
            self._page = self._wait_for_page()
        return self._page

    def _wait_for_page(self) -> Optional[str]:
        # The program prints the address asynchronously to its answers, possibly later.
        until = time.monotonic() + _ENDING
        while True:
            ended = self._process.poll() is not None
            told = next((line[10:] for line in self._log().splitlines() if line.startswith("web page: ")), None)
            if told is not None or ended or time.monotonic() > until:
                return told
            time.sleep(0.01)

    def step(self, ticks: int = 1) -> None:
        """Applies `actions` and `reset_mask`, which is all False afterwards, and runs this number of ticks, 1 to 2^20."""
        self._ask(_STEP, whole_number("ticks", ticks, MOST_TICKS), 0)

    def start_again(self, seed: int) -> None:
        """Restarts the run with this seed, every agent at a different position drawn from those of the world file;
        one tick with all at rest gives the first measurements."""
        self._ask(_START_AGAIN, 0, operator.index(seed) % _SEEDS)

    def close(self) -> None:
        """Terminates the program; the columns keep their values. A second call has no effect. Raises ArenaError if the
        recording is incomplete."""
        if self._socket is None:
            return
        self._socket = None
        said = self._finalizer() or ""
        if self._recorded is not None and self._process.returncode != 0:
            raise ArenaError(f"{os.fspath(self._recorded)} is not whole: {_how_it_ended(self._process.returncode, said)}")

    def __enter__(self) -> "Arena":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _ask(self, verb: int, ticks: int, seed: int) -> None:
        if self._socket is None:
            raise ArenaError("the arena is closed")
        try:
            self._socket.sendall(_REQUEST.pack(verb, ticks, seed))
        except OSError as error:
            raise self._lost() from error
        self._check(self._receive(_ANSWER.size))

    def _check(self, answer: bytes) -> None:
        failed, size = _ANSWER.unpack(answer)
        why = self._receive(size).decode("utf-8", "replace") if size else ""
        if failed:
            raise ArenaError(why)

    def _receive(self, size: int) -> bytes:
        assert self._socket is not None
        data = b""
        while len(data) < size:
            try:
                more = self._socket.recv(size - len(data))
            except socket.timeout:
                self._end_now()
                raise ArenaError("the program is silent") from None
            except OSError as error:
                raise self._lost() from error
            if not more:
                raise self._lost()
            data += more
        return data

    def _receive_columns(self) -> Dict[str, np.ndarray]:
        assert self._socket is not None
        try:
            data, descriptors = _receive_with_descriptor(self._socket, _ANSWER.size)
        except OSError as error:
            raise self._lost() from error
        if not data:
            raise self._lost()
        try:
            self._check(data + self._receive(_ANSWER.size - len(data)))
            if not descriptors:
                raise ArenaError("the program has sent no memory")
            return _columns_in(mmap.mmap(descriptors[0], 0))
        finally:
            for descriptor in descriptors:
                os.close(descriptor)

    def _log(self) -> str:
        if self._said.closed:
            return ""
        said = self._said.fileno()  # shares its file offset with the program's writes: it must not move
        return os.pread(said, os.fstat(said).st_size, 0).decode("utf-8", "replace")

    def _lost(self) -> ArenaError:
        code = self._process.wait()
        said = self._log()
        self._end_now()
        return ArenaError(_how_it_ended(code, said))

    def _end_now(self) -> None:
        self._socket = None
        self._finalizer()


def _how_it_ended(code: int, said: str) -> str:
    """With the last error in its output, if there is one."""
    how = f"with code {code}" if code >= 0 else f"by {_signal_name(-code)}"
    error = next((f": {line}" for line in reversed(said.splitlines()) if "error: " in line), "")
    return f"the program has ended {how}{error}"


def _signal_name(number: int) -> str:
    try:
        return f"signal {number} ({signal.Signals(number).name})"
    except ValueError:  # a real-time signal has no name
        return f"signal {number}"


def _receive_with_descriptor(source: socket.socket, size: int) -> Any:
    room = array.array("i", [0])
    data, control, _, _ = source.recvmsg(size, socket.CMSG_SPACE(room.itemsize))
    descriptors = array.array("i")
    for level, kind, body in control:
        if (level, kind) == (socket.SOL_SOCKET, socket.SCM_RIGHTS):
            descriptors.frombytes(body[: len(body) - len(body) % descriptors.itemsize])
    return data, list(descriptors)


def _columns_in(memory: mmap.mmap) -> Dict[str, np.ndarray]:
    magic, format_, count, size, build = _HEAD.unpack_from(memory, 0)
    if magic != _MAGIC or format_ != _FORMAT or size != len(memory):
        raise ArenaError(
            f"the program, {build.rstrip(bytes(1)).decode('utf-8', 'replace') or 'older than 0.2'}, shares memory of format {format_}; "
            f"this package reads format {_FORMAT}"
        )
    columns = {}
    for row in range(count):
        name, dtype, rows, width, offset = _ENTRY.unpack_from(memory, _HEAD.size + row * _ENTRY.size)
        shape = (rows, width) if width else (rows,)
        values = np.ndarray(shape, np.dtype(dtype.rstrip(b"\0").decode()), memory, offset)
        columns[name.rstrip(b"\0").decode()] = values
    return columns


def _end(link: socket.socket, process: "subprocess.Popen[bytes]", said: Any, patience: float) -> str:
    """The program ends by itself when the socket is closed. Returns its whole output."""
    link.close()
    try:
        process.wait(patience)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    said.seek(0)
    words: str = said.read().decode("utf-8", "replace")
    said.close()
    return words
