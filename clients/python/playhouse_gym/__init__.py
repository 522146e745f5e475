"""Learning programs and a world of robots: a velocity for every robot in, what every robot senses out, a thousand
robots a call.

    from playhouse_gym import VectorEnv

    with VectorEnv("swarm.world", max_steps=500) as env:
        observations, infos = env.reset(seed=1)
        while True:
            observations, rewards, terminations, truncations, infos = env.step(policy(observations))

VectorEnv has the interface of Gymnasium's vector environments, ParallelEnv that of PettingZoo's parallel ones, Arena is
what both are made of. Needs numpy, and Python 3.9; docs/gym.md tells more.
"""

from .arena import Arena, ArenaError
from .episodes import collided, progress, ranges
from .parallel_env import ParallelEnv
from .spaces import Box, Discrete
from .vector_env import VectorEnv

__all__ = ["Arena", "ArenaError", "Box", "Discrete", "ParallelEnv", "VectorEnv", "collided", "progress", "ranges"]
