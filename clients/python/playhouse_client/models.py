"""The simulator's list of models and their devices: lines of text in a property of the simulation interface."""

import re
from typing import Dict, List, NamedTuple, Optional, cast

from .device import Device
from .errors import WireError
from .generated import simulation
from .wire import c_string, text

_ESCAPES = {"\\\\": "\\", "\\t": "\t", "\\n": "\n"}


class DeviceAddress(NamedTuple):
    """Address of a device: port of its server, interface and index, with the full name of its model."""

    port: int
    interface: str
    index: int
    model: str

    @property
    def name(self) -> str:
        """INTERFACE:INDEX, for instance "position2d:12"."""
        return f"{self.interface}:{self.index}"


class Model(NamedTuple):
    """One model of the world: full name, type ("position", independent of macros), name of its parent (empty for a
    top-level model), own devices, and id, which is unique in the run."""

    name: str
    type: str
    parent: str
    devices: List[DeviceAddress]
    id: int


def ask_models(simulator: Device) -> List[Model]:
    """All models of a simulation device's world. Raises RequestRefused if the simulator does not report them."""
    found: List[Model] = []
    index = 0
    while True:
        question = simulation.PropertyReq(c_string(""), c_string("models"), index)
        answer = cast(simulation.PropertyReq, simulator.request(simulation.REQ_GET_PROPERTY, question) or question)
        found += parse_models(text(answer.value))
        if answer.index == 0:
            return found
        if answer.index <= index:
            raise WireError(f"the list of models goes on at {answer.index} after {index}")
        index = answer.index


def parse_models(lines: str) -> List[Model]:
    """The models of one answer, one per line: id, name, type, parent and devices, separated by TABs. Raises WireError."""
    return [_parse_line(line) for line in lines.split("\n") if line]


def families(models: List[Model]) -> List[List[Model]]:
    """For each model, in order: itself and all its descendants, in the order of the list."""
    found = [[model] for model in models]
    parents: List[Optional[int]] = []
    places: Dict[str, int] = {}  # of equal names the last one so far
    for at, model in enumerate(models):  # parents come before children
        parents.append(places.get(model.parent))
        places[model.name] = at
        above = parents[at]
        while above is not None:
            found[above].append(model)
            above = parents[above]
    return found


def _parse_line(line: str) -> Model:
    fields = line.split("\t")
    if len(fields) != 5:
        raise WireError(f"a line of the list of models has {len(fields)} fields instead of 5: {line!r}")
    if not _is_number(fields[0]):
        raise WireError(f"{fields[0]!r} in the list of models is not an id")
    name, kind, parent = map(_unescaped, fields[1:4])
    return Model(name, kind, parent, [_parse_device(word, name) for word in fields[4].split()], int(fields[0]))


def _parse_device(word: str, model: str) -> DeviceAddress:
    port, _, rest = word.partition(":")
    interface, _, index = rest.partition(":")
    if not (_is_number(port) and _is_number(index)):
        raise WireError(f"{word!r} in the list of models is not PORT:INTERFACE:INDEX")
    return DeviceAddress(int(port), interface, int(index), model)


def _is_number(word: str) -> bool:
    return word.isascii() and word.isdigit()


def _unescaped(field: str) -> str:
    return re.sub(r"\\[\\tn]", lambda found: _ESCAPES[found.group()], field)
