"""What can go wrong between a program and its server; all are PlayerError."""


class PlayerError(Exception):
    """Base of every error this package raises."""


class ConnectionLost(PlayerError):
    """The server could not be reached, is gone, or sent bytes that are not Player's."""


class RequestTimeout(PlayerError):
    """No answer, or no data, within the time allowed. The connection is still good."""


class RequestRefused(PlayerError):
    """The server answered NACK, or refused to open or close a device."""


class WireError(PlayerError):
    """Bytes that do not decode as the message they claim to be, or a value that does not fit the wire."""
