"""The other client libraries, for tests that all languages pass.

PLAYHOUSE_CLIENTS is LANGUAGE=FOLDER, separated by spaces: ctest sets it (clients/CMakeLists.txt says which programs are
in a folder).
"""

import os
import unittest
from typing import Dict

FOLDERS = dict(entry.split("=", 1) for entry in os.environ.get("PLAYHOUSE_CLIENTS", "").split())
needed = unittest.skipUnless(FOLDERS, "run by ctest, which names the programs of the other languages")


def programs(name: str) -> Dict[str, str]:
    """Language -> the path of its program."""
    return {language: os.path.join(folder, name) for language, folder in FOLDERS.items()}
