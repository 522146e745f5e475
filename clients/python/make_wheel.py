"""Builds the package for `pip install clients/python`, without a network and with nothing but Python.

Robots are often offline, and what setuptools would do for these few files fits here. The functions are those
of PEP 517 and PEP 660.
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import zipfile
from typing import Dict

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = "playhouse_client"
PACKAGES = (PACKAGE, "playhouse_gym")  # the second needs numpy, which the first does without


def generate() -> None:
    """Makes generated/ in a clone; this folder of a release, or installed with the program, has it."""
    root = HERE.parent.parent
    if (root / "codegen").is_dir() and not ((HERE / PACKAGE / "generated").is_dir() and sys.version_info < (3, 11)):
        subprocess.run([sys.executable, "-m", "codegen"], cwd=root, stdout=subprocess.DEVNULL, check=True)


def version() -> str:
    return re.findall(r'^__version__ = "(.+)"$', (HERE / PACKAGE / "__init__.py").read_text(), re.M)[0]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    generate()
    sources = sorted(path for each in PACKAGES for path in (HERE / each).rglob("*.py")) + [HERE / PACKAGE / "py.typed"]
    return _write(wheel_directory, {path.relative_to(HERE).as_posix(): path.read_bytes() for path in sources})


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    generate()
    return _write(wheel_directory, {f"{PACKAGE}.pth": f"{HERE}\n".encode()})


def _write(folder: str, files: Dict[str, bytes]) -> str:
    """A wheel of these files (path in the wheel -> content); its name."""
    about = f"{PACKAGE}-{version()}.dist-info"
    files[f"{about}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: playhouse-client\nVersion: {version()}\n"
        "Summary: Drive robots behind a Player 3 server: standard library only\n"
        "License: Apache-2.0\nRequires-Python: >=3.8\n"
        "Provides-Extra: gym\nRequires-Dist: numpy; extra == 'gym'\n"
    ).encode()
    files[f"{about}/WHEEL"] = (
        b"Wheel-Version: 1.0\nGenerator: make_wheel\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    )
    record = "".join(f"{path},sha256={_digest(content)},{len(content)}\n" for path, content in files.items())
    files[f"{about}/RECORD"] = (record + f"{about}/RECORD,,\n").encode()
    name = f"{PACKAGE}-{version()}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
