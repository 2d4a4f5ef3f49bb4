"""Runs: the same numbers as the program writes, progress, planners and behaviours in Python."""

import csv
import json
import math
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy

import hunavsim

EMPTY = """hunav_loader:
  ros__parameters:
    publish_people: true
    agents:
      - walker
    walker:
      id: 1
      max_vel: 1.0
      init_pose: {x: 0.0, y: 5.0, h: 0.0}
      goals: [1]
      behavior: {type: Regular}
    global_goals:
      1: {x: 50.0, y: 5.0}
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    robots: [robot1]
    robot1:
      start: {x: 0.0, y: 0.0, h: 0.0}
      goal: {x: 40.0, y: 0.0}
      max_vel: 1.0
      max_acc: 1.0
"""


def empty_plane():
    return hunavsim.Scenario.from_text(EMPTY)


class RunTest(unittest.TestCase):
    def test_equals_the_files_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            subprocess.run([os.environ["HUNAVSIM"], "run", "corner_cafe_agents", "-o", str(out),
                            "--seed", "3", "--duration", "10", "--planner", "dwa", "--quiet"],
                           check=True)
            run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), seed=3, duration=10.0,
                               planner="dwa")
            with open(out / "trajectory.csv") as file:
                rows = list(csv.DictReader(file))
            trajectory = run.trajectory
            self.assertEqual(len(rows), len(trajectory))
            for name in ("step", "time", "id", "x", "y", "heading", "vx", "vy", "omega"):
                written = numpy.array([float(row[name]) for row in rows])
                self.assertTrue((written == trajectory[name]).all(), name)
            stored = json.loads((out / "metrics.json").read_text())["metrics"]
            for key, value in run.metrics.items():
                if isinstance(value, float) and math.isfinite(value):
                    entry = stored[key]
                    number = entry["value"] if isinstance(entry, dict) else entry
                    self.assertEqual(number, value, key)
            loaded = hunavsim.load_run(str(out))
            self.assertTrue((loaded.trajectory["x"] == trajectory["x"]).all())
            loaded.evaluate(["path_length"])
            self.assertEqual(loaded.metrics["path_length"], run.metrics["path_length"])

    def test_output_is_a_run_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), duration=2.0,
                               output=str(out))
            self.assertEqual(run.status, "finished")
            self.assertTrue((out / "manifest.json").is_file())
            changed = hunavsim.Scenario("corner_cafe_agents")
            changed.set("seed", 1234)
            with self.assertRaises(ValueError):
                hunavsim.run(changed, duration=1.0, output=str(Path(folder) / "other"))

    def test_progress_can_stop_the_run(self):
        calls = []

        def progress(time, end):
            calls.append((time, end))
            return False

        run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), duration=3600.0,
                           progress=progress)
        self.assertEqual(run.status, "interrupted")
        self.assertEqual(len(calls), 1)
        self.assertEqual(calls[0][1], 3600.0)

    def test_exception_of_progress_is_raised(self):
        def progress(time, end):
            raise KeyError("stop")

        with self.assertRaises(KeyError):
            hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), duration=3600.0,
                         progress=progress)

    def test_planner_in_python_drives_the_robot(self):
        seen = []

        class Constant(hunavsim.Planner):
            def command(self, observation):
                seen.append((observation.time, observation.pose, observation.goal))
                return 0.5, 0.0

        run = hunavsim.run(empty_plane(), duration=10.0, planners={"robot1": Constant()})
        track = run.trajectory[run.trajectory["id"] == -1]
        # With 1 m/s² it reaches 0.5 m/s after 0.5 s, 0.125 m on; then 9.5 s at that speed. The
        # speed rises in steps of 0.05 s, each at its end: at most 0.05 * 0.5 m further.
        self.assertAlmostEqual(track["x"][-1], 0.125 + 9.5 * 0.5, delta=0.026)
        self.assertEqual(track["y"][-1], 0.0)
        self.assertEqual(seen[0][1], (0.0, 0.0, 0.0))
        self.assertEqual(seen[0][2], (40.0, 0.0))
        self.assertEqual(len(seen), 200)

    def test_observation_ends_with_the_call(self):
        kept = []

        def planner(observation):
            kept.append(observation)
            self.assertEqual(observation.path()[-1], (40.0, 0.0))
            return 0.0, 0.0

        hunavsim.run(empty_plane(), duration=0.1, planners={"robot1": planner})
        with self.assertRaises(ValueError):
            kept[0].pose

    def test_exception_of_a_planner_is_raised(self):
        def planner(observation):
            raise RuntimeError("broken")

        with self.assertRaisesRegex(RuntimeError, "broken"):
            hunavsim.run(empty_plane(), duration=5.0, planners={"robot1": planner})
        with self.assertRaises(ValueError):
            hunavsim.run(empty_plane(), duration=5.0, planners={"robot1": lambda o: (1.0,)})
        with self.assertRaisesRegex(ValueError, "robot7"):
            hunavsim.run(empty_plane(), duration=1.0, planners={"robot7": planner})

    def test_behavior_in_python_moves_the_person(self):
        def stand(person):
            self.assertEqual(person.id, 1)
            self.assertEqual(person.goals[0], (50.0, 5.0))
            return ("stand",)

        run = hunavsim.run(empty_plane(), duration=3.0, behaviors={"walker": stand})
        track = run.trajectory[run.trajectory["id"] == 1]
        self.assertEqual(set(track["x"]), {0.0})

        run = hunavsim.run(empty_plane(), duration=10.0,
                           behaviors={"walker": lambda person: ("walk", (0.0, 50.0), 0.8)})
        track = run.trajectory[run.trajectory["id"] == 1]
        self.assertAlmostEqual(track["x"][-1], 0.0, delta=0.05)
        self.assertGreater(track["y"][-1], 5.0 + 0.8 * 10.0 * 0.9)
        self.assertLess(track["y"][-1], 5.0 + 0.8 * 10.0)

    def test_behavior_none_keeps_the_tree(self):
        free = hunavsim.run(empty_plane(), duration=5.0)
        same = hunavsim.run(empty_plane(), duration=5.0, behaviors={"walker": lambda person: None})
        self.assertTrue((free.trajectory["x"] == same.trajectory["x"]).all())

    def test_events_and_names(self):
        run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), duration=5.0)
        self.assertEqual(run.events[-1]["kind"], "stop")
        self.assertEqual(run.events[-1]["text"], run.reason)
        self.assertEqual(run.names[-1], "robot1" if -1 in run.names else run.names.get(-1))
        self.assertEqual(run.map["cells"].ndim, 2)


