"""One conversation with a server: whose an answer is, which data wait, and when a round of data is over."""

import time
from collections import deque
from typing import Deque, List, Optional, Tuple

from .connection import Connection, Message
from .errors import RequestRefused, RequestTimeout, WireError
from .generated import player
from .wire import Header, Kind, MessageType, Struct

# Data that wait for the next read(); as many as libplayerc's ring holds. Older ones give way and are counted.
WAITING_LIMIT = 512

_Key = Tuple[int, int, int]


class Session:
    """Sorts what arrives: answers to the request that waits, data to the queue, everything else aside."""

    def __init__(self, connection: Connection, timeout: float) -> None:
        self.connection = connection
        self.timeout = timeout
        self.waiting: Deque[Message] = deque()
        self.round_open = False
        self.overflow_count = 0
        self.skipped_count = 0
        self._abandoned: List[_Key] = []
        self._sequence = 0

    def deadline(self, timeout: Optional[float]) -> float:
        return time.monotonic() + (self.timeout if timeout is None else timeout)

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
        self.send(interface, index, message, payload, self._sequence)
        key = (interface, index, message.subtype)
        try:
            answer = self._answer(key, self.deadline(timeout))
        except RequestTimeout:
            raise RequestTimeout(f"{self.connection.peer}: no answer to {message.name}") from None
        if answer.header.kind == Kind.NACK:
            raise RequestRefused(f"{self.connection.peer}: {message.name} of index {index} was refused")
        return answer

    def sort_next(self, deadline: Optional[float]) -> None:
        """Receives one message that nobody asked for and puts it where it belongs."""
        self._sort(self.connection.receive(deadline))

    def _answer(self, key: _Key, deadline: float) -> Message:
        settled = False
        while True:
            try:
                message = self.connection.receive(deadline)
            except RequestTimeout:
                # From now on requests are numbered, so that the answer to this one, should it still come, is
                # not taken for another's. If an abandoned one got its answer meanwhile, the books are even.
                self._sequence += 1
                if not settled:
                    self._abandoned.append(key)
                raise
            if not self._answers(message.header, key):
                self._sort(message)
            elif self._is_ours(message.header.sequence, key):
                return message
            else:
                self.skipped_count += 1
                if key in self._abandoned:
                    self._abandoned.remove(key)
                    settled = True

    def _is_ours(self, sequence: int, key: _Key) -> bool:
        """Number 0 is what an old request had, and what servers send that do not return numbers."""
        return sequence == self._sequence if sequence else key not in self._abandoned

    @staticmethod
    def _answers(header: Header, key: _Key) -> bool:
        answers = header.kind in (Kind.ACK, Kind.NACK)
        return answers and (header.interface, header.index, header.subtype) == key

    def _sort(self, message: Message) -> None:
        if message.header.kind == Kind.DATA:
            if len(self.waiting) == WAITING_LIMIT:
                self.waiting.popleft()
                self.overflow_count += 1
            self.waiting.append(message)
        elif message.header.kind == Kind.SYNCH:
            self._end_round(message)
        else:
            self.skipped_count += 1

    def _end_round(self, message: Message) -> None:
        self.round_open = False
        if message.header.subtype != player.SYNCH_OVERFLOW.subtype:
            return
        try:
            lost = player.SYNCH_OVERFLOW.payload.decode(message.body).value
        except WireError:
            lost = 0
        self.overflow_count += max(lost, 1)
