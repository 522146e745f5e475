"""Common part of both environments: seeds, rewards, and ends of episodes."""

from typing import Any, Callable, Optional, Tuple

import numpy as np

from .arena import Arena
from .spaces import Box

Observe = Callable[[Arena], np.ndarray]
Reward = Callable[[Arena, np.ndarray], np.ndarray]
Terminated = Callable[[Arena], np.ndarray]


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
    raise ValueError(f"{what}: real numbers of shape {shape} are wanted, not {given}")


class Episodes:
    """Episodes of the agents of an arena."""

    def __init__(
        self,
        arena: Arena,
        max_steps: Optional[int],
        ticks: int,
        max_action: Tuple[float, float, float],
        observe: Observe,
        reward: Reward,
        terminated: Terminated,
        seed: Optional[int],
    ) -> None:
        """`seed`: seed of all random numbers until reset() has another; None: a different one each time."""
        self.arena = arena
        self._max_steps, self._ticks = max_steps, ticks
        self._observe, self._reward, self._terminated = observe, reward, terminated
        self._random = np.random.default_rng(seed)
        self._begun = False
        self.steps = np.zeros(arena.agents, np.int64)  # steps in each agent's episode
        self._before = arena.pose.copy()
        high = np.asarray(max_action, np.float32)
        self.action_space = Box(-high, high, dtype=np.float32)
        first = np.asarray(observe(arena))[0]
        least, most = (0.0, float(arena.range_max.max())) if observe is ranges else (-np.inf, np.inf)
        self.observation_space = Box(least, most, first.shape, first.dtype)

    def reset(self, seed: Optional[int]) -> np.ndarray:
        """Starts episodes of all agents. Without a seed it continues with the previous one."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self._begun = True
        self.arena.start_again(int(self._random.integers(1 << 63)))
        self.steps[:] = 0
        return np.asarray(self._observe(self.arena))

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
        rewards = np.asarray(self._reward(self.arena, self._before))
        terminated = np.array(self._terminated(self.arena), np.bool_)
        if begun.any():
            rewards = np.where(begun, 0, rewards).astype(rewards.dtype)
            terminated &= ~begun
        truncated = np.zeros_like(terminated)
        if self._max_steps is not None:
            truncated = (self.steps >= self._max_steps) & ~terminated
        return np.asarray(self._observe(self.arena)), rewards, terminated, truncated

    def act(self, actions: np.ndarray, agents: Any = slice(None)) -> None:
        self.arena.actions[agents] = np.clip(actions, self.action_space.low, self.action_space.high)
