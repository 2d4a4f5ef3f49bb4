#!/usr/bin/env python3
"""Drives straight to the goal and gives way to people ahead. See PROTOCOL.md."""
import json
import math
import sys


def command(robot, seen):
    limits, pose = robot["limits"], seen["pose"]
    x, y = seen["goal"][0] - pose["x"], seen["goal"][1] - pose["y"]
    turn = math.remainder(math.atan2(y, x) - pose["heading"], math.tau)
    speed = min(limits["max_vel"], math.sqrt(limits["max_acc"] * math.hypot(x, y)))
    for body in seen["bodies"]:
        bx, by = body["position"][0] - pose["x"], body["position"][1] - pose["y"]
        side = math.remainder(math.atan2(by, bx) - pose["heading"], math.tau)
        gap = math.hypot(bx, by) - body["radius"] - robot["radius"]
        if abs(side) < math.pi / 3 and gap < 1.5:
            speed = min(speed, limits["max_vel"] * max(0.0, gap - 0.5))
    omega = max(-limits["max_omega"], min(limits["max_omega"], 2.0 * turn))
    return {"linear": speed if abs(turn) < 0.5 else 0.0, "angular": omega,
            "path": [[pose["x"], pose["y"]], seen["goal"]]}


robot = json.loads(sys.stdin.readline())["robot"]
print(json.dumps({"ready": True, "name": "follow"}), flush=True)
for line in sys.stdin:
    seen = json.loads(line)
    if "end" in seen:
        break
    print(json.dumps(command(robot, seen)), flush=True)
