"""Reinforcement learning in a simulated world: velocities of all robots in, measurements of all robots out, a thousand
robots per call.

    from playhouse_gym import VectorEnv

    with VectorEnv("swarm.world", max_steps=500) as env:
        observations, infos = env.reset(seed=1)
        while True:
            observations, rewards, terminations, truncations, infos = env.step(policy(observations))

VectorEnv has the interface of Gymnasium's vector environments, ParallelEnv that of PettingZoo's parallel ones, Arena is
the common base. Requires numpy and Python 3.9; see docs/gym.md.
"""

try:
    import numpy as _numpy  # noqa: F401
except ModuleNotFoundError:
    raise ModuleNotFoundError("playhouse_gym needs numpy: apt install python3-numpy, or pip install numpy", name="numpy") from None

from .arena import Arena, ArenaError
from .episodes import collided, progress, ranges
from .parallel_env import ParallelEnv
from .spaces import Box, Discrete
from .vector_env import VectorEnv

__all__ = ["Arena", "ArenaError", "Box", "Discrete", "ParallelEnv", "VectorEnv", "collided", "progress", "ranges"]
