"""Makes the package of this checkout importable, whether or not one is installed, and `waiting` of tests/."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "clients" / "python"))
sys.path.append(str(ROOT / "tests"))
