"""Messages of the program say what is invalid, and which values are valid: phrases that say neither are refused."""

import pathlib
import re

import module_graph

ROOT = pathlib.Path(__file__).resolve().parent.parent

# A comment, a character, or a string literal with its text.
TOKEN = re.compile(r"""//.*|'\\?.'|"((?:[^"\\]|\\.)*)\"""")
INSTEAD = {
    "is none": 'say "invalid", and what is valid',
    "are none": 'say "invalid", and what is valid',
    "told once": 'say "logged once"',
}
PHRASE = re.compile(r"(?<!\bthere )\b(?:" + "|".join(INSTEAD) + r")\b")


def odd_phrases(path):
    """"file:line: what" of each string literal of the program with such a phrase; tests may say anything."""
    if module_graph.is_test(path):
        return
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for token in TOKEN.finditer(line):
            for found in PHRASE.findall(token[1] or ""):
                yield f'{path.relative_to(ROOT)}:{number}: "{found}" in a message: {INSTEAD[found]}'
