"""Spaces of actions and observations: those of Gymnasium if it is installed, else the part of them that programs
use."""

from typing import Any, Optional

import numpy as np

try:
    from gymnasium.spaces import Box, Discrete
except ImportError:

    class _Space:
        """Values of a fixed shape and dtype."""

        def __init__(self, shape: Any, dtype: Any) -> None:
            self.shape = tuple(shape)
            self.dtype = np.dtype(dtype)
            self._random: Optional[np.random.Generator] = None

        @property
        def np_random(self) -> np.random.Generator:
            if self._random is None:
                self._random = np.random.default_rng()
            return self._random

        def seed(self, seed: Optional[int] = None) -> Optional[int]:
            self._random = np.random.default_rng(seed)
            return seed

        def contains(self, x: Any) -> bool:
            raise NotImplementedError

        def __contains__(self, x: Any) -> bool:
            return self.contains(x)

    class Box(_Space):  # type: ignore[no-redef]
        """Arrays between two bounds, given as arrays of the shape or as scalars."""

        def __init__(self, low: Any, high: Any, shape: Any = None, dtype: Any = np.float32) -> None:
            super().__init__(np.shape(low) if shape is None else shape, dtype)
            self.low = np.broadcast_to(np.asarray(low, self.dtype), self.shape)
            self.high = np.broadcast_to(np.asarray(high, self.dtype), self.shape)

        def sample(self) -> np.ndarray:
            """Of each value: uniform between two finite bounds, exponential away from a single one, normal without any."""
            low, high = np.isfinite(self.low), np.isfinite(self.high)
            neither, only_low, only_high, both = ~low & ~high, low & ~high, ~low & high, low & high
            values = np.empty(self.shape)
            values[neither] = self.np_random.normal(size=neither.sum())
            values[only_low] = self.low[only_low] + self.np_random.exponential(size=only_low.sum())
            values[only_high] = self.high[only_high] - self.np_random.exponential(size=only_high.sum())
            whole = self.dtype.kind != "f"
            values[both] = self.np_random.uniform(self.low[both], self.high[both].astype(np.float64) + whole)
            return (np.floor(values) if whole else values).astype(self.dtype)

        def contains(self, x: Any) -> bool:
            x = np.asarray(x)
            return (x.shape == self.shape and np.can_cast(x.dtype, self.dtype)
                    and bool(np.all(x >= self.low) and np.all(x <= self.high)))

        def __eq__(self, other: object) -> bool:
            return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype
                    and np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

        def __repr__(self) -> str:
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"

    class Discrete(_Space):  # type: ignore[no-redef]
        """`n` integers from `start` on."""

        def __init__(self, n: int, start: int = 0) -> None:
            super().__init__((), np.int64)
            self.n, self.start = int(n), int(start)

        def sample(self) -> np.int64:
            return np.int64(self.start + self.np_random.integers(self.n))

        def contains(self, x: Any) -> bool:
            x = np.asarray(x)
            return x.shape == () and np.issubdtype(x.dtype, np.integer) and bool(0 <= x - self.start < self.n)

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Discrete) and (self.n, self.start) == (other.n, other.start)

        def __repr__(self) -> str:
            return f"Discrete({self.n}, start={self.start})"


def unbounded(shape: Any, dtype: np.dtype) -> "Box":
    """Arrays of any values of the dtype."""
    if dtype.kind == "f":
        return Box(-np.inf, np.inf, shape, dtype)
    least, most = (0, 1) if dtype.kind == "b" else (np.iinfo(dtype).min, np.iinfo(dtype).max)
    return Box(least, most, shape, dtype)


def batch(space: "Box", count: int) -> "Box":
    """The batched space: `count` values of this space."""
    low, high = (np.repeat(bound[np.newaxis], count, axis=0) for bound in (space.low, space.high))
    return Box(low, high, dtype=space.dtype)
