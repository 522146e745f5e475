"""Generates code and pages from interfaces/*.toml, kinds/*.toml and viewer/commands.toml: model.py, kinds.py and
commands.py load and validate, emit_*.py write, __main__.py runs them."""

import sys

if sys.version_info < (3, 11):
    sys.exit("codegen needs Python 3.11 or newer, which reads TOML")
