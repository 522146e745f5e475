"""Turns interfaces/*.toml and kinds/*.toml into code and pages: model.py and kinds.py load and check, emit_*.py write,
__main__.py runs them."""
