"""One conversation with a server: whose an answer is, which data wait, and when a round of data is over."""

import time
from collections import deque
from typing import Callable, Deque, List, Optional, Tuple

from .connection import Connection, Message, checked_seconds
from .errors import ConnectionLost, RequestRefused, RequestTimeout, WireError
from .generated import INTERFACES, common, player
from .wire import Header, Kind, MessageType, Struct

# Data that come while a request waits for its answer, and wait for the next read(): as many as a server keeps for one
# client. Older ones give way and are counted.
WAITING_LIMIT = 1024

_Key = Tuple[int, int, int]
_DATA_KEY: _Key = (player.CODE, 0, player.REQ_DATA.subtype)
_OPENING_KEY: _Key = (player.CODE, 0, player.REQ_DEV.subtype)

# The access in an answer to an opening that nobody asked for: the device has retired. (Openings that fail say ERROR_MODE.)
_ERROR_LETTER = ord("e")


def device_name(interface: int, index: int) -> str:
    """As in "position2d:0"; a number where the interface has no known name."""
    return f"{INTERFACES.get(interface, interface)}:{index}"


class Session:
    """Sorts what arrives: answers to the request that waits, data to the queue, everything else aside."""

    def __init__(
        self, connection: Connection, timeout: float, retire: Callable[[common.Devaddr], None] = lambda _: None
    ) -> None:
        """`retire` is called with the address of a device when the server says that it has retired."""
        self.connection = connection
        self.timeout = checked_seconds(timeout)
        self.waiting: Deque[Message] = deque()
        self.round_open = False
        self.round_refused = False
        self._round_waits = False  # it ended while a request waited: its data wait
        self.told = False  # that a device has retired
        self._retire = retire
        self.overflow_count = 0
        self.unread_count = 0  # of these, those that were lost here
        self.skipped_count = 0
        self._server_port = 0
        self._abandoned: List[_Key] = []
        self._sequence = 0

    def timeout_or_own(self, timeout: Optional[float]) -> float:
        """The time-out (s) that a caller gave, or this session's own."""
        return self.timeout if timeout is None else checked_seconds(timeout)

    @property
    def peer(self) -> str:
        """HOST:PORT of the server."""
        return self.connection.peer

    @property
    def server_port(self) -> int:
        """The server's port as it says itself in its answers; that connected to may be another's that forwards."""
        return self._server_port or self.connection.port

    def send(
        self, interface: int, index: int, message: MessageType, payload: Optional[Struct], sequence: int = 0
    ) -> None:
        body = payload.encode() if payload is not None else b""
        # As libplayerc does it: the port in what is meant for a device, nothing in what is for the server.
        robot = 0 if interface == player.CODE else self.connection.port
        header = Header(
            interface, index, message.kind, message.subtype, time.time(), sequence, len(body), 0, robot
        )
        self.connection.send(header, body)

    def request(
        self, interface: int, index: int, message: MessageType, payload: Optional[Struct] = None,
        timeout: Optional[float] = None,
    ) -> Message:
        """Sends and waits for the ACK. Raises RequestRefused on NACK, RequestTimeout on silence."""
        seconds = self.timeout_or_own(timeout)
        self.send(interface, index, message, payload, self._sequence)
        key = (interface, index, message.subtype)
        whose = f"{message.name} of {device_name(interface, index)}"
        try:
            answer = self._answer(key, time.monotonic() + seconds)
        except RequestTimeout:
            raise RequestTimeout(f"{self.peer}: no answer to {whose} in {seconds:g} s") from None
        self._server_port = answer.header.robot
        if answer.header.kind == Kind.NACK:
            raise RequestRefused(f"{self.peer}: {whose} was refused", answer.body)
        return answer

    def begin_round(self) -> None:
        """Asks for data, unless a round is open or has ended with all its data waiting; it ends with the SYNCH that
        closes `round_open`, or is refused."""
        here, self._round_waits = self._round_waits and bool(self.waiting), False
        if self.round_open or here:
            return
        self.round_open, self.round_refused = True, False
        try:
            self.send(player.CODE, 0, player.REQ_DATA, None, self._sequence)
        except ConnectionLost:
            pass  # what came before the end is still to be received, and then the same error

    def sort_next(self, deadline: float) -> None:
        """Receives one message that nobody asked for and puts it where it belongs."""
        message = self.connection.receive(deadline)
        if not self._take_notice(message):
            self._sort(message)

    def drop_waiting(self, interface: int, index: int) -> None:
        """Forgets the data of a device that is gone: they must not become those of the next one at its address."""
        kept = [each for each in self.waiting if (each.header.interface, each.header.index) != (interface, index)]
        self.skipped_count += len(self.waiting) - len(kept)
        self.waiting = deque(kept)

    def _answer(self, key: _Key, deadline: float) -> Message:
        settled = False
        try:
            while True:
                message = self.connection.receive(deadline)
                if self._take_notice(message):
                    continue
                if not self._answers(message.header, key):
                    self._sort(message)
                elif self._is_ours(message.header.sequence, key):
                    return message
                else:
                    self.skipped_count += 1
                    if key in self._abandoned:
                        self._abandoned.remove(key)
                        settled = True
        except BaseException:  # a time-out, or Ctrl-C
            # From now on requests are numbered, so that a late answer to this one is not taken for another's. If the
            # answer to an abandoned request of this kind came meanwhile, as many answers are missing as before.
            self._sequence += 1
            if not settled:
                self._abandoned.append(key)
            raise

    def _is_ours(self, sequence: int, key: _Key) -> bool:
        """Number 0 is what an old request had, and what servers send that do not return numbers."""
        return sequence == self._sequence if sequence else key not in self._abandoned

    @staticmethod
    def _answers(header: Header, key: _Key) -> bool:
        answers = header.kind in (Kind.ACK, Kind.NACK)
        return answers and (header.interface, header.index, header.subtype) == key

    def _take_notice(self, message: Message) -> bool:
        """False for anything but the notice that a device has retired."""
        if message.header.kind != Kind.ACK or not self._answers(message.header, _OPENING_KEY):
            return False
        try:
            notice = player.DeviceReq.decode(message.body)
        except WireError:
            return False
        if notice.access != _ERROR_LETTER:
            return False
        self.told = True
        self._retire(notice.addr)
        return True

    def _sort(self, message: Message) -> None:
        if message.header.kind == Kind.DATA:
            if len(self.waiting) == WAITING_LIMIT:
                self.waiting.popleft()
                self.overflow_count += 1
                self.unread_count += 1
            self.waiting.append(message)
        elif message.header.kind == Kind.SYNCH:
            self._end_round(message)
        elif self._answers(message.header, _DATA_KEY):
            if message.header.kind == Kind.NACK:
                self.round_open, self.round_refused = False, True
        else:
            self.skipped_count += 1

    def _end_round(self, message: Message) -> None:
        self.round_open = False
        self._round_waits = bool(self.waiting)
        if message.header.subtype != player.SYNCH_OVERFLOW.subtype:
            return
        try:
            lost = player.SYNCH_OVERFLOW.payload.decode(message.body).value
        except WireError:
            lost = 0
        self.overflow_count += max(lost, 1)
