#!/usr/bin/env python3
"""Recomputes certificates from trajectories: recompute.py PROGRAM CERTIFICATE…

Repeats each run of a certificate with PROGRAM, reads trajectory.csv, events.csv and trace.json, and
compares mean and 95 % interval of two metrics with those of the certificate. Shares no code with the
program. Exit code 1: a number differs by more than 1e-6.
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile


def student_quantile(p, freedom):
    """Quantile of Student's t distribution, by Simpson's rule and bisection."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2))
    scale /= math.sqrt(freedom * math.pi)

    def below(x, parts=2000):
        h = x / parts
        total = 0.0
        for k in range(parts + 1):
            weight = 1 if k in (0, parts) else 4 if k % 2 else 2
            total += weight * (1 + (k * h) ** 2 / freedom) ** (-(freedom + 1) / 2)
        return 0.5 + scale * total * h / 3

    low, high = 0.0, 200.0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if below(middle) < p else (low, middle)
    return (low + high) / 2


def interval(values):
    """Mean and its 95 % interval."""
    n = len(values)
    mean = math.fsum(values) / n
    deviation = math.sqrt(math.fsum((v - mean) ** 2 for v in values) / (n - 1))
    width = student_quantile(0.975, n - 1) * deviation / math.sqrt(n)
    return mean, mean - width, mean + width


def rows(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8", newline="") as file:
        yield from csv.DictReader(file)


def smallest_distance(folder, trace):
    """Between the surfaces of the first robot and people, over all samples."""
    radius = {body["id"]: body["radius"] for body in trace["humans"] + trace["robots"]}
    robot, people, least = {}, {}, math.inf
    for row in rows(folder, "trajectory.csv"):
        at = (float(row["x"]), float(row["y"]))
        if row["kind"] == "robot" and row["id"] == "-1":
            robot[row["step"]] = at
        elif row["kind"] == "human":
            people.setdefault(row["step"], []).append((int(row["id"]), at))
    for step, (x, y) in robot.items():
        for number, (px, py) in people.get(step, []):
            size = radius.get(number, 0.2) + radius[-1]  # people of sources have the usual radius
            least = min(least, math.hypot(px - x, py - y) - size)
    return max(least, 0.0) if least < math.inf else None


def arrival(folder):
    for row in rows(folder, "events.csv"):
        if row["kind"] == "arrived" and row["id"] == "-1":
            return float(row["time"])
    return None


def recompute(program, path):
    with open(path, encoding="utf-8") as file:
        certificate = json.load(file)
    scenario = path.replace(".certificate.json", ".yaml")
    worst = 0.0
    for metric in certificate["metrics"]:
        if metric["key"] not in ("minimum_distance_to_people", "time_to_reach_goal"):
            continue
        for arm in metric["planners"]:
            values = []
            for seed in certificate["seeds"]:
                with tempfile.TemporaryDirectory() as folder:
                    subprocess.run([program, "run", scenario, "--planner", arm["planner"], "--seed",
                                    str(seed), "--quiet", "-o", folder], check=True,
                                   stdout=subprocess.DEVNULL)
                    with open(os.path.join(folder, "trace.json"), encoding="utf-8") as file:
                        trace = json.load(file)
                    value = (arrival(folder) if metric["key"] == "time_to_reach_goal"
                             else smallest_distance(folder, trace))
                    values += [] if value is None else [value]
            if len(values) != arm["runs"]:
                worst = math.inf
                print(f"{path}: {metric['key']} of {arm['planner']}: {len(values)} runs")
            elif len(values) > 1:
                found = interval(values)
                stored = (arm["mean"], arm["low"], arm["high"])
                worst = max(worst, *(abs(a - b) for a, b in zip(found, stored)))
    print(f"{certificate['scenario']}: largest difference {worst:.2g}")
    return worst


def main():
    program, *certificates = sys.argv[1:]
    sys.exit(1 if max(recompute(program, path) for path in certificates) > 1e-6 else 0)


if __name__ == "__main__":
    main()
