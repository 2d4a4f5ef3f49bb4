"""Environments for reinforcement learning on the crowd simulation.

`CrowdVectorEnv` follows gymnasium.vector.VectorEnv, `CrowdEnv` follows gymnasium.Env and
`CrowdParallelEnv` follows pettingzoo.ParallelEnv. Neither package is required: without them the
classes have the same methods, and the spaces are plain descriptions. With gymnasium, `register()`
adds "HuNavSim/Crowd-v0":

    import gymnasium, hunavsim.env
    hunavsim.env.register()
    envs = gymnasium.make_vec("HuNavSim/Crowd-v0", num_envs=8, scenario="corner_cafe_agents")

Observations are dicts of float32 arrays in the robot's frame: `state` (goal x, y [m], velocity vx,
vy [m/s], omega [rad/s]), `people` (nearest first, rows x, y, vx, vy, radius, zeros behind them),
`lidar` (distances [m], counter-clockwise from behind) and, with `grid_cells`, `grid` (1 occupied).
Actions are v [m/s] and omega [rad/s], for an omnidirectional robot also the lateral v. The planner
`onnx` runs a trained policy without Python; policy_metadata() has what its file must say.
"""

import json
from collections import namedtuple

import numpy

from ._hunavsim import CrowdEnvironment, Scenario

try:
    import gymnasium
    from gymnasium import spaces as _spaces
except ImportError:
    gymnasium = None
    _spaces = None
try:
    import pettingzoo
except ImportError:
    pettingzoo = None

ARRIVED, COLLIDED, TIMED_OUT = 1, 2, 3
OUTCOMES = {ARRIVED: "arrived", COLLIDED: "collided", TIMED_OUT: "timed_out"}

Box = namedtuple("Box", "low high shape dtype")
LIDAR_RANGE = 10.0  # [m]
POLICY_FORMAT = 1  # of policy_metadata()


def _box(low, high, shape):
    if _spaces is not None:
        return _spaces.Box(numpy.broadcast_to(numpy.float32(low), shape),
                           numpy.broadcast_to(numpy.float32(high), shape), dtype=numpy.float32)
    return Box(low, high, tuple(shape), numpy.float32)


def _dict(items):
    return _spaces.Dict(items) if _spaces is not None else items


def _batched(space, count):
    if _spaces is not None:
        return gymnasium.vector.utils.batch_space(space, count)
    if isinstance(space, dict):
        return {key: _batched(value, count) for key, value in space.items()}
    return Box(space.low, space.high, (count, *space.shape), space.dtype)


def _action_space(core, robot):
    speed, reverse, turn, is_omnidirectional = core.limits(robot)
    low, high = [-reverse, -turn], [speed, turn]
    if is_omnidirectional:
        low, high = low + [-speed], high + [speed]
    return _box(numpy.array(low, numpy.float32), numpy.array(high, numpy.float32), (len(low),))


def _observation_space(core):
    bounds = {"state": (-numpy.inf, numpy.inf), "people": (-numpy.inf, numpy.inf),
              "lidar": (0.0, LIDAR_RANGE), "grid": (0.0, 1.0)}
    return _dict({key: _box(*bounds[key], array.shape[1:])
                  for key, array in core.observations.items()})


def _scenario(scenario, variation):
    """A copy whose people vary between episodes, unless the scenario itself says how."""
    copy = scenario.copy() if isinstance(scenario, Scenario) else Scenario(scenario)
    if variation is not None and copy.get("variation") is None:
        copy.set("variation.preset", variation)
    return copy


