"""Worlds of static clutter in the manner of BARN (Perille et al. 2020), with and without people."""

import random

from scene import Scene

SOURCE = ("Worlds in the manner of Perille et al. 2020, Benchmarking Metric Ground Navigation "
          "(BARN), generated for this program")
LENGTH, WIDTH, RADIUS = 10.0, 5.0, 0.55  # free disc that must find a way [m]
METRICS = ("time_to_reach_goal", "path_length", "minimum_distance_to_people", "success")


def is_open(circles, x, y):
    return (RADIUS <= y <= WIDTH - RADIUS
            and all((x - cx) ** 2 + (y - cy) ** 2 >= (r + RADIUS) ** 2 for cx, cy, r in circles))


def has_way(circles, step=0.1):
    """Whether a disc gets from the left end to the right end."""
    columns, rows = round((LENGTH + 4) / step), round(WIDTH / step)
    seen, waiting = set(), [(0, rows // 2)]
    while waiting:
        i, j = waiting.pop()
        if (i, j) in seen or not (0 <= i <= columns and 0 <= j <= rows):
            continue
        if not is_open(circles, i * step - 2.0, j * step):
            continue
        seen.add((i, j))
        if i * step - 2.0 > LENGTH + 1.0:
            return True
        waiting += [(i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)]
    return False


def world(number):
    """Circles of a world that has a way, denser with its number; none near both ends."""
    draw = random.Random(7919 * number)
    while True:
        circles = []
        for _ in range(8 + number // 2):
            circles.append((round(draw.uniform(0.3, LENGTH - 0.3), 2),
                            round(draw.uniform(0.2, WIDTH - 0.2), 2),
                            round(draw.uniform(0.12, 0.42), 2)))
        straight = all(abs(cy - WIDTH / 2) > r + 0.35 for _, cy, r in circles)
        if has_way(circles) and not straight:
            return circles


def clutter(number, people):
    kind = "people" if people else "static"
    level = "easy" if number < 11 else "normal" if number < 21 else "hard"
    s = Scene(f"clutter_{number:02d}_{kind}", f"Clutter {number}" + (" with people" if people else ""),
              "Clutter", variation="strong" if people else "none")
    s.room(LENGTH + 5.0, WIDTH)
    for k, (x, y, r) in enumerate(world(number)):
        s.circle(f"c{k + 1}", round(x + 2.5, 2), y, r)
    s.robot((1.0, WIDTH / 2, 0.0), (LENGTH + 4.0, WIDTH / 2))
    walkers = []
    for k in range(people):
        y = (1.2, 3.8, 2.5)[k]
        s.person(f"walker_{k + 1}", (LENGTH + 3.6 - 0.9 * k, y, 3.142),
                 [(1.2, y), (LENGTH + 3.6, y)], 1.0, cyclic=True)
        walkers.append(f"walker_{k + 1}")
    s.describe("Whether a robot finds its way through static clutter"
               + (" in which people walk" if people else ""),
               "Cross the field", "Walk through the clutter in both directions" if people
               else "Nobody is there", "No contact, time close to that of the shortest path",
               SOURCE, level,
               ("minimum_distance_to_people", "time_to_reach_goal", "path_length", "success")
               if people else ("time_to_reach_goal", "path_length", "success"),
               [f"{walkers[0]} reaches goal 1 before 60 s"] if people else [])
    return s


def scenes():
    return ([clutter(n, 0) for n in range(1, 31)] + [clutter(3 * n, 1 + n // 4) for n in range(1, 11)])
