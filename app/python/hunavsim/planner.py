"""Base class of robot planners in Python."""

import math


class Planner:
    """A robot planner: subclasses override `command`.

    An instance drives one robot in one run; `hunavsim.run(…, planners={"robot1": MyPlanner()})`.
    """

    def command(self, observation):
        """Returns (v, omega), or (vx, vy, omega) for an omnidirectional robot [m/s], [rad/s].

        Called once per time step with a `hunavsim.Observation`. The robot's limits of speed and
        acceleration apply afterwards.
        """
        raise NotImplementedError

    @staticmethod
    def towards(observation, point, speed, turn_rate=1.5):
        """The command that turns to a point (x, y) and drives there at most at `speed` [m/s]."""
        x, y, heading = observation.pose
        bearing = math.atan2(point[1] - y, point[0] - x) - heading
        bearing = math.atan2(math.sin(bearing), math.cos(bearing))
        return speed * max(0.0, math.cos(bearing)), max(-turn_rate, min(turn_rate, 2.0 * bearing))
