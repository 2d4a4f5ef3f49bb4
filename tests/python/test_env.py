"""Learning environments: observations and rewards by geometry, determinism, the two interfaces."""

import json
import math
import unittest

import numpy

import hunavsim
from hunavsim import env as environments

# A robot at the origin looks along x at a box whose front is 3 m ahead, a person stands 2 m to its
# left, and its goal is 10 m ahead and 1 m to the right.
SCENE = """hunav_loader:
  ros__parameters:
    publish_people: true
    agents:
      - visitor
    visitor:
      id: 1
      radius: 0.4
      max_vel: 1.0
      init_pose: {x: 0.0, y: 2.0, h: 0.0}
      behavior: {type: Regular}
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    robots: [robot1]
    robot1:
      start: {x: 0.0, y: 0.0, h: 0.0}
      goal: {x: 10.0, y: -1.0}
      radius: 0.3
      max_vel: 1.0
      max_acc: 100.0
    obstacles: [box]
    box:
      kind: box
      x: 3.5
      y: 0.0
      length: 1.0
      width: 2.0
"""
TWO_ROBOTS = SCENE.replace("robots: [robot1]", "robots: [robot1, robot2]").replace(
    "    obstacles:", """    robot2:
      start: {x: 0.0, y: -5.0, h: 0.0}
      goal: {x: 0.8, y: -5.0}
      max_vel: 1.0
      max_acc: 100.0
    obstacles:""")


def scene(text=SCENE):
    return hunavsim.Scenario.from_text(text)


class ObservationTest(unittest.TestCase):
    def setUp(self):
        self.env = environments.CrowdEnv(scene(), variation=None, beams=8, people=3, grid_cells=40,
                                         grid_resolution=0.2)
        self.observation, self.info = self.env.reset(seed=1)

    def test_state_is_the_goal_and_the_velocity(self):
        numpy.testing.assert_allclose(self.observation["state"], [10.0, -1.0, 0.0, 0.0, 0.0],
                                      atol=1e-6)

    def test_people_are_nearest_first_and_padded(self):
        people = self.observation["people"]
        self.assertEqual(people.shape, (3, 5))
        numpy.testing.assert_allclose(people[0], [0.0, 2.0, 0.0, 0.0, 0.4], atol=1e-6)
        self.assertFalse(people[1:].any())

    def test_lidar_measures_the_box_and_the_legs(self):
        # Beams from behind, counter-clockwise, 45 degrees apart: the fifth looks ahead at the box.
        lidar = self.observation["lidar"]
        self.assertEqual(lidar.dtype, numpy.float32)
        self.assertAlmostEqual(float(lidar[4]), 3.0, places=5)
        self.assertEqual(float(lidar[0]), environments.LIDAR_RANGE)

    def test_grid_shows_the_box_and_the_person(self):
        grid = self.observation["grid"]
        self.assertEqual(grid.shape, (40, 40))
        ahead, left = int((3.5 + 4) / 0.2), int((2.0 + 4) / 0.2)
        self.assertEqual(grid[ahead, 20], 1.0)   # inside the box
        self.assertEqual(grid[20, left], 1.0)    # inside the person
        self.assertEqual(grid[20, 20], 0.0)      # the robot itself is not drawn

    def test_observations_follow_the_heading(self):
        action = numpy.array([0.0, 1.0], numpy.float32)
        for _ in range(10):
            observation, *_ = self.env.step(action)
        x, y = observation["state"][:2]
        self.assertAlmostEqual(math.hypot(x, y), math.hypot(10.0, 1.0), places=4)
        self.assertLess(math.atan2(y, x), math.atan2(-1.0, 10.0) - 0.3)  # it has turned left


class PolicyMetadataTest(unittest.TestCase):
    def test_options_are_those_of_the_environment(self):
        options = dict(beams=8, people=3, grid_cells=40, grid_resolution=0.2, repeat=2)
        wanted = {"format": 1, "actions": 2, "dt": 0.05, **options}
        single = environments.CrowdEnv(scene(), variation=None, **options)
        several = environments.CrowdVectorEnv(2, scene(), variation=None, **options)
        agents = environments.CrowdParallelEnv(scene(TWO_ROBOTS), variation=None, **options)
        for env in (single, several, agents):
            self.assertEqual(json.loads(environments.policy_metadata(env)), wanted)
        sideways = scene(SCENE.replace("radius: 0.3", "radius: 0.3\n      kinematics: omnidirectional"))
        env = environments.CrowdEnv(sideways, variation=None)
        self.assertEqual(json.loads(environments.policy_metadata(env))["actions"], 3)


