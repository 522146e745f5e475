"""Bases of proxies: what an interface does besides its values and messages."""

import collections
from typing import Deque, Generic, Iterator, List, Optional, TypeVar

from .device import Device
from .generated import imu
from .wire import MessageType, Struct

Kept = TypeVar("Kept")


class Keeping(Device, Generic[Kept]):
    """Base of devices whose data messages are queued until the program takes them."""

    WAITING = 1024  # queue limit; the oldest are dropped

    def prepare(self) -> None:
        self._kept: Deque[Kept] = collections.deque(maxlen=self.WAITING)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Kept]:
        """Reads for ever: each message. Raises RequestTimeout."""
        while True:
            while self._kept:
                yield self._kept.popleft()
            self.next_data(timeout)

    def take(self, message: MessageType, value: Struct, timestamp: float) -> None:
        self._kept.append(self._meaning(value))
        super().take(message, value, timestamp)

    def forget_data(self) -> None:
        self._kept.clear()
        super().forget_data()

    def _meaning(self, value: Struct) -> Kept:
        raise NotImplementedError

    def _take_kept(self) -> List[Kept]:
        taken = list(self._kept)
        self._kept.clear()
        return taken


class Mobile(Device):
    """Base of devices that move. Closing one while it moves stops it first."""

    _moving = False

    def drive(self, vx: float) -> None:
        raise NotImplementedError

    def stop(self) -> None:
        self.drive(0.0)

    def why_refused(self) -> str:
        """Requests why the driver (nd, vfh) does not drive to the goal of the last go_to(), as its log says; empty if it does,
        has arrived, or is a driver that gives no reasons."""
        return self._why_refused()

    def close(self) -> None:
        if self._open and self._moving and not self.gone and self._session.connection.alive:
            self.stop()
        super().close()


class Selecting(Device):
    """Base of devices that send one of several data messages."""

    def send(self, datatype: MessageType) -> None:
        """One of imu.DATA_STATE (`pose`), DATA_CALIB (`inertia`), DATA_QUAT (`inertia` and `quaternion`), DATA_EULER
        (`inertia` and `attitude`) and DATA_FULLSTATE (`pose` and `velocity`), for all subscribers of the device."""
        self.request(imu.REQ_SET_DATATYPE, imu.DatatypeConfig(datatype.subtype))

    def _lack_of(self, message: MessageType) -> str:
        why = super()._lack_of(message)
        constant = message.name.replace("imu.", "", 1).replace(".", "_").upper()
        return f"{why}; send(imu.{constant}) selects it" if self.has_data else why
