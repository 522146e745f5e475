"""All robots of a world as the sub-environments of a Gymnasium vector environment."""

import os
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np

from .episodes import Episodes, Observe, Reward, Terminated, collided, progress, ranges, real_numbers
from .spaces import batch

try:
    from gymnasium.vector import AutoresetMode, VectorEnv as _Base

    _NEXT_STEP: Any = AutoresetMode.NEXT_STEP
except ImportError:
    _Base, _NEXT_STEP = object, "NextStep"


class VectorEnv(_Base):  # type: ignore[misc]
    """One sub-environment per robot; all share a world, so robots can collide.

    When a robot's episode ends, by `terminated` or after `max_steps` steps, the next step() ignores its action and
    moves it to a free position (next-step autoreset): its observation is the first of the new episode, its reward 0.

    `observe(arena)`, `reward(arena, poses_before)` and `terminated(arena)` map the columns of all robots (Arena) to an
    array with a row for each. `ticks`: ticks of the world per step. With `copy` False, results are views that the
    next step() overwrites.
    """

    metadata: Dict[str, Any] = {"render_modes": [], "autoreset_mode": _NEXT_STEP}
    render_mode = None
    spec = None
    closed = True  # until constructed: Gymnasium closes open environments, also after a failed construction

    def __init__(
        self,
        world: Union[str, "os.PathLike[str]"],
        *,
        max_steps: Optional[int] = 500,
        ticks: int = 1,
        max_action: Tuple[float, float, float] = (1.0, 0.0, 1.5),
        observe: Observe = ranges,
        reward: Reward = progress,
        terminated: Terminated = collided,
        copy: bool = True,
        **arena: Any,
    ) -> None:
        """Further arguments are those of Arena."""
        self._episodes = Episodes(world, max_steps, ticks, max_action, observe, reward, terminated, arena)
        self.arena = self._episodes.arena
        self._copy = copy
        self.num_envs = self.arena.agents
        self.single_observation_space = self._episodes.observation_space
        self.single_action_space = self._episodes.action_space
        self.observation_space = batch(self.single_observation_space, self.num_envs)
        self.action_space = batch(self.single_action_space, self.num_envs)
        self._over = np.zeros(self.num_envs, np.bool_)
        self.closed = False

    @property
    def unwrapped(self) -> "VectorEnv":
        return self

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Starts episodes of all robots, each at a different position. The same seed and actions give bit-identical
        observations. Without a seed the random numbers of the previous one continue, which may be the constructor's.
        There are no options."""
        observations = self._episodes.reset(seed)
        self._over[:] = False
        return self._handed_out(observations), {}

    def step(self, actions: Any) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]]:
        """Takes velocities of all robots, a row each, clipped to the action space. Raises ValueError, and steps nobody,
        if they are not real numbers of the action space's shape."""
        self._episodes.act(real_numbers("actions", actions, self.action_space.shape))
        np.copyto(self.arena.reset_mask, self._over)
        observations, rewards, terminations, truncations = self._episodes.step()
        np.logical_or(terminations, truncations, out=self._over)
        return self._handed_out(observations), self._handed_out(rewards), terminations, truncations, {}

    def render(self) -> Optional[str]:
        """Address of the page, if `web` was given."""
        return self.arena.page

    def close(self, **_: Any) -> None:
        self.closed = True
        self.arena.close()

    def __enter__(self) -> "VectorEnv":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _handed_out(self, values: np.ndarray) -> np.ndarray:
        return values.copy() if self._copy else values
