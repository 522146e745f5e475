"""One session with a server: matches answers to requests, queues data, and tracks rounds of data."""

import time
from collections import deque
from typing import Callable, Deque, List, Optional, Tuple

from .connection import Connection, Message, checked_seconds
from .errors import ConnectionLost, RequestRefused, RequestTimeout, WireError
from .generated import INTERFACES, common, player
from .wire import Header, Kind, MessageType, Struct

# Limit on data queued for the next read() while a request waits for its answer: the queue length of a server per
# client. The oldest are dropped and counted.
WAITING_LIMIT = 1024

_Key = Tuple[int, int, int]
_DATA_KEY: _Key = (player.CODE, 0, player.REQ_DATA.subtype)
_OPENING_KEY: _Key = (player.CODE, 0, player.REQ_DEV.subtype)

# Access in an unrequested answer to an open request: the device was retired. (Failed open requests have ERROR_MODE.)
_ERROR_LETTER = ord("e")


def device_name(interface: int, index: int) -> str:
    """For instance "position2d:0"; with a number if the interface has no known name."""
    return f"{INTERFACES.get(interface, interface)}:{index}"


class Session:
    """Dispatches received messages: answers to the pending request, data to the queue; others are skipped."""

    def __init__(
        self, connection: Connection, timeout: float, retire: Callable[[common.Devaddr], None] = lambda _: None
    ) -> None:
        """`retire` is called with the address of a device that the server has retired."""
        self.connection = connection
        self.timeout = checked_seconds(timeout)
        self.waiting: Deque[Message] = deque()
        self.round_open = False
        self.round_refused = False
        self._round_waits = False  # it ended during a request: its data are queued
        self.told = False  # a device was retired
        self._retire = retire
        self.overflow_count = 0
        self.unread_count = 0  # those of them lost here
        self.skipped_count = 0
        self._server_port = 0
        self._abandoned: List[_Key] = []
        self._sequence = 0

    def timeout_or_own(self, timeout: Optional[float]) -> float:
        """The timeout (s) of the caller, or the session's own."""
        return self.timeout if timeout is None else checked_seconds(timeout)

    @property
    def peer(self) -> str:
        """HOST:PORT of the server."""
        return self.connection.peer

    @property
    def server_port(self) -> int:
        """The server's port as reported in its answers; the connected port may be that of a forwarder."""
        return self._server_port or self.connection.port

    def send(
        self, interface: int, index: int, message: MessageType, payload: Optional[Struct], sequence: int = 0
    ) -> None:
        body = payload.encode() if payload is not None else b""
        # As in libplayerc: the port in messages to a device, 0 in messages to the server.
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
        """Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH that
        clears `round_open`, or is refused."""
        here, self._round_waits = self._round_waits and bool(self.waiting), False
        may_be_lost = self.connection.datagrams  # by UDP: what a read left open is asked for again
        if (self.round_open and not may_be_lost) or here:
            return
        self.round_open, self.round_refused = True, False
        try:
            self.send(player.CODE, 0, player.REQ_DATA, None, self._sequence)
        except ConnectionLost:
            pass  # data before the disconnection are still to be received, then the same error

    def sort_next(self, deadline: float) -> None:
        """Receives one message outside a request and dispatches it."""
        message = self.connection.receive(deadline)
        if not self._take_notice(message):
            self._sort(message)

    def sort_arrived(self) -> None:
        """Queues the data of the group that have come, without waiting."""
        for message in self.connection.arrived():
            self._sort(message)

    def drop_waiting(self, interface: int, index: int) -> None:
        """Drops queued data of a retired device, so that they are not delivered to a new device at its address."""
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
        except BaseException:  # timeout or Ctrl-C
            # From now on requests are numbered, so that a late answer to this one is not matched to another. If the
            # answer to an abandoned request of this type arrived meanwhile, the number of missing answers is unchanged.
            self._sequence += 1
            if not settled:
                self._abandoned.append(key)
            raise

    def _is_ours(self, sequence: int, key: _Key) -> bool:
        """0 is the number of requests before the first timeout, and of servers that do not return numbers."""
        return sequence == self._sequence if sequence else key not in self._abandoned

    @staticmethod
    def _answers(header: Header, key: _Key) -> bool:
        answers = header.kind in (Kind.ACK, Kind.NACK)
        return answers and (header.interface, header.index, header.subtype) == key

    def _take_notice(self, message: Message) -> bool:
        """Processes the notice that a device was retired; False for any other message."""
        if message.header.kind != Kind.ACK or not self._answers(message.header, _OPENING_KEY):
            return False
        try:
            notice = player.DeviceReq.decode(message.body)
        except WireError:
            return False
        if notice.access != _ERROR_LETTER:
            return False
        self.told = True
        self.sort_arrived()  # its last data
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
