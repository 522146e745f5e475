"""Standard headers that a C++ file uses and does not include: builds with precompiled headers (cmake/precompiled/library.h)
compile such a file all the same. A file has what it includes, and what headers of the tree that it includes have."""

from __future__ import annotations

import functools
import pathlib
import re

# Names of namespace std by the header that has them: those of the precompiled headers.
NAMES = {
    "algorithm": r"sort|stable_sort|find|find_if|min|max|minmax|clamp|all_of|any_of|none_of|count|count_if|copy|fill|fill_n|transform"
                 r"|reverse|rotate|lower_bound|upper_bound|equal_range|binary_search|unique|partition|nth_element|min_element"
                 r"|max_element|remove_if|replace|equal|mismatch|adjacent_find|is_sorted|partial_sort|set_difference|ranges::\w+",
    "array": r"array|to_array",
    "atomic": r"atomic|atomic_\w+|memory_order\w*",
    "bit": r"bit_cast|endian|popcount|countr_zero|countl_zero|bit_width|has_single_bit|bit_ceil|bit_floor|rotl|rotr",
    "chrono": r"chrono::\w+",
    "cmath": r"sqrt|fabs|abs|floor|ceil|round|lround|llround|isfinite|isnan|isinf|fmod|remainder|nextafter|ldexp|copysign|trunc|signbit|cbrt",
    "condition_variable": r"condition_variable\w*",
    "cstddef": r"size_t|byte|ptrdiff_t|to_integer|nullptr_t",
    "cstdint": r"u?int(?:8|16|32|64)_t|uintptr_t",
    "cstring": r"memcpy|memcmp|memset|memmove|strlen|strerror|strcmp",
    "deque": r"deque",
    "functional": r"function|hash|less|greater|reference_wrapper|ref|cref|invoke|plus|minus|identity|not_fn|bind_front",
    "limits": r"numeric_limits",
    "map": r"map|multimap",
    "memory": r"unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared|enable_shared_from_this|addressof",
    "mutex": r"mutex|lock_guard|unique_lock|scoped_lock|once_flag|call_once",
    "numeric": r"accumulate|iota|reduce|inner_product|partial_sum|gcd|lcm|midpoint",
    "optional": r"optional|nullopt|make_optional",
    "set": r"set|multiset",
    "span": r"span|as_bytes|as_writable_bytes",
    "string": r"string|to_string|stoi|stod|stoul|stoull|getline",
    "string_view": r"string_view",
    "thread": r"thread|jthread|this_thread::\w+",
    "tuple": r"tuple|tie|make_tuple|apply|forward_as_tuple|tuple_size_v",
    "utility": r"move|pair|swap|exchange|forward|make_pair|index_sequence|make_index_sequence|in_place\w*|as_const|declval",
    "variant": r"variant|get_if|holds_alternative|visit|monostate",
    "vector": r"vector",
}
# What the standard says that a header brings, or every library's does.
BRINGS = {
    "algorithm": {"utility"}, "array": {"cstddef"}, "condition_variable": {"mutex", "chrono"}, "cstring": {"cstddef"},
    "map": {"utility", "tuple"}, "mutex": {"chrono"}, "optional": {"utility"}, "span": {"array", "cstddef"},
    "string": {"string_view"}, "string_view": {"cstddef"}, "thread": {"chrono"}, "tuple": {"utility"}, "variant": {"utility"},
}
USES = {header: re.compile(rf"\bstd::(?:{names})\b") for header, names in NAMES.items()}
STANDARD = re.compile(r"^\s*#include <([^>]+)>", re.MULTILINE)
OWN = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


def missing(path: pathlib.Path, folders: tuple[pathlib.Path, ...]) -> list[tuple[int, str, str]]:
    """(line, name, header) of the first use of each header that the file lacks. Own headers are looked for in `folders`."""
    has = set(headers_of(path, folders))
    found = []
    for number, line in enumerate(text_of(path).splitlines(), 1):
        code = line.split("//")[0]
        if "std::" not in code:
            continue
        for header, uses in USES.items():
            if header not in has and (name := uses.search(code)):
                has.add(header)
                found.append((number, name[0], header))
    return found


@functools.lru_cache(None)
def headers_of(path: pathlib.Path, folders: tuple[pathlib.Path, ...]) -> frozenset[str]:
    seen, left, found = {path}, [path], set()
    while left:
        file = left.pop()
        found |= set(STANDARD.findall(text_of(file)))
        for name in OWN.findall(text_of(file)):
            for own in (folder / name for folder in (file.parent, *folders)):
                if own not in seen and own.exists():
                    seen.add(own)
                    left.append(own)
    return frozenset(found.union(*(BRINGS.get(header, set()) for header in found)))


@functools.lru_cache(None)
def text_of(path: pathlib.Path) -> str:
    return path.read_text(encoding="utf-8")