class SimulationTest(unittest.TestCase):
    def test_steps_equal_the_run(self):
        run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), seed=5, duration=2.0)
        simulation = hunavsim.Simulation(hunavsim.Scenario("corner_cafe_agents"), seed=5,
                                         duration=2.0)
        simulation.step(40)
        self.assertEqual(simulation.time, 40 * simulation.dt)
        last = run.trajectory[run.trajectory["step"] == 40]
        self.assertTrue((simulation.state["x"] == last["x"]).all())

    def test_commands(self):
        simulation = hunavsim.Simulation(empty_plane())
        for _ in range(20):
            simulation.drive("robot1", 1.0, 0.0)
            simulation.step()
        moved = simulation.state
        self.assertAlmostEqual(moved["x"][moved["id"] == -1][0], 0.5, delta=0.03)  # a t² / 2
        simulation.move("walker", 3.0, 4.0, 1.0)
        simulation.hold("walker", True)
        simulation.step()
        state = simulation.state
        self.assertAlmostEqual(state["x"][state["id"] == 1][0], 3.0, delta=0.1)
        with self.assertRaises(hunavsim.ScenarioError):
            simulation.set_door("no_door", True)
            simulation.step()
        with self.assertRaises(ValueError):
            simulation.move("nobody", 0.0, 0.0, 0.0)


if __name__ == "__main__":
    unittest.main()
