"""All robots of a world as the agents of a PettingZoo parallel environment."""

import os
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from .episodes import Episodes, Observe, Reward, Terminated, collided, progress, ranges, real_numbers
from .spaces import Box

try:
    from pettingzoo import ParallelEnv as _Base
except ImportError:
    _Base = object

_Values = Dict[str, Any]


class ParallelEnv(_Base):  # type: ignore[misc]
    """One agent per robot, "robot_0" and so on. An agent whose episode has ended is removed from the agents, and its robot
    stands still until reset(). The functions are as for VectorEnv."""

    metadata: Dict[str, Any] = {"render_modes": [], "name": "playhouse_v0", "is_parallelizable": True}
    render_mode = None

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
        **arena: Any,
    ) -> None:
        self._episodes = Episodes(world, max_steps, ticks, max_action, observe, reward, terminated, arena)
        self.arena = self._episodes.arena
        self.possible_agents: List[str] = [f"robot_{row}" for row in range(self.arena.agents)]
        self.agents: List[str] = []
        self._rows = {name: row for row, name in enumerate(self.possible_agents)}
        self.observation_spaces = {name: self._episodes.observation_space for name in self.possible_agents}
        self.action_spaces = {name: self._episodes.action_space for name in self.possible_agents}
        self.state_space = Box(-np.inf, np.inf, (self.arena.agents, 6), np.float64)

    @property
    def unwrapped(self) -> "ParallelEnv":
        return self

    @property
    def num_agents(self) -> int:
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        return len(self.possible_agents)

    def observation_space(self, agent: str) -> Box:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Box:
        return self.action_spaces[agent]

    def reset(
        self, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[_Values, Dict[str, Dict[str, Any]]]:
        observations = self._episodes.reset(seed).copy()
        self.agents = list(self.possible_agents)
        return dict(zip(self.agents, observations)), {name: {} for name in self.agents}

    def step(self, actions: _Values) -> Tuple[_Values, _Values, _Values, _Values, Dict[str, Dict[str, Any]]]:
        """Takes velocities of the agents, clipped to the action space; agents without one stand still, and those of
        agents whose episode has ended are ignored. Raises ValueError, and steps nobody, for an agent that does not
        exist, or an action that is not three real numbers."""
        names = self.agents
        self._act(actions)
        observations, rewards, terminations, truncations = self._episodes.step()
        observations = observations.copy()
        rows = [self._rows[name] for name in names]
        told = [dict(zip(names, values)) for values in (
            observations[rows], rewards[rows].tolist(), terminations[rows].tolist(), truncations[rows].tolist())]
        over = terminations | truncations
        self.agents = [name for name, row in zip(names, rows) if not over[row]]
        return told[0], told[1], told[2], told[3], {name: {} for name in names}

    def state(self) -> np.ndarray:
        """Poses and velocities of all robots."""
        return np.concatenate((self.arena.pose, self.arena.velocity), axis=1)

    def render(self) -> Optional[str]:
        """Address of the page, if `web` was given."""
        return self.arena.page

    def close(self) -> None:
        self.arena.close()

    def __enter__(self) -> "ParallelEnv":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _act(self, actions: _Values) -> None:
        for name in actions:
            if name not in self._rows:
                raise ValueError(f"there is no agent {name!r}: agents are robot_0 to {self.possible_agents[-1]}")
        acting = [name for name in self.agents if name in actions]
        taken = [real_numbers(f"the action of {name}", actions[name], (3,)) for name in acting]
        self.arena.actions[:] = 0
        if acting:
            self._episodes.act(np.stack(taken), [self._rows[name] for name in acting])
