"""The other client libraries, for tests that all languages pass.

PLAYHOUSE_CLIENTS is LANGUAGE=FOLDER, separated by spaces: ctest sets it (clients/CMakeLists.txt says which programs are
in a folder).
"""

import os
import unittest
from concurrent.futures import ThreadPoolExecutor
from typing import Callable, Dict, TypeVar

FOLDERS = dict(entry.split("=", 1) for entry in os.environ.get("PLAYHOUSE_CLIENTS", "").split())
needed = unittest.skipUnless(FOLDERS, "run by ctest, which names the programs of the other languages")


AT_ONCE = 4  # most of the time of a robot that is driven is its own, not of the processor
T = TypeVar("T")


def programs(name: str) -> Dict[str, str]:
    """Language -> the path of its program."""
    return {language: os.path.join(folder, name) for language, folder in FOLDERS.items()}


def check_each(test: unittest.TestCase, commands: Dict[str, T], check: Callable[[T], None]) -> None:
    """Calls check() with the command of each language, some at once, and tells for which it fails."""
    with ThreadPoolExecutor(AT_ONCE) as pool:
        checked = {language: pool.submit(check, command) for language, command in commands.items()}
    for language, each in checked.items():
        with test.subTest(language):
            each.result()
