"""World files with any number of lidar robots in a walled square, for examples and measurements of playhouse_gym."""

import math


def swarm(robots: int = 1000, beams: int = 180, density: float = 0.39, reach: float = 8.0) -> str:
    """Text of a world: robots on a grid, `density` per square metre, each with this many beams of range `reach` m over
    180 degrees; ticks of 100 ms."""
    side = math.ceil(math.sqrt(robots))
    gap = math.sqrt(1 / density)
    lines = [
        "interval_sim 100",
        f"define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 {reach}] fov 180 samples {beams} ) )",
        "define robot position( size [0.44 0.38 0.22] scanner( pose [0 0 0 0] ) )",
        f'model( name "walls" size [{side * gap + 1:.2f} {side * gap + 1:.2f} 1] boundary 1 noblocks 1 )',
    ]
    for k in range(robots):
        x, y = ((k % side + 0.5) - side / 2) * gap, ((k // side + 0.5) - side / 2) * gap
        lines.append(f'robot( name "r{k}" pose [{x:.3f} {y:.3f} 0 {k * 137 % 360}] )')
    return "\n".join(lines) + "\n"
