"""Measures agent-steps per second of playhouse_gym: python3 examples/gym/rate.py [--robots 1000] [--beams 180]"""

import argparse
import pathlib
import sys
import tempfile
import time

import numpy as np

from arguments import whole
from swarm import swarm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "clients" / "python"))
from playhouse_gym import ArenaError, VectorEnv  # noqa: E402


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=whole(1), default=1000)
    parser.add_argument("--beams", type=whole(3), default=180)
    parser.add_argument("--workers", type=whole(1, 1024), default=1)
    parser.add_argument("--seconds", type=float, default=10.0)
    arguments = parser.parse_args()
    with tempfile.NamedTemporaryFile("w", suffix=".world") as file:
        file.write(swarm(arguments.robots, arguments.beams))
        file.flush()
        with VectorEnv(file.name, workers=arguments.workers, copy=False) as env:
            env.reset(seed=1)
            actions = np.zeros((env.num_envs, 3), np.float32)
            steps, start = 0, time.perf_counter()
            while time.perf_counter() - start < arguments.seconds:
                ahead = env.arena.ranges[:, arguments.beams // 3:-(arguments.beams // 3)].min(axis=1)
                actions[:, 0] = np.where(ahead > 0.8, 0.5, 0.0)
                actions[:, 2] = np.where(ahead > 0.8, 0.0, 1.0)
                env.step(actions)
                steps += 1
            seconds = time.perf_counter() - start
    print(f"{env.num_envs} robots, {arguments.beams} beams, {arguments.workers} workers: {steps / seconds:.1f} steps/s, "
          f"{steps * env.num_envs / seconds:.0f} agent-steps/s")


if __name__ == "__main__":
    try:
        main()
    except ArenaError as error:
        sys.exit(f"rate.py: error: {error}")