class CrowdVectorEnv(gymnasium.vector.VectorEnv if gymnasium else object):
    """`num_envs` copies of a scenario, stepped together.

    When an episode has ended, the next step starts a new one and ignores the action of that copy
    (autoreset mode NEXT_STEP). Equal seeds and actions give equal results.

    scenario: a Scenario, a path or a name. robot: the robot to drive; None: the first one.
    weights: weights of the reward terms arrival, collision, progress, closeness, time and jerk.
    curriculum: scenarios of rising difficulty; `set_level(i)` changes to one of them.
    variation: how people vary between episodes ("none", "light", "strong") where the scenario does
    not say it.
    Other options: people, beams, grid_cells, grid_resolution, duration, repeat, and those of run().
    """

    metadata = {"render_modes": [], "autoreset_mode": "NextStep"}

    def __init__(self, num_envs=1, scenario="corner_cafe_agents", *, robot=None, weights=None,
                 curriculum=None, variation="light", **options):
        self.num_envs = num_envs
        self._options = dict(count=num_envs, robots=[robot] if robot else [],
                             weights=weights or {}, **options)
        self._levels = [_scenario(each, variation) for each in (curriculum or [scenario])]
        self.level = 0
        self._core = CrowdEnvironment(self._levels[0], **self._options)
        self.single_observation_space = _observation_space(self._core)
        self.single_action_space = _action_space(self._core, 0)
        self.observation_space = _batched(self.single_observation_space, num_envs)
        self.action_space = _batched(self.single_action_space, num_envs)
        if gymnasium and hasattr(gymnasium.vector, "AutoresetMode"):
            self.metadata = {**self.metadata,
                             "autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}
        self._seed = 1

    def set_level(self, level):
        """Changes to a scenario of the curriculum, from the next reset() on."""
        self._core = CrowdEnvironment(self._levels[level], **self._options)
        self.level = level

    def reset(self, *, seed=None, options=None):
        """Starts new episodes; returns (observations, infos)."""
        self._seed = self._seed + 1 if seed is None else int(seed)
        self._core.reset(self._seed)
        return self._observe(), {}

    def step(self, actions):
        """Returns (observations, rewards, terminations, truncations, infos)."""
        self._core.step(numpy.asarray(actions, numpy.float32))
        ends = self._core.ends
        infos = {}
        if ends.any():
            infos = {"outcome": numpy.array([OUTCOMES.get(int(end)) for end in ends], object),
                     "_outcome": ends != 0}
        return (self._observe(), self._core.rewards, (ends == ARRIVED) | (ends == COLLIDED),
                ends == TIMED_OUT, infos)

    def close(self, **unused):
        """Nothing has to be closed."""

    def _observe(self):
        return {key: array.copy() for key, array in self._core.observations.items()}


class CrowdEnv(gymnasium.Env if gymnasium else object):
    """One copy of a scenario; options as for CrowdVectorEnv."""

    metadata = {"render_modes": []}

    def __init__(self, scenario="corner_cafe_agents", **options):
        self._vector = CrowdVectorEnv(1, scenario, **options)
        self.observation_space = self._vector.single_observation_space
        self.action_space = self._vector.single_action_space

    def reset(self, *, seed=None, options=None):
        """Starts a new episode; returns (observation, info)."""
        if gymnasium:
            super().reset(seed=seed)
        observations, _ = self._vector.reset(seed=seed)
        return self._first(observations), {}

    def step(self, action):
        """Returns (observation, reward, terminated, truncated, info)."""
        observations, rewards, terminated, truncated, infos = self._vector.step(
            numpy.asarray(action, numpy.float32)[None])
        info = {"outcome": infos["outcome"][0]} if infos else {}
        return (self._first(observations), float(rewards[0]), bool(terminated[0]),
                bool(truncated[0]), info)

    @staticmethod
    def _first(observations):
        return {key: array[0] for key, array in observations.items()}


class CrowdParallelEnv(pettingzoo.ParallelEnv if pettingzoo else object):
    """All robots of a scenario as agents, which act at the same time."""

    metadata = {"name": "hunavsim_crowd_v0", "render_modes": []}
    render_mode = None

    def __init__(self, scenario, *, robots=None, weights=None, variation="light", **options):
        scenario = _scenario(scenario, variation)
        self.possible_agents = list(robots or scenario.robots)
        self._core = CrowdEnvironment(scenario, count=1, robots=self.possible_agents,
                                      weights=weights or {}, **options)
        space = _observation_space(self._core)
        self.observation_spaces = {agent: space for agent in self.possible_agents}
        self.action_spaces = {agent: _action_space(self._core, index)
                              for index, agent in enumerate(self.possible_agents)}
        self.agents = []
        self._seed = 1

    def observation_space(self, agent):
        """The space of the observations of an agent."""
        return self.observation_spaces[agent]

    def action_space(self, agent):
        """The space of the actions of an agent."""
        return self.action_spaces[agent]

    def reset(self, seed=None, options=None):
        """Starts a new episode; returns (observations, infos) by agent."""
        self._seed = self._seed + 1 if seed is None else int(seed)
        self._core.reset(self._seed)
        self.agents = list(self.possible_agents)
        return self._observe(self.agents), {agent: {} for agent in self.agents}

    def step(self, actions):
        """Returns (observations, rewards, terminations, truncations, infos) by agent."""
        columns = max(self.action_spaces[agent].shape[0] for agent in self.possible_agents)
        table = numpy.zeros((len(self.possible_agents), columns), numpy.float32)
        for index, agent in enumerate(self.possible_agents):
            if agent in actions:
                action = numpy.asarray(actions[agent], numpy.float32)
                table[index, :len(action)] = action
        self._core.step(table)
        ends = dict(zip(self.possible_agents, self._core.ends.tolist()))
        rewards = dict(zip(self.possible_agents, self._core.rewards.tolist()))
        acting = self.agents
        result = (self._observe(acting), {agent: rewards[agent] for agent in acting},
                  {agent: ends[agent] in (ARRIVED, COLLIDED) for agent in acting},
                  {agent: ends[agent] == TIMED_OUT for agent in acting},
                  {agent: {"outcome": OUTCOMES[ends[agent]]} if ends[agent] else {}
                   for agent in acting})
        self.agents = [agent for agent in acting if not ends[agent]]
        return result

    def close(self):
        """Nothing has to be closed."""

    def _observe(self, agents):
        all_rows = self._core.observations
        rows = {agent: index for index, agent in enumerate(self.possible_agents)}
        return {agent: {key: array[rows[agent]].copy() for key, array in all_rows.items()}
                for agent in agents}


def policy_metadata(env):
    """The options of an environment as text for the metadata `hunavsim_policy` of an ONNX file.

    With them the planner `onnx` drives robots by a policy that was trained in this environment. Of
    a CrowdParallelEnv, the number of actions is that of the first agent.
    """
    core = getattr(env, "unwrapped", env)
    core = getattr(core, "_vector", core)._core
    return json.dumps({"format": POLICY_FORMAT, **core.options,
                       "actions": 3 if core.limits(0)[3] else 2})


def register():
    """Adds "HuNavSim/Crowd-v0" to gymnasium."""
    if gymnasium is None:
        raise ImportError("register() needs the package gymnasium")
    gymnasium.register(id="HuNavSim/Crowd-v0", entry_point="hunavsim.env:CrowdEnv",
                       vector_entry_point="hunavsim.env:CrowdVectorEnv")
