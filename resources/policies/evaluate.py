#!/usr/bin/env python3
"""Compares policies and planners on seeds that the training has not seen, and prints a table.

    evaluate.py --policies crossing_policy.onnx --planners orca pursuit --scenes crossing_agents

A run ends with the robot's arrival, its first contact with a person or obstacle, or after 60 s.
`--csv` keeps one row per run.
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy

import hunavsim
from hunavsim.env import CrowdVectorEnv

sys.path.insert(0, str(Path(__file__).resolve().parent))
from onnx_reader import Policy
from worlds import seed_of

DURATION = 60.0  # [s]
INTERVAL = 0.2  # [s] between two measurements of the distance to the nearest person

_environments = {}  # by scenario and policy


def scenario_of(name):
    """The scenario; its people vary with the seed as in the training."""
    scenario = hunavsim.Scenario(name)
    if scenario.get("variation") is None:
        scenario.set("variation.preset", "light")
    return scenario


def drive_planner(scenario, planner, seed):
    """(outcome, time [s], smallest distance between the centres of robot and people [m])."""
    simulation = hunavsim.Simulation(scenario, seed=seed, planner=planner, duration=DURATION)
    count, nearest = max(1, round(INTERVAL / simulation.dt)), numpy.inf
    while simulation.time < DURATION - 1e-9:
        simulation.step(count)
        rows = simulation.state
        robot, people = rows[rows["id"] == -1][0], rows[rows["id"] >= 0]
        if len(people):
            nearest = min(nearest, numpy.hypot(people["x"] - robot["x"],
                                               people["y"] - robot["y"]).min())
        for event in simulation.take_events():
            if event["kind"] == "contact" and -1 in (event["id"], event["other"]):
                return "collided", simulation.time, nearest
            if event["kind"] == "arrived" and event["id"] == -1:
                return "arrived", simulation.time, nearest
    return "timed_out", DURATION, nearest


def drive_policy(scenario, policy, seed):
    """As drive_planner."""
    settings = policy.settings
    key = id(scenario), id(policy)
    if key not in _environments:
        _environments[key] = CrowdVectorEnv(
            1, scenario, variation=None, duration=DURATION,
            **{name: settings[name] for name in ("people", "beams", "repeat")})
    environment = _environments[key]
    observations, _ = environment.reset(seed=seed_of(seed))
    nearest, steps = numpy.inf, 0
    while True:
        observations, _, ended, cut, infos = environment.step(policy(observations))
        steps += 1
        people = observations["people"][0]
        people = people[people[:, 4] > 0]
        if len(people):
            nearest = min(nearest, float(numpy.hypot(people[0, 0], people[0, 1])))
        if ended[0] or cut[0]:
            time = steps * settings["repeat"] * environment._core.dt
            return infos["outcome"][0], time, nearest


def summary(rows):
    """Cells of the table for the runs of one driver in one scene."""
    arrived = [row for row in rows if row[0] == "arrived"]
    count = len(rows)
    low, high = hunavsim.rate_interval(len(arrived), count)
    contacts = sum(row[0] == "collided" for row in rows)
    time = numpy.mean([row[1] for row in arrived]) if arrived else numpy.nan
    near = numpy.mean([row[2] for row in rows])
    return (f"{len(arrived)}/{count} ({100 * low:.0f}–{100 * high:.0f} %) | {contacts} | "
            f"{count - len(arrived) - contacts} | {time:.1f} | {near:.2f}")


def main():
    """Runs all and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--policies", nargs="*", type=Path, default=[])
    parser.add_argument("--planners", nargs="*", default=[])
    parser.add_argument("--scenes", nargs="+", required=True)
    parser.add_argument("--seeds", nargs=2, type=int, default=(1001, 1100),
                        metavar=("FIRST", "LAST"))
    parser.add_argument("--csv", type=Path, help="also write a row per run")
    options = parser.parse_args()
    drivers = [(path.stem, drive_policy, Policy(path)) for path in options.policies]
    drivers += [(name, drive_planner, name) for name in options.planners]
    seeds = range(options.seeds[0], options.seeds[1] + 1)
    runs = []
    print("| scene | driver | arrived (95 % interval) | contact | out of time | time [s] | "
          "nearest [m] |\n|---|---|---|---|---|---|---|")
    for scene in options.scenes:
        scenario = scenario_of(scene)
        for name, drive, driver in drivers:
            rows = [drive(scenario, driver, seed) for seed in seeds]
            runs += [(scene, name, seed, *row) for seed, row in zip(seeds, rows)]
            print(f"| {scene} | {name} | {summary(rows)} |", flush=True)
    if options.csv:
        with options.csv.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("scene", "driver", "seed", "outcome", "time", "nearest"))
            writer.writerows(runs)


if __name__ == "__main__":
    main()
