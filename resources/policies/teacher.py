"""A sampling planner on the observations of the environment, whose decisions the policies imitate.

Each decision compares commands (v, omega) over a horizon: the robot turns with omega for a while and
then drives straight on, people walk on with their velocities, and points of the lidar stand still.
The cost is that of the environment's reward, summed over the horizon, plus a cost for obstacles.
"""

import numpy

SPEEDS = numpy.array([-0.3, 0.0, 0.25, 0.5, 0.75, 1.0], numpy.float32)  # [m/s]
TURNS = numpy.array([-1.5, -1.0, -0.6, -0.3, -0.1, 0.0, 0.1, 0.3, 0.6, 1.0, 1.5], numpy.float32)
STEP = 0.25  # [s]
STEPS = 12
TURNING = 0.8  # [s] for which a command turns
ROBOT_RADIUS = 0.3  # [m]
PERSONAL = 1.2  # [m], as EnvironmentOptions::personalDistance
NEAR = 4.5  # [m], obstacles beyond have no influence on the cost of a command
CLEARANCE = 0.42  # [m] between the robot's centre and an obstacle beside its way
DETOURS = (0.8, 1.6, 2.8, 4.5, 7.0)  # [m], distances of possible subgoals


def _arcs():
    """Commands (K, 2) and the places (K, STEPS, 2) that they reach from the origin."""
    commands = numpy.array([(v, omega) for v in SPEEDS for omega in TURNS
                            if v != 0.0 or omega != 0.0] + [(0.0, 0.0)], numpy.float32)
    fine = 5
    times = numpy.arange(STEPS * fine) * (STEP / fine)
    headings = commands[:, 1:] * numpy.minimum(times + 0.5 * STEP / fine, TURNING)
    moves = commands[:, :1, None] * numpy.stack([numpy.cos(headings), numpy.sin(headings)], -1)
    places = numpy.cumsum(moves * (STEP / fine), axis=1)[:, fine - 1::fine]
    return commands, places.astype(numpy.float32)


COMMANDS, PLACES = _arcs()
TIMES = (numpy.arange(STEPS, dtype=numpy.float32) + 1.0) * STEP
WEIGHTS = 0.85 ** numpy.arange(STEPS, dtype=numpy.float32)  # the future is uncertain


def _people_cost(people):
    """Cost of nearness and contact with people per world and command."""
    is_present = people[..., 4] > 0.0
    squares = None
    for axis in range(2):
        reached = people[:, :, axis, None] + people[:, :, 2 + axis, None] * TIMES
        reached[~is_present] = 100.0
        # Axes: worlds, commands, people, steps.
        part = PLACES[None, :, None, :, axis] - reached[:, None]
        part *= part
        squares = part if squares is None else numpy.add(squares, part, out=squares)
    radius = people[..., 4].max(axis=1)[:, None, None]  # of the largest person
    gaps = numpy.sqrt(squares.min(axis=2)) - radius - ROBOT_RADIUS
    return _nearness(gaps, PERSONAL, 0.15)


def _nearness(gaps, personal, contact):
    close = numpy.maximum(0.0, personal - gaps) * STEP
    touch = numpy.maximum(0.0, contact - gaps) / contact
    return ((close + 2.0 * numpy.minimum(touch, 2.0)) * WEIGHTS).sum(-1)


def _directions(beams):
    angles = -numpy.pi + numpy.arange(beams, dtype=numpy.float32) * (2.0 * numpy.pi / beams)
    return numpy.stack([numpy.cos(angles), numpy.sin(angles)], -1).astype(numpy.float32)


def _points(lidar, people):
    """Points of the lidar (worlds, beams, 2) on obstacles; those on people are moved away."""
    points = lidar[:, :, None] * _directions(lidar.shape[1])
    distances = numpy.linalg.norm(points[:, :, None] - people[:, None, :, :2], axis=-1)
    on_person = ((distances < people[:, None, :, 4] + 0.15) & (people[:, None, :, 4] > 0)).any(-1)
    points[(lidar > 9.9) | on_person] = 100.0
    return points