class RewardTest(unittest.TestCase):
    def test_progress_is_the_decrease_of_the_distance(self):
        weights = {"arrival": 0, "collision": 0, "progress": 1, "closeness": 0, "time": 0}
        env = environments.CrowdEnv(scene(), variation=None, weights=weights)
        env.reset(seed=1)
        observation, reward, *_ = env.step([1.0, 0.0])
        after = math.hypot(*observation["state"][:2].astype(float))
        self.assertAlmostEqual(reward, math.hypot(10.0, 1.0) - after, places=5)
        self.assertGreater(reward, 0.04)

    def test_time_and_closeness(self):
        # The gap is 2 - 0.4 - 0.3 = 1.3 m; a personal distance of 1.2 m gives no closeness term.
        env = environments.CrowdEnv(scene(), variation=None, weights={"progress": 0, "closeness": -1, "time": -1})
        env.reset(seed=1)
        self.assertAlmostEqual(env.step([0.0, 0.0])[1], -0.05, places=6)

    def test_collision_ends_the_episode(self):
        env = environments.CrowdEnv(scene(), variation=None, weights={"progress": 0, "closeness": 0, "time": 0,
                                                      "collision": -7})
        env.reset(seed=1)
        for step in range(100):
            _, reward, terminated, truncated, info = env.step([1.0, 0.0])
            if terminated:
                break
        self.assertEqual((reward, info["outcome"], truncated), (-7.0, "collided", False))
        self.assertAlmostEqual(step * 0.05, 2.7, delta=0.15)  # 3 m less the radius at 1 m/s

    def test_time_limit_truncates(self):
        env = environments.CrowdEnv(scene(), variation=None, duration=1.0)
        env.reset(seed=1)
        ends = [env.step([0.0, 0.0])[2:4] for _ in range(20)]
        self.assertEqual(ends[-1], (False, True))
        self.assertNotIn((False, True), ends[:-1])

    def test_unknown_reward_term_is_refused(self):
        with self.assertRaisesRegex(ValueError, "speed"):
            environments.CrowdEnv(scene(), variation=None, weights={"speed": 1.0})


class VectorTest(unittest.TestCase):
    def run_episode(self, seed, count=3):
        envs = environments.CrowdVectorEnv(count, "crossing_agents", beams=12, people=12,
                                           duration=2.0)
        envs.reset(seed=seed)
        generator = numpy.random.default_rng(1)
        rewards, states = [], []
        for _ in range(90):
            actions = generator.uniform(-0.5, 1.0, (count, 2)).astype(numpy.float32)
            observation, reward, *_ = envs.step(actions)
            rewards.append(reward)
            states.append(observation["people"])
        return numpy.array(rewards), numpy.array(states)

    def test_equal_seeds_give_equal_results(self):
        first, second = self.run_episode(4), self.run_episode(4)
        self.assertTrue((first[0] == second[0]).all() and (first[1] == second[1]).all())
        self.assertFalse((first[1] == self.run_episode(5)[1]).all())

    def test_shapes_and_autoreset(self):
        envs = environments.CrowdVectorEnv(2, scene(), duration=0.5, beams=4)
        observations, infos = envs.reset(seed=1)
        self.assertEqual(observations["lidar"].shape, (2, 4))
        self.assertEqual(infos, {})
        actions = numpy.zeros((2, 2), numpy.float32)
        for _ in range(10):
            _, rewards, terminations, truncations, infos = envs.step(actions)
        self.assertEqual(truncations.tolist(), [True, True])
        self.assertEqual(infos["outcome"].tolist(), ["timed_out", "timed_out"])
        observations, rewards, terminations, truncations, infos = envs.step(actions)
        self.assertEqual((rewards.tolist(), truncations.tolist(), infos), ([0, 0], [False] * 2, {}))
        self.assertEqual(rewards.shape, (2,))
        self.assertEqual(terminations.dtype, bool)

    def test_observations_lie_in_their_space(self):
        envs = environments.CrowdVectorEnv(2, "corner_cafe_agents", beams=30)
        observations, _ = envs.reset(seed=2)
        for key, array in observations.items():
            space = envs.single_observation_space[key]
            self.assertEqual(array.shape[1:], tuple(space.shape))
            self.assertTrue((array >= numpy.asarray(space.low)).all()
                            and (array <= numpy.asarray(space.high)).all(), key)

    def test_returned_arrays_do_not_change_later(self):
        envs = environments.CrowdVectorEnv(1, scene(), variation=None)
        first, _ = envs.reset(seed=1)
        kept = first["state"].copy()
        envs.step([[1.0, 0.5]])
        self.assertTrue((first["state"] == kept).all())

    def test_curriculum_changes_the_scenario(self):
        envs = environments.CrowdVectorEnv(1, curriculum=[scene(), scene(TWO_ROBOTS)])
        envs.reset(seed=1)
        envs.set_level(1)
        observations, _ = envs.reset(seed=1)
        self.assertEqual(envs.level, 1)
        self.assertEqual(observations["state"].shape, (1, 5))

    def test_wrong_actions_are_refused(self):
        envs = environments.CrowdVectorEnv(2, scene())
        envs.reset(seed=1)
        with self.assertRaises(ValueError):
            envs.step(numpy.zeros((3, 2), numpy.float32))


class ParallelTest(unittest.TestCase):
    def test_agents_leave_when_their_episode_ends(self):
        env = environments.CrowdParallelEnv(scene(TWO_ROBOTS), duration=3.0)
        observations, infos = env.reset(seed=1)
        self.assertEqual(env.possible_agents, ["robot1", "robot2"])
        self.assertEqual(set(observations), {"robot1", "robot2"})
        outcomes = {}
        while env.agents:
            actions = {agent: numpy.array([0.8 if agent == "robot2" else 0.0, 0.0])
                       for agent in env.agents}
            observations, rewards, terminations, truncations, infos = env.step(actions)
            self.assertEqual(set(observations), set(rewards))
            for agent, info in infos.items():
                if info:
                    outcomes[agent] = info["outcome"]
        self.assertEqual(outcomes, {"robot2": "arrived", "robot1": "timed_out"})
        self.assertTrue(env.observation_space("robot1") is env.observation_space("robot1"))


if __name__ == "__main__":
    unittest.main()
