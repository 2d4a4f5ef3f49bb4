"""Worlds for training: batches of episodes of one scene, with the seeds that `hunavsim run` takes."""

import numpy

from hunavsim.env import CrowdVectorEnv

TEACHER_PEOPLE = 16  # the teacher sees more people than the policies
DURATION = 45.0  # [s]
WEIGHTS = {"time": -0.1, "jerk": -0.02}  # of the reward; the others are the environment's
_MODULUS = 2**53


def seed_of(first):
    """The seed for CrowdVectorEnv.reset with which the world of copy 0 has the seed `first`.

    The environment makes the seed of the world of copy c from its own seed s: s * 1000003 + c + 1.
    """
    return (first - 1) * pow(1000003, -1, _MODULUS) % _MODULUS


class Episodes:
    """`count` worlds of a scene, each for one episode.

    The worlds of reset(first) have the seeds first, first + 1, …, as `hunavsim run --seed`.
    """

    def __init__(self, scene, count, beams, repeat):
        self.count, self.repeat = count, repeat
        self._envs = CrowdVectorEnv(count, scene, people=TEACHER_PEOPLE, beams=beams, repeat=repeat,
                                    duration=DURATION, weights=WEIGHTS)
        self.dt = self._envs._core.dt * repeat

    def reset(self, first):
        """Starts the episodes; returns the observations."""
        self.active = numpy.ones(self.count, bool)
        self.outcomes = numpy.array([""] * self.count, object)
        self.times = numpy.full(self.count, numpy.nan)
        self._time = 0.0
        return self._envs.reset(seed=seed_of(first))[0]

    def step(self, actions):
        """Returns observations and rewards; worlds whose episode has ended are no longer active."""
        observations, rewards, _, _, infos = self._envs.step(actions)
        self._time += self.dt
        rewards = numpy.where(self.active, rewards, 0.0)
        if infos:
            ended = infos["_outcome"] & self.active
            self.outcomes[ended] = infos["outcome"][ended]
            self.times[ended] = self._time
            self.active = self.active & ~ended
        return observations, rewards


_cache = {}


def episodes(scene, count, beams, repeat):
    """The worlds of a scene; they are made once per process."""
    key = (scene, count, beams, repeat)
    if key not in _cache:
        _cache[key] = Episodes(*key)
    return _cache[key]