def _blocked(starts, ends, points):
    """Points (worlds, beams, 2) beside the segments (worlds, segments, 2) between two places."""
    along = ends - starts
    length = numpy.maximum((along**2).sum(-1), 1e-6)
    offset_dot = (numpy.einsum("nsk,nbk->nsb", along, points)
                  - (along * starts).sum(-1)[:, :, None]) / length[:, :, None]
    offset_dot = numpy.clip(offset_dot, 0.0, 1.0)
    gap = numpy.zeros_like(offset_dot)
    for axis in range(2):
        gap += numpy.square(points[:, None, :, axis] - starts[:, :, None, axis]
                            - offset_dot * along[:, :, None, axis])
    return (gap < CLEARANCE**2).any(-1)


def _subgoals(goal, points):
    """The goal (worlds, 2), or a visible place on the way around what blocks the straight way."""
    result = goal.copy()
    origin = numpy.zeros((len(goal), 1, 2), numpy.float32)
    rows = numpy.flatnonzero(_blocked(origin, goal[:, None], points)[:, 0])
    if not len(rows):
        return result
    offsets = (numpy.array(DETOURS, numpy.float32)[:, None, None]
               * _directions(points.shape[1])[::2]).reshape(1, -1, 2)
    places = numpy.broadcast_to(offsets, (len(rows), *offsets.shape[1:]))
    seen, target = points[rows], goal[rows][:, None]
    cost = (numpy.linalg.norm(places, axis=-1) + numpy.linalg.norm(target - places, axis=-1)
            + 6.0 * _blocked(places, numpy.broadcast_to(target, places.shape), seen)
            + 100.0 * _blocked(numpy.zeros_like(places), places, seen))
    best = cost.argmin(-1)
    is_found = cost[numpy.arange(len(rows)), best] < 100.0
    result[rows[is_found]] = places[is_found, best[is_found]]
    return result


def _obstacle_cost(points, distance):
    """Cost per world and command of driving near points, up to the distance of the goal."""
    points = numpy.where(numpy.abs(points).max(-1, keepdims=True) > NEAR, 100.0, points)
    points = points.astype(numpy.float32)
    places = PLACES[:, 1::2]  # every other step is dense enough
    flat = places.reshape(-1, 2)
    squares = ((flat**2).sum(-1)[None, :, None] + (points**2).sum(-1)[:, None]
               - 2.0 * flat[None] @ points.transpose(0, 2, 1))
    gaps = numpy.sqrt(numpy.maximum(squares.min(-1), 0.0)) - ROBOT_RADIUS
    gaps = numpy.repeat(gaps.reshape(len(points), *places.shape[:2]), 2, axis=-1)
    driven = numpy.repeat(numpy.abs(COMMANDS[:, :1]) * TIMES[1::2], 2, axis=-1)
    gaps = numpy.where(driven > distance[:, None, None], 10.0, gaps)
    # What lies behind a wall is not reached, so a contact lasts until the end of the horizon.
    gaps = numpy.minimum.accumulate(gaps, axis=-1)
    return _nearness(gaps, 0.25, 0.12)


def decide(observations):
    """Commands (worlds, 2) [m/s], [rad/s] for a dict of observations."""
    state, people = observations["state"], observations["people"]
    goal = state[:, :2]
    cost = 0.9 * _people_cost(people)
    if "lidar" in observations:
        points = _points(observations["lidar"], people)
        cost += 1.5 * _obstacle_cost(points, numpy.linalg.norm(goal, axis=-1))
        goal = _subgoals(goal, points)
    distance = numpy.linalg.norm(goal, axis=-1)[:, None]
    left = numpy.linalg.norm(goal[:, None, None] - PLACES[None], axis=-1)  # worlds, commands, steps
    cost -= (distance - left[..., 3]) + 0.5 * (distance - left.min(-1))
    cost += 0.05 * numpy.square(COMMANDS[:, 1]) + 0.5 * (COMMANDS[:, 0] < 0.0)
    bearing = numpy.arctan2(goal[:, 1:], goal[:, :1])
    cost += 0.3 * (1.0 - numpy.cos(bearing - COMMANDS[:, 1] * TURNING)) * numpy.minimum(distance, 1)
    motion = state[:, None, [2, 4]]
    cost += (numpy.square(COMMANDS[None] - motion) * numpy.float32([0.1, 0.05])).sum(-1)
    # A soft choice: the mean of the best commands follows small changes of the scene smoothly.
    weights = numpy.exp(-(cost - cost.min(-1, keepdims=True)) / 0.03)
    weights /= weights.sum(-1, keepdims=True)
    return (weights @ COMMANDS).astype(numpy.float32)
