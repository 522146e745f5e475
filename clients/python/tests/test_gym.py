"""playhouse_gym against the real program: both interfaces as their documentation has them, and the same bits twice."""

import json
import os
import pathlib
import re
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
from typing import Dict, Sequence, cast

from package import ROOT
from server_program import HANG, PROGRAM, needed
from waiting import wait_for_any

try:
    import numpy as np
except ImportError:  # ctest runs this file once more with a Python that has it
    raise unittest.SkipTest("there is no numpy") from None
from playhouse_gym import Arena, ArenaError, Box, Discrete, ParallelEnv, VectorEnv  # noqa: E402
from playhouse_gym.arena import _columns_in  # noqa: E402

sys.path.insert(0, str(ROOT / "examples" / "gym"))
from swarm import swarm  # noqa: E402

ROBOTS, BEAMS = 12, 20


class WithWorld(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.world = str(pathlib.Path(folder.name) / "test.world")
        pathlib.Path(self.world).write_text(swarm(ROBOTS, BEAMS))

    def vector_env(self, **more: object) -> VectorEnv:
        env = VectorEnv(self.world, program=PROGRAM, **more)
        self.addCleanup(env.close)
        return env


@needed
class TheArena(WithWorld):
    def test_the_page_has_an_address_at_once_where_one_was_asked_for(self) -> None:
        for _ in range(3):
            with Arena(self.world, program=PROGRAM, web=0) as arena:
                page = arena.page
                self.assertRegex(page or "", r"^http://127\.0\.0\.1:\d+/$")
                self.assertEqual(arena.page, page)
        with Arena(self.world, program=PROGRAM) as arena:
            self.assertIsNone(arena.page)

    def test_columns_have_a_row_per_robot_and_change_with_a_step(self) -> None:
        with Arena(self.world, program=PROGRAM) as arena:
            self.assertEqual((arena.agents, arena.beams, arena.interval), (ROBOTS, BEAMS, 0.1))
            self.assertEqual(arena.ranges.dtype, np.float32)
            self.assertTrue((arena.range_max == 8).all())
            before = arena.pose.copy()
            arena.actions[:] = (0.5, 0.0, 0.2)
            arena.step(3)
            self.assertEqual(arena.tick, 3)
            self.assertAlmostEqual(arena.time, 0.3)
            moved = np.hypot(*(arena.pose - before)[:, :2].T)
            np.testing.assert_allclose(moved, 0.15, atol=0.01)
            self.assertTrue(np.allclose(arena.velocity, (0.5, 0.0, 0.2), atol=1e-6))
            self.assertTrue((arena.ranges > 0).all() and (arena.ranges <= 8).all())

    def test_an_agent_that_is_reset_stands_at_a_place_of_the_start_that_nobody_is_at(self) -> None:
        with Arena(self.world, program=PROGRAM) as arena:
            starts = arena.pose.copy()
            for _ in range(30):
                arena.actions[:] = (0.3, 0.0, 0.3)
                arena.step()
            arena.reset_mask[3] = True
            arena.step()
            self.assertIn(tuple(arena.pose[3]), set(map(tuple, starts)))
            self.assertEqual(tuple(arena.velocity[3]), (0, 0, 0))
            self.assertFalse(arena.reset_mask.any())
            others = np.delete(arena.pose, 3, axis=0)
            self.assertGreater(np.hypot(*(others - arena.pose[3])[:, :2].T).min(), 0.4)

    def test_a_start_has_everybody_at_another_place_by_the_seed(self) -> None:
        with Arena(self.world, program=PROGRAM) as arena:
            arena.start_again(7)
            first = arena.pose.copy()
            self.assertEqual(len(set(map(tuple, first))), ROBOTS)
            arena.step(5)
            arena.start_again(8)
            self.assertFalse(np.array_equal(arena.pose, first))
            arena.start_again(7)
            np.testing.assert_array_equal(arena.pose, first)
            self.assertEqual(arena.tick, 1)

    def test_ticks_and_seeds_are_whole_numbers(self) -> None:
        with Arena(self.world, program=PROGRAM) as arena:
            for ticks in (0, -1, 2.5, 2**20 + 1, "1", None):
                with self.assertRaisesRegex(ValueError, "ticks: a whole number from 1 to 1048576 is expected, not "):
                    arena.step(ticks)  # type: ignore[arg-type]
            with self.assertRaisesRegex(TypeError, "'float' object cannot be interpreted as an integer"):
                arena.start_again(1.5)  # type: ignore[arg-type]
            arena.start_again(np.int64(1))
            arena.step(np.int64(2))
            self.assertEqual(arena.tick, 3)

    def test_what_is_wrong_is_told_in_a_line(self) -> None:
        pathlib.Path(self.world).write_text('position( name "r0" )')
        with self.assertRaisesRegex(ArenaError, "no robot of this world has a range finder"):
            Arena(self.world, program=PROGRAM)
        with self.assertRaisesRegex(ArenaError, "nowhere.world"):
            Arena("nowhere.world", program=PROGRAM)
        with self.assertRaisesRegex(ArenaError, "cannot start"):
            Arena(self.world, program="/no/such/program")

    def test_memory_of_another_format_is_refused(self) -> None:
        head = struct.pack("<8sIIQ40s", b"plhsgym\0", 9, 0, 64, b"0.9.0 (abc1234)")
        with self.assertRaisesRegex(ArenaError, r"the program, 0\.9\.0 \(abc1234\), shares memory of format 9; this package reads format 1"):
            _columns_in(head)

    def test_the_end_of_the_program_is_noticed(self) -> None:
        arena = Arena(self.world, program=PROGRAM)
        arena._process.send_signal(signal.SIGKILL)
        with self.assertRaisesRegex(ArenaError, r"^the program has ended by signal 9 \(SIGKILL\)$"):
            arena.step()
        with self.assertRaisesRegex(ArenaError, "closed"):
            arena.step()

    def test_what_the_program_said_last_is_a_reason_only_if_it_is_an_error(self) -> None:
        program = pathlib.Path(self.world).with_name("program")
        for script, told in (
            ("echo 'Player clients: 127.0.0.1:1' >&2; exit 3", "the program has ended with code 3"),
            ("echo 'a.world:1: error: what' >&2; echo more >&2; exit 2",
             "the program has ended with code 2: a.world:1: error: what"),
            ("echo 'error: --seed: why' >&2; kill -ABRT $$",
             "the program has ended by signal 6 (SIGABRT): error: --seed: why"),
            ("kill -40 $$", "the program has ended by signal 40"),
        ):
            program.write_text(f"#!/bin/sh\n{script}\n")
            program.chmod(0o755)
            with self.assertRaisesRegex(ArenaError, f"^{re.escape(told)}$"):
                Arena(self.world, program=str(program))

    def test_the_program_ends_with_whoever_started_it_and_leaves_no_memory_behind(self) -> None:
        before = set(os.listdir("/dev/shm"))
        script = (
            f"import sys; sys.path.insert(0, {str(ROOT / 'clients/python')!r})\n"
            "from playhouse_gym import Arena\n"
            f"arena = Arena({self.world!r}, program={PROGRAM!r})\n"
            "print(arena._process.pid, flush=True)\n"
            "sys.stdin.read()\n"
        )
        child = subprocess.Popen([sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert child.stdout is not None
        program = int(child.stdout.readline())
        end = os.pidfd_open(program)
        self.addCleanup(os.close, end)
        child.kill()
        child.communicate()
        wait_for_any([end], "ended")
        self.assertEqual(set(os.listdir("/dev/shm")), before)


@needed
class WithoutNumpy(unittest.TestCase):
    def test_the_import_says_what_to_install(self) -> None:
        code = "import sys; sys.modules['numpy'] = None; import playhouse_gym"
        done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "clients/python", capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.splitlines()[-1],
                         "ModuleNotFoundError: playhouse_gym needs numpy: apt install python3-numpy, or pip install numpy")


class Recorded(WithWorld):
    def record(self, file: pathlib.Path) -> np.ndarray:
        """Three episodes, of which one begins anew with another seed and one agent is put elsewhere in another."""
        with Arena(self.world, program=PROGRAM, record=file, seed=3) as arena:
            for step in range(40):
                arena.actions[:] = (0.4, 0.0, 0.1 * (step % 5))
                arena.reset_mask[2] = step == 25
                arena.step()
                if step == 15:
                    arena.start_again(9)
            return arena.pose.copy()

    def again(self, file: pathlib.Path) -> Dict[str, object]:
        command = [PROGRAM, "run", "--again", str(file), "--json"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=HANG)
        self.assertEqual(done.returncode, 0, done.stderr)
        return cast(Dict[str, object], json.loads(done.stdout))

    def test_what_a_learning_program_did_runs_again_to_the_bit(self) -> None:
        file = pathlib.Path(self.world).parent / "run.mcap"
        poses = self.record(file)
        again = self.again(file)
        self.assertEqual(again["ticks"], 25)  # since the new start
        alone = file.with_name("alone.mcap")
        np.testing.assert_array_equal(self.record(alone), poses)
        self.assertEqual(self.again(alone)["hash"], again["hash"])

    def test_a_recording_changes_nothing_that_robots_do(self) -> None:
        ways = []
        for record in (None, pathlib.Path(self.world).parent / "run.mcap"):
            with Arena(self.world, program=PROGRAM, record=record) as arena:
                arena.actions[:] = (0.4, 0.0, 0.3)
                arena.step(20)
                ways.append((arena.pose.copy(), arena.ranges.copy()))
        for one, other in zip(*ways):
            np.testing.assert_array_equal(one, other)

    def test_a_file_that_cannot_be_written_is_told_in_a_line(self) -> None:
        with self.assertRaisesRegex(ArenaError, "no_such/run.mcap"):
            Arena(self.world, program=PROGRAM, record=pathlib.Path(self.world).parent / "no_such" / "run.mcap")

    def test_a_recording_whose_program_was_ended_is_told_at_the_end(self) -> None:
        arena = Arena(self.world, program=PROGRAM, record=pathlib.Path(self.world).with_name("run.mcap"))
        arena._process.kill()
        with self.assertRaisesRegex(ArenaError, r"run.mcap is not whole: the program has ended by signal 9 \(SIGKILL\)$"):
            arena.close()

    def test_a_recording_that_stops_half_way_is_told_at_the_end(self) -> None:
        file = pathlib.Path(self.world).with_name("run.mcap")
        full = file.with_name("full")  # the program on a disk of 64 KiB
        full.write_text(f"#!/bin/bash\ntrap '' XFSZ\nulimit -f 64\nexec {shlex.quote(PROGRAM)} \"$@\"\n")
        full.chmod(0o755)
        arena = Arena(self.world, program=str(full), record=file)
        arena.actions[:] = (0.4, 0.0, 0.3)
        arena.step(500)
        with self.assertRaisesRegex(ArenaError, "run.mcap is not whole: .*File too large"):
            arena.close()
        arena.close()


@needed
class OfGymnasium(WithWorld):
    """What https://gymnasium.farama.org/api/vector/ says of VectorEnv, with autoreset of the next step."""

    def test_spaces_are_those_of_one_and_of_all(self) -> None:
        env = self.vector_env()
        self.assertEqual(env.num_envs, ROBOTS)
        self.assertEqual(env.single_observation_space.shape, (BEAMS,))
        self.assertEqual(env.observation_space.shape, (ROBOTS, BEAMS))
        self.assertEqual(env.single_action_space.shape, (3,))
        self.assertEqual(env.action_space.shape, (ROBOTS, 3))
        self.assertIn("autoreset_mode", env.metadata)
        self.assertIs(env.unwrapped, env)

    def test_reset_and_step_give_arrays_of_all_within_their_spaces(self) -> None:
        env = self.vector_env()
        observations, infos = env.reset(seed=3)
        self.assertIn(observations, env.observation_space)
        self.assertIsInstance(infos, dict)
        env.action_space.seed(3)
        for _ in range(20):
            observations, rewards, terminations, truncations, infos = env.step(env.action_space.sample())
            self.assertIn(observations, env.observation_space)
            for values in (rewards, terminations, truncations):
                self.assertEqual(values.shape, (ROBOTS,))
            self.assertEqual((terminations.dtype, truncations.dtype), (np.bool_, np.bool_))
            self.assertIsInstance(infos, dict)

    def test_who_is_through_begins_with_the_next_step_whatever_its_action_is(self) -> None:
        env = self.vector_env(max_steps=4, terminated=lambda arena: np.arange(ROBOTS) == 2 if arena.tick == 3 else
                              np.zeros(ROBOTS, bool))
        env.reset(seed=1)
        action = np.tile(np.float32((0.2, 0, 0)), (ROBOTS, 1))
        told = [env.step(action) for _ in range(6)]
        self.assertEqual([bool(step[2][2]) for step in told], [False, True, False, False, False, False])
        self.assertEqual([bool(step[3][2]) for step in told], [False, False, False, False, False, False])
        self.assertEqual([bool(step[3][0]) for step in told], [False, False, False, True, False, False])
        self.assertEqual((told[2][1][2], told[4][1][0]), (0, 0), "the reward of a reset")
        self.assertNotEqual(told[3][1][2], 0)

    def test_the_same_seed_and_actions_give_the_same_bits_with_any_number_of_workers(self) -> None:
        def episode(workers: int):
            env = self.vector_env(workers=workers, max_steps=15)
            seen = [env.reset(seed=5)[0]]
            random = np.random.default_rng(1)
            for _ in range(60):
                actions = random.uniform(-1, 1, (ROBOTS, 3)).astype(np.float32)
                observations, rewards, terminations, truncations, _ = env.step(actions)
                seen += [observations, rewards, terminations, truncations, env.arena.pose.copy()]
            seen.append(env.reset(seed=6)[0])
            seen.append(env.reset()[0])
            return seen

        first = episode(1)
        for again in (episode(1), episode(2)):
            for one, other in zip(first, again):
                self.assertEqual(one.tobytes(), other.tobytes())

    def test_copies_stay_and_views_change(self) -> None:
        for copy in (True, False):
            env = self.vector_env(copy=copy)
            env.reset(seed=1)
            action = np.tile(np.float32((0.5, 0, 0)), (ROBOTS, 1))
            seen = env.step(action)[0]
            before = seen.copy()
            env.step(action)
            self.assertEqual(np.array_equal(seen, before), copy)

    def test_rewards_that_are_columns_of_the_arena_are_copies_too(self) -> None:
        for copy in (True, False):
            env = self.vector_env(copy=copy, reward=lambda arena, before: arena.velocity[:, 0])
            env.reset(seed=1)
            seen = env.step(np.tile(np.float32((0.5, 0, 0)), (ROBOTS, 1)))[1]
            before = seen.copy()
            env.step(np.zeros((ROBOTS, 3), np.float32))
            self.assertEqual(np.array_equal(seen, before), copy)

    def test_the_seed_of_the_constructor_is_that_of_a_reset_without_one(self) -> None:
        def places(seed: int) -> bytes:
            env = self.vector_env(seed=seed)
            env.reset()
            return env.arena.pose.tobytes()

        self.assertEqual(places(3), places(3))
        self.assertNotEqual(places(3), places(4))

    def test_the_seed_none_is_none_at_all(self) -> None:
        def places() -> bytes:
            env = self.vector_env(seed=None)
            env.reset()
            return env.arena.pose.tobytes()

        self.assertNotEqual(places(), places())
        with Arena(self.world, program=PROGRAM, seed=None) as one, Arena(self.world, program=PROGRAM) as other:
            for arena in (one, other):
                arena.step(3)
            np.testing.assert_array_equal(one.ranges, other.ranges)

    def test_what_could_not_be_made_is_closed(self) -> None:
        self.assertTrue(VectorEnv.__new__(VectorEnv).closed, "Gymnasium's __del__ closes what is not")
        self.assertFalse(self.vector_env().closed)

    def test_arguments_that_cannot_be_are_told_by_their_names(self) -> None:
        for wrong, why in (
            ({"max_action": (1, 1)}, r"max_action: real numbers of shape \(3,\) are expected, not int64 of shape \(2,\)"),
            ({"max_action": 1}, r"max_action: real numbers of shape \(3,\)"),
            ({"max_action": (-1, 0, 1)}, r"max_action: finite numbers from 0 on are expected, not \(-1, 0, 1\)"),
            ({"max_action": (1, 0, np.inf)}, "max_action: finite numbers"),
            ({"max_action": (1, 0, np.nan)}, "max_action: finite numbers"),
            ({"max_action": (1, 0, 1e39)}, "max_action: finite numbers"),  # float32 has none such
            ({"ticks": -1}, "ticks: a whole number from 1 to 1048576 is expected, not -1"),
            ({"ticks": 2.5}, "ticks: a whole number from 1 to 1048576 is expected, not 2.5"),
            ({"max_steps": 0}, "max_steps: a whole number from 1 to .* is expected, not 0"),
            ({"max_steps": 2.5}, "max_steps: a whole number from 1 to .* is expected, not 2.5"),
        ):
            for make in (VectorEnv, ParallelEnv):
                with self.assertRaisesRegex(ValueError, why):
                    make(self.world, program=PROGRAM, **wrong)

    def test_an_environment_that_cannot_be_made_leaves_no_program_behind(self) -> None:
        arenas: list = []
        try:
            self.vector_env(observe=arenas.append)
        except ValueError:  # whose traceback has the environment
            self.assertIsNotNone(arenas[0]._process.poll())
        self.assertEqual(len(arenas), 1)

    def test_observations_of_any_type_have_a_space(self) -> None:
        for observe in (
            lambda arena: arena.pose, lambda arena: arena.velocity[:, 0], lambda arena: arena.stalled[:, np.newaxis],
            lambda arena: (100 * arena.ranges).astype(np.int32), lambda arena: (9 * arena.ranges).astype(np.uint8),
        ):
            env = self.vector_env(observe=observe)
            self.assertIn(env.reset(seed=1)[0], env.observation_space)
            self.assertIn(env.observation_space.sample(), env.observation_space)

    def test_what_functions_return_has_a_row_for_each_robot(self) -> None:
        def of(rows: int):
            return lambda arena, *_: np.zeros((rows, 2))

        for observe in (of(ROBOTS - 1), lambda arena: 1.0):
            with self.assertRaisesRegex(ValueError, f"observe: an array with {ROBOTS} rows is expected, not one of shape "):
                self.vector_env(observe=observe)
        env = self.vector_env(observe=lambda arena: np.zeros((ROBOTS, 3 if arena.tick == 2 else 4)))
        env.reset(seed=1)
        with self.assertRaisesRegex(ValueError, rf"observe: .* of shape \({ROBOTS}, 4\) .*, not .* \({ROBOTS}, 3\)"):
            env.step(np.zeros((ROBOTS, 3)))
        for name in ("reward", "terminated"):
            for function in (of(ROBOTS), lambda *_: 0.0, lambda *_: np.zeros(1), lambda *_: ["?"] * ROBOTS):
                env = self.vector_env(**{name: function})
                env.reset(seed=1)
                with self.assertRaisesRegex(ValueError, rf"{name}: real numbers of shape \({ROBOTS},\) are expected, not "):
                    env.step(np.zeros((ROBOTS, 3)))

    def test_actions_are_a_row_of_three_real_numbers_for_each_robot(self) -> None:
        env = self.vector_env()
        env.reset(seed=1)
        wanted = re.escape(f"actions: real numbers of shape ({ROBOTS}, 3) are expected, not ")
        for actions, given in (
            (np.zeros(3), "float64 of shape (3,)"), (np.zeros((1, 3)), "float64 of shape (1, 3)"),
            (np.zeros((ROBOTS, 1)), f"float64 of shape ({ROBOTS}, 1)"), (1.0, "float64 of shape ()"),
            (np.zeros((ROBOTS - 1, 3)), f"float64 of shape ({ROBOTS - 1}, 3)"),
            (np.ones((ROBOTS, 3), complex), f"complex128 of shape ({ROBOTS}, 3)"),
            ([["1", "0", "0"]] * ROBOTS, f"<U1 of shape ({ROBOTS}, 3)"), (None, "object of shape ()"),
            ([[1, 0, 0]] * (ROBOTS - 1) + [[1, 0]], ""),
        ):
            with self.assertRaisesRegex(ValueError, wanted + re.escape(given)):
                env.step(actions)
        for actions in ([[1, 0, 0]] * ROBOTS, np.ones((ROBOTS, 3), np.int64), np.ones((ROBOTS, 3), np.float16)):
            env.reset(seed=1)
            env.step(actions)
            self.assertTrue(np.allclose(env.arena.velocity[:, 0], 1.0))

    def test_a_step_before_a_reset_and_after_the_close_is_an_error(self) -> None:
        env = self.vector_env()
        with self.assertRaisesRegex(RuntimeError, "reset"):
            env.step(np.zeros((ROBOTS, 3)))
        env.reset()
        env.close()
        env.close()
        with self.assertRaises(ArenaError):
            env.step(np.zeros((ROBOTS, 3)))


@needed
class OfPettingZoo(WithWorld):
    """What https://pettingzoo.farama.org/api/parallel/ and the facts that its parallel_api_test checks say."""

    def env(self, **more: object) -> ParallelEnv:
        env = ParallelEnv(self.world, program=PROGRAM, **more)
        self.addCleanup(env.close)
        return env

    def test_agents_have_spaces_of_their_own_that_stay(self) -> None:
        env = self.env()
        self.assertEqual(len(env.possible_agents), ROBOTS)
        self.assertEqual(env.max_num_agents, ROBOTS)
        for agent in env.possible_agents:
            self.assertIs(env.observation_space(agent), env.observation_space(agent))
            self.assertIs(env.action_space(agent), env.action_space(agent))
        self.assertIn("name", env.metadata)
        self.assertIn("render_modes", env.metadata)

    def test_a_cycle_of_episodes(self) -> None:
        env = self.env(max_steps=12)
        for agent in env.possible_agents:
            env.action_space(agent).seed(1)
        for _ in range(3):
            observations, infos = env.reset(seed=2)
            self.assertEqual(env.agents, env.possible_agents)
            self.assertEqual(set(observations), set(env.agents))
            self.assertEqual(set(infos), set(env.agents))
            gone: set = set()
            while env.agents:
                live = list(env.agents)
                told = env.step({agent: env.action_space(agent).sample() for agent in live})
                for values in told:
                    self.assertEqual(set(values), set(live))
                observations, rewards, terminations, truncations, infos = told
                for agent in live:
                    self.assertIn(observations[agent], env.observation_space(agent))
                    self.assertIsInstance(rewards[agent], float)
                over = {agent for agent in live if terminations[agent] or truncations[agent]}
                self.assertEqual(set(env.agents), set(live) - over)
                gone |= over
                self.assertFalse(gone & set(env.agents))
            self.assertEqual(gone, set(env.possible_agents))
        self.assertIn(env.state(), env.state_space)
        self.assertIn(env.state_space.sample(), env.state_space)

    def test_the_same_seed_is_the_same_episode(self) -> None:
        def episode():
            env = self.env(max_steps=20)
            seen = [env.reset(seed=9)[0]]
            while env.agents:
                seen.append(env.step({agent: np.float32((0.6, 0, 0.4)) for agent in env.agents})[0])
            return [{agent: values.tobytes() for agent, values in each.items()} for each in seen]

        self.assertEqual(episode(), episode())

    def test_an_action_that_cannot_be_done_is_an_error_with_its_agent(self) -> None:
        env = self.env()
        env.reset(seed=1)
        fine = np.float32((1, 0, 0))
        for action in ([1, 0], 1.0, [[1, 0, 0]], [1, 0, 0j], ["1", "0", "0"], None):
            with self.assertRaisesRegex(ValueError, r"the action of robot_1: real numbers of shape \(3,\) are expected"):
                env.step({"robot_0": fine, "robot_1": action})
        with self.assertRaisesRegex(ValueError, f"there is no agent 'nobody': .*robot_0 to robot_{ROBOTS - 1}"):
            env.step({"robot_0": fine, "nobody": fine})
        self.assertEqual(env.arena.tick, 1, "nobody has moved")

    def test_actions_of_agents_whose_episode_has_ended_are_ignored(self) -> None:
        env = self.env(terminated=lambda arena: np.arange(ROBOTS) == 2)
        env.reset(seed=1)
        actions = dict.fromkeys(env.possible_agents, np.float32((0.2, 0, 0)))
        env.step(actions)
        self.assertNotIn("robot_2", env.agents)
        for action in (actions["robot_2"], None):
            observations = env.step({**actions, "robot_2": action})[0]
            self.assertNotIn("robot_2", observations)
            self.assertEqual(tuple(env.arena.velocity[2]), (0, 0, 0))

    def test_their_own_test(self) -> None:
        try:
            from pettingzoo.test import parallel_api_test
        except ImportError:
            self.skipTest("there is no pettingzoo")
        parallel_api_test(self.env(max_steps=50), num_cycles=200)


@needed
class Examples(WithWorld):
    def run_example(self, name: str, *arguments: str) -> "subprocess.CompletedProcess[str]":
        command = [sys.executable, str(ROOT / "examples" / "gym" / name), *arguments]
        environment = {**os.environ, "PLAYHOUSE_PROGRAM": PROGRAM}
        return subprocess.run(command, capture_output=True, text=True, timeout=HANG, env=environment)

    def assert_refused(self, name: str, arguments: Sequence[str], why: str) -> None:
        done = self.run_example(name, *arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, rf"\n{name}: error: {re.escape(why)}.*\n$")
        self.assertNotIn("Traceback", done.stderr)

    def test_one_learns_with_any_number_of_robots_from_two_on_and_draws_its_curve(self) -> None:
        svg = pathlib.Path(self.world).with_name("curve.svg")
        for robots in ("2", "5"):
            done = self.run_example("learn.py", "--robots", robots, "--generations", "2", "--steps", "3", "--svg", str(svg))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertRegex(done.stdout, rf"generation   2: .*\n{robots} robots, 2 generations of 6 steps in ")
            self.assertTrue(svg.read_text().endswith("</svg>\n"))

    def test_what_is_wrong_is_told_in_a_line_before_it_learns(self) -> None:
        folder = str(pathlib.Path(self.world).parent)
        for arguments, why in (
            (("--robots", "1"), 'argument --robots: a whole number from 2 on is expected, not "1"'),
            (("--robots=-3",), 'argument --robots: a whole number from 2 on is expected, not "-3"'),
            (("--robots", "2.5"), 'argument --robots: a whole number from 2 on is expected, not "2.5"'),
            (("--generations", "0"), 'argument --generations: a whole number from 1 on is expected, not "0"'),
            (("--steps", "0"), 'argument --steps: a whole number from 1 on is expected, not "0"'),
            (("--seed=-1",), 'argument --seed: a whole number from 0 on is expected, not "-1"'),
            (("--workers", "0"), 'argument --workers: a whole number from 1 to 1024 is expected, not "0"'),
            (("--web", "65536"), 'argument --web: a whole number from 0 to 65535 is expected, not "65536"'),
            (("--svg", folder), f"argument --svg: {folder} cannot be written: Is a directory"),
            (("--svg", f"{folder}/no/x.svg"), f"argument --svg: {folder}/no/x.svg cannot be written: No such file or"),
        ):
            self.assert_refused("learn.py", arguments, why)

    def test_one_measures_the_rate_of_what_can_be_measured(self) -> None:
        self.assert_refused("rate.py", ("--robots", "0"), 'argument --robots: a whole number from 1 on is expected, not "0"')
        self.assert_refused("rate.py", ("--beams", "2"), 'argument --beams: a whole number from 3 on is expected, not "2"')
        done = self.run_example("rate.py", "--robots", "1", "--beams", "3", "--seconds", "1")
        self.assertRegex(done.stdout, r"^1 robots, 3 beams, 1 workers: [0-9.]+ steps/s, \d+ agent-steps/s\n$")


class Spaces(unittest.TestCase):
    def test_samples_are_inside_and_other_shapes_are_not(self) -> None:
        box = Box(np.float32((-1, 0)), np.float32((1, 2)), dtype=np.float32)
        box.seed(4)
        for _ in range(50):
            self.assertIn(box.sample(), box)
        self.assertNotIn(np.float32((0, 3)), box)
        self.assertNotIn(np.float32((0, 1, 1)), box)
        few = Discrete(3)
        few.seed(1)
        self.assertEqual({int(few.sample()) for _ in range(100)}, {0, 1, 2})
        self.assertNotIn(np.int64(3), few)

    def test_samples_of_unbounded_values_spread_to_the_open_sides(self) -> None:
        low, high = np.float64((-np.inf, 3, -np.inf, 3)), np.float64((np.inf, np.inf, -3, 4))
        for dtype in (np.float32, np.float64):
            box = Box(low, high, dtype=dtype)
            box.seed(2)
            samples = np.array([box.sample() for _ in range(4000)])
            self.assertEqual(samples.dtype, dtype)
            self.assertTrue(all(sample in box for sample in samples))
            np.testing.assert_allclose(samples.mean(axis=0), (0, 4, -4, 3.5), atol=0.1)
            np.testing.assert_allclose(samples.std(axis=0), (1, 1, 1, 12**-0.5), atol=0.1)

    def test_samples_of_whole_numbers_reach_both_bounds(self) -> None:
        box = Box(-1, 2, (4,), np.int64)
        box.seed(1)
        self.assertEqual(set(np.concatenate([box.sample() for _ in range(50)])), {-1, 0, 1, 2})

    def test_the_same_seed_gives_the_same_samples(self) -> None:
        boxes = [Box(0.0, 1.0, (4,)) for _ in range(2)]
        for box in boxes:
            box.seed(11)
        np.testing.assert_array_equal(boxes[0].sample(), boxes[1].sample())


if __name__ == "__main__":
    unittest.main()
