"""Common part of both environments: seeds, rewards, and ends of episodes."""

import os
from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np

from .arena import MOST_TICKS, Arena, whole_number
from .spaces import Box, unbounded

Observe = Callable[[Arena], np.ndarray]
Reward = Callable[[Arena, np.ndarray], np.ndarray]
Terminated = Callable[[Arena], np.ndarray]
_MOST_STEPS = np.iinfo(np.int64).max


def ranges(arena: Arena) -> np.ndarray:
    """Measurements of the range finders. [m]"""
    return arena.ranges


def progress(arena: Arena, before: np.ndarray) -> np.ndarray:
    """Distance travelled by each robot along its heading [m], minus 1 after a collision.
    `before` are the poses before the step."""
    moved = arena.pose[:, :2] - before[:, :2]
    forward = moved[:, 0] * np.cos(before[:, 2]) + moved[:, 1] * np.sin(before[:, 2])
    return (forward - arena.stalled).astype(np.float32)


def collided(arena: Arena) -> np.ndarray:
    return arena.stalled


def real_numbers(what: str, values: Any, shape: Tuple[int, ...]) -> np.ndarray:
    """`values` as an array, if they are real numbers of this shape; else a ValueError that begins with `what`."""
    try:
        array = np.asarray(values)
    except ValueError:
        given = "rows of different lengths"
    else:
        if array.shape == shape and np.can_cast(array.dtype, np.float32, "same_kind"):
            return array
        given = f"{array.dtype} of shape {array.shape}"
    raise ValueError(f"{what}: real numbers of shape {shape} are expected, not {given}")


class Episodes:
    """Episodes of the agents of an arena."""

    def __init__(
        self,
        world: Union[str, "os.PathLike[str]"],
        max_steps: Optional[int],
        ticks: int,
        max_action: Tuple[float, float, float],
        observe: Observe,
        reward: Reward,
        terminated: Terminated,
        arena: Dict[str, Any],
    ) -> None:
        """`arena`: arguments of the Arena, which is started after the others are checked. Its `seed` is that of all random
        numbers until reset() has another; None: a different one each time."""
        self._max_steps = None if max_steps is None else whole_number("max_steps", max_steps, _MOST_STEPS)
        self._ticks = whole_number("ticks", ticks, MOST_TICKS)
        self.action_space = _action_space(max_action)
        self._observe, self._reward, self._terminated = observe, reward, terminated
        self._random = np.random.default_rng(arena.get("seed"))
        self._begun = False
        self.arena = Arena(world, **arena)
        try:
            self.observation_space = self._space()
        except BaseException:
            self.arena.close()
            raise
        self.steps = np.zeros(self.arena.agents, np.int64)  # steps in each agent's episode
        self._before = self.arena.pose.copy()

    def reset(self, seed: Optional[int]) -> np.ndarray:
        """Starts episodes of all agents. Without a seed it continues with the previous one."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self._begun = True
        self.arena.start_again(int(self._random.integers(1 << 63)))
        self.steps[:] = 0
        return self._observations()

    def step(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Applies the actions and resets in the arena; returns observations, rewards, terminations, truncations. Agents
        that were reset start a new episode."""
        if not self._begun:
            raise RuntimeError("reset() comes before step()")
        begun = self.arena.reset_mask.copy()
        np.copyto(self._before, self.arena.pose)
        self.arena.step(self._ticks)
        self.steps += 1
        self.steps[begun] = 0
        each = (self.arena.agents,)
        rewards = real_numbers("reward", self._reward(self.arena, self._before), each)
        terminated = real_numbers("terminated", self._terminated(self.arena), each).astype(np.bool_)
        if begun.any():
            rewards = np.where(begun, 0, rewards).astype(rewards.dtype)
            terminated &= ~begun
        truncated = np.zeros_like(terminated)
        if self._max_steps is not None:
            truncated = (self.steps >= self._max_steps) & ~terminated
        return self._observations(), rewards, terminated, truncated

    def act(self, actions: np.ndarray, agents: Any = slice(None)) -> None:
        self.arena.actions[agents] = np.clip(actions, self.action_space.low, self.action_space.high)

    def _space(self) -> Box:
        first = np.asarray(self._observe(self.arena))
        if first.shape[:1] != (self.arena.agents,):
            raise ValueError(f"observe: an array with {self.arena.agents} rows is expected, not one of shape {first.shape}")
        if self._observe is ranges:
            return Box(0.0, float(self.arena.range_max.max()), first.shape[1:], first.dtype)
        return unbounded(first.shape[1:], first.dtype)

    def _observations(self) -> np.ndarray:
        values = np.asarray(self._observe(self.arena))
        shape = (self.arena.agents, *self.observation_space.shape)
        if values.shape != shape:
            raise ValueError(f"observe: an array of shape {shape} is expected, as the first, not one of shape {values.shape}")
        return values


def _action_space(max_action: Tuple[float, float, float]) -> Box:
    high = real_numbers("max_action", max_action, (3,))
    if not ((high >= 0) & (high <= np.finfo(np.float32).max)).all():
        raise ValueError(f"max_action: finite numbers from 0 on are expected, not {max_action}")
    high = high.astype(np.float32)
    return Box(-high, high, dtype=np.float32)
