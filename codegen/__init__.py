"""Turns interfaces/*.toml into code and pages: model.py loads and checks, emit_*.py write, __main__.py runs them."""
