"""Learns to drive far without collisions, by evolution strategies: python3 examples/gym/learn.py

Every robot of a crowd drives one episode with parameters of its own, which are the present ones with some noise; where the
noise did well the parameters go. The policy is linear: twelve distances in, forward and turning speed out.
"""

import argparse
import pathlib
import sys
import tempfile
import time
from typing import List, Sequence, Tuple

import numpy as np

from arguments import whole
from swarm import swarm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "clients" / "python"))
from playhouse_gym import ArenaError, VectorEnv  # noqa: E402

SECTORS, BEAMS = 12, 60
INPUTS = SECTORS + 1  # plus a bias input of 1
NOISE, RATE = 0.5, 0.5
COLLISION = 10.0  # m, penalty on the score of an episode


def inputs_of(ranges: np.ndarray) -> np.ndarray:
    """Proximity of the nearest object in each sector: 1 close, 0 at 3 m or more."""
    nearest = ranges.reshape(len(ranges), SECTORS, -1).min(axis=2)
    near = 1.0 - np.minimum(nearest, 3.0) / 3.0
    return np.concatenate((near, np.ones((len(ranges), 1), np.float32)), axis=1)


def actions_of(parameters: np.ndarray, ranges: np.ndarray) -> np.ndarray:
    """Forward 0 to 1 m/s, turn -1.5 to 1.5 rad/s; one row of parameters per robot."""
    out = np.einsum("ri,rio->ro", inputs_of(ranges), parameters.reshape(-1, INPUTS, 2))
    forward = 1.0 / (1.0 + np.exp(-out[:, 0]))
    return np.stack((forward, np.zeros_like(forward), 1.5 * np.tanh(out[:, 1])), axis=1)


def drive(env: VectorEnv, parameters: np.ndarray, seed: int, steps: int) -> Tuple[np.ndarray, np.ndarray]:
    """One episode of every robot: distance until the first collision [m], and whether it collided."""
    ranges, _ = env.reset(seed=seed)
    fitness, running = np.zeros(env.num_envs), np.ones(env.num_envs, np.bool_)
    collided = np.zeros(env.num_envs, np.bool_)
    for _ in range(steps):
        ranges, rewards, terminations, _, _ = env.step(actions_of(parameters, ranges))
        collided |= running & terminations
        fitness[running] += np.where(terminations, 0, rewards)[running]
        running &= ~terminations
    return fitness, collided


def ranks(values: np.ndarray) -> np.ndarray:
    """Ranks, scaled from -0.5 (smallest) to 0.5 (largest)."""
    order = np.empty(len(values))
    order[np.argsort(values, kind="stable")] = np.arange(len(values))
    return order / (len(values) - 1) - 0.5


def learn(env: VectorEnv, generations: int, steps: int, seed: int) -> List[Tuple[float, float]]:
    """Mean distance [m] and collision rate of each generation, all robots with the current parameters."""
    random = np.random.default_rng(seed)
    parameters = np.zeros(INPUTS * 2)
    curve = []
    for generation in range(generations):
        half = random.standard_normal((env.num_envs // 2, parameters.size))
        odd = np.zeros((env.num_envs % 2, parameters.size))
        noise = np.concatenate((half, -half, odd))  # antithetic pairs, to reduce variance
        driven, collided = drive(env, parameters + NOISE * noise, seed * 1000 + generation, steps)
        fitness = driven - COLLISION * collided
        parameters = parameters + 12 * RATE * (ranks(fitness) @ noise) / len(noise)
        distance, collided = drive(env, np.tile(parameters, (env.num_envs, 1)), seed * 1000 + generation, steps)
        curve.append((float(distance.mean()), float(collided.mean())))
        print(f"generation {generation + 1:3}: {curve[-1][0]:5.2f} m, {100 * curve[-1][1]:5.1f} % collide", flush=True)
    return curve


def path(values: Sequence[float], most: float) -> str:
    points = [f"{60 + 520 * k / max(len(values) - 1, 1):.1f},{260 - 220 * value / most:.1f}" for k, value in enumerate(values)]
    return " ".join(points)


def drawn(curve: List[Tuple[float, float]], about: str) -> str:
    """The learning curve as an SVG image."""
    most = max(distance for distance, _ in curve) * 1.1
    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 320" font-family="sans-serif" font-size="12">',
        '<rect width="640" height="320" fill="white"/>',
        '<path d="M60 40V260H580V40" fill="none" stroke="#888"/>',
    ]
    for k in range(5):
        y = 260 - 55 * k
        lines += [f'<text x="52" y="{y + 4}" text-anchor="end" fill="#1f5fa8">{most * k / 4:.1f}</text>',
                  f'<text x="588" y="{y + 4}" fill="#b3452c">{25 * k} %</text>',
                  f'<path d="M60 {y}H580" stroke="#eee"/>']
    lines += [
        f'<polyline points="{path([distance for distance, _ in curve], most)}" fill="none" stroke="#1f5fa8" stroke-width="2"/>',
        f'<polyline points="{path([share for _, share in curve], 1.0)}" fill="none" stroke="#b3452c" stroke-width="2"/>',
        '<text x="60" y="28" fill="#1f5fa8">distance of an episode, m</text>',
        '<text x="580" y="28" text-anchor="end" fill="#b3452c">robots that collide</text>',
        f'<text x="60" y="278">1</text><text x="580" y="278" text-anchor="end">{len(curve)}</text>',
        '<text x="320" y="278" text-anchor="middle">generation</text>',
        f'<text x="320" y="304" text-anchor="middle" fill="#666">{about}</text>', "</svg>", "",
    ]
    return "\n".join(lines)


def parsed() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robots", type=whole(2), default=200)
    parser.add_argument("--generations", type=whole(1), default=100)
    parser.add_argument("--steps", type=whole(1), default=150, help="of an episode, 0.1 s each")
    parser.add_argument("--seed", type=whole(0), default=1)
    parser.add_argument("--workers", type=whole(1, 1024), default=1)
    parser.add_argument("--web", type=whole(0, 65535), help="port of a page to watch")
    parser.add_argument("--svg", help="file for the learning curve")
    arguments = parser.parse_args()
    if arguments.svg is not None:
        try:
            open(arguments.svg, "a").close()
        except OSError as error:
            parser.error(f"argument --svg: {arguments.svg} cannot be written: {error.strerror}")
    return arguments


def main() -> None:
    arguments = parsed()
    with tempfile.NamedTemporaryFile("w", suffix=".world") as file:
        file.write(swarm(arguments.robots, BEAMS, density=0.1))
        file.flush()
        start = time.monotonic()
        with VectorEnv(file.name, max_steps=None, workers=arguments.workers, web=arguments.web) as env:
            if arguments.web is not None:
                print(env.render())
            curve = learn(env, arguments.generations, arguments.steps, arguments.seed)
        about = (f"{arguments.robots} robots, {len(curve)} generations of {2 * arguments.steps} steps "
                 f"in {time.monotonic() - start:.0f} s")
    print(about)
    if arguments.svg is not None:
        pathlib.Path(arguments.svg).write_text(drawn(curve, about))


if __name__ == "__main__":
    try:
        main()
    except ArenaError as error:
        sys.exit(f"learn.py: error: {error}")
