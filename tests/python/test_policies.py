"""The training of policies: the file against the network, gradients, the teacher, shipped policies."""

import contextlib
import io
import json
import os
import struct
import sys
import tempfile
import unittest
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy

import hunavsim
from hunavsim.env import CrowdEnvironment

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "policies"
sys.path.insert(0, str(FOLDER))

import evaluate
import onnx_reader
import teacher
import train
from network import Network
from worlds import seed_of

TINY = ["--imitation", "1", "--reinforcement", "1", "--validation", "3", "--processes", "2",
        "--scenes", "classic_frontal"]
METADATA_KEYS = {"format", "people", "beams", "grid_cells", "grid_resolution", "repeat", "dt", "actions"}


def parse(data):
    """{field: [values]} of a protobuf message, written apart from onnx_reader."""
    result, rest = {}, memoryview(data)
    while rest:
        key, rest = number(rest)
        if key % 8 == 2:
            length, rest = number(rest)
            value, rest = bytes(rest[:length]), rest[length:]
        else:
            assert key % 8 == 0, "only whole numbers and byte strings are expected"
            value, rest = number(rest)
        result.setdefault(key // 8, []).append(value)
    return result


def number(data):
    """(value, rest) of a whole number with 7 bits per byte, lowest first."""
    end = next(i for i, byte in enumerate(data) if byte < 128) + 1
    return sum((byte % 128) << 7 * i for i, byte in enumerate(data[:end])), data[end:]


def compute(model, values):
    """The action of the parsed file, in double precision, value by value as the ONNX pages say."""
    graph = parse(model[7][0])
    values = dict(values)
    for text in graph[5]:
        tensor = parse(text)
        assert tensor[2] == [1], "float32"
        flat = struct.unpack(f"<{len(tensor[9][0]) // 4}f", tensor[9][0])
        values[tensor[8][0].decode()] = numpy.array(flat).reshape(tensor[1])
    for text in graph[1]:
        node = parse(text)
        x = [values[name.decode()] for name in node[1]]
        attributes = {parse(each)[1][0]: parse(each)[3][0] for each in node.get(5, [])}
        kind = node[4][0]
        if kind == b"Flatten":
            y = x[0].reshape(1, -1)
        elif kind == b"Concat":
            y = numpy.hstack(x)
        elif kind == b"Gemm":
            assert attributes == {b"transB": 1}
            y = numpy.einsum("nk,mk->nm", x[0], x[1]) + x[2]
        elif kind == b"Relu":
            y = x[0] * (x[0] > 0.0)
        else:
            assert kind == b"Tanh"
            y = 1.0 - 2.0 / (numpy.exp(2.0 * x[0]) + 1.0)
        values[node[2][0].decode()] = y
    return values[parse(graph[12][0])[1][0].decode()]


def observations(beams, people=10, seed=1):
    """Observations of one world, as the environment gives them."""
    generator = numpy.random.default_rng(seed)
    result = {"state": generator.normal(0.0, 2.0, (1, 5)).astype(numpy.float32),
              "people": generator.normal(0.0, 2.0, (1, people, 5)).astype(numpy.float32)}
    if beams:
        result["lidar"] = generator.uniform(0.2, 10.0, (1, beams)).astype(numpy.float32)
    return result


def trained(policy, folder):
    """The network that a tiny training returns, and the bytes that it writes."""
    with contextlib.redirect_stdout(io.StringIO()):
        network = train.main([policy, "--out", folder, *TINY])
    return network, (Path(folder) / f"{policy}.onnx").read_bytes()


class TrainingTest(unittest.TestCase):
    def check(self, policy, beams):
        with tempfile.TemporaryDirectory() as folder:
            network, data = trained(policy, folder)
            rows = (Path(folder) / f"{policy}.csv").read_text().splitlines()
            read = onnx_reader.Policy(Path(folder) / f"{policy}.onnx")
        self.assertEqual(len(rows), 3)
        model = parse(data)
        entry = parse(model[14][0])
        self.assertEqual(entry[1], [b"hunavsim_policy"])
        settings = json.loads(entry[2][0])
        self.assertEqual(set(settings), METADATA_KEYS)
        self.assertEqual((settings["people"], settings["beams"]), (10, beams))
        for seed in range(1, 6):
            seen = observations(beams, seed=seed)
            expected = train.actions_of(train.decide(network, seen))
            numpy.testing.assert_allclose(compute(model, seen), expected, atol=1e-5)
            numpy.testing.assert_allclose(read(seen), expected, atol=1e-5)
        return data

    def test_file_of_the_crossing_policy(self):
        data = self.check("crossing_policy", 0)
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(trained("crossing_policy", folder)[1], data)

    def test_file_of_the_crowd_policy(self):
        self.check("crowd_policy", 48)


class NetworkTest(unittest.TestCase):
    def setUp(self):
        self.network = Network(3, 4, 2, numpy.random.default_rng(1))
        self.seen = observations(4, people=3)

    def test_order_of_people_has_no_influence(self):
        other = dict(self.seen, people=self.seen["people"][:, ::-1])
        numpy.testing.assert_allclose(train.decide(self.network, other),
                                      train.decide(self.network, self.seen), atol=1e-6)

    def test_gradients_are_those_of_differences(self):
        parameters = self.network.parameters
        for name in parameters:
            parameters[name] = parameters[name].astype(numpy.float64)
        inputs = {key: each.astype(numpy.float64)
                  for key, each in self.network.inputs(self.seen).items()}
        output, kept = self.network.forward(inputs)
        gradients = self.network.backward(kept, output)  # of half the sum of squares
        for name, array in parameters.items():
            place = numpy.unravel_index(numpy.abs(gradients[name]).argmax(), array.shape)
            losses = []
            for sign in (1.0, -1.0):
                array[place] += sign * 1e-6
                losses.append(0.5 * numpy.square(self.network.forward(inputs)[0]).sum())
                array[place] -= sign * 1e-6
            self.assertAlmostEqual((losses[0] - losses[1]) / 2e-6, gradients[name][place], places=5,
                                   msg=name)


class LearningTest(unittest.TestCase):
    def test_advantages_by_hand(self):
        # The last decision: 10 - 2 = 8. The first one: 1 + 0.98 * 2 - 3 + 0.98 * 0.95 * 8 = 7.408.
        advantages, returns = train.advantages_of(
            numpy.array([[1.0], [10.0]]), numpy.array([[3.0], [2.0]]),
            numpy.array([[True], [True]]), numpy.zeros(1))
        numpy.testing.assert_allclose(advantages[:, 0], [7.408, 8.0], rtol=1e-6)
        numpy.testing.assert_allclose(returns[:, 0], [10.408, 10.0], rtol=1e-6)


class TeacherTest(unittest.TestCase):
    def decide(self, people=(), lidar=None):
        rows = numpy.zeros((1, 4, 5), numpy.float32)
        rows[0, :len(people)] = numpy.array(people).reshape(-1, 5)
        seen = {"state": numpy.array([[8.0, 0.0, 1.0, 0.0, 0.0]], numpy.float32), "people": rows}
        if lidar is not None:
            seen["lidar"] = numpy.array([lidar], numpy.float32)
        return teacher.decide(seen)[0]

    def test_drives_straight_on_where_nobody_is(self):
        v, omega = self.decide()
        self.assertGreater(v, 0.9)
        self.assertAlmostEqual(omega, 0.0, places=3)

    def test_avoids_a_person_on_its_way(self):
        left = self.decide([(2.0, 0.2, 0.0, 0.0, 0.3)])
        right = self.decide([(2.0, -0.2, 0.0, 0.0, 0.3)])
        self.assertLess(left[1], -0.05)  # passes on the side with more room
        self.assertAlmostEqual(right[1], -left[1], places=3)

    def test_does_not_drive_into_a_wall(self):
        angles = -numpy.pi + numpy.arange(48) * 2.0 * numpy.pi / 48
        ahead = numpy.maximum(numpy.cos(angles), 1e-3)  # a wall across, 0.6 m ahead
        self.assertLess(self.decide(lidar=numpy.minimum(0.6 / ahead, 10.0))[0], 0.35)


class ShippedPoliciesTest(unittest.TestCase):
    def test_arrive_on_new_seeds(self):
        for name in train.POLICIES:
            policy = onnx_reader.Policy(FOLDER / f"{name}.onnx")
            scenario = evaluate.scenario_of("crossing_agents")
            ends = [evaluate.drive_policy(scenario, policy, seed)[0] for seed in range(1001, 1011)]
            self.assertGreaterEqual(ends.count("arrived"), 8, f"{name}: {ends}")

    def test_seeds_are_those_of_a_run(self):
        # While the robot stands, the nearest person of the environment is as far as that of a run.
        scenario = evaluate.scenario_of("crossing_agents")
        environment = CrowdEnvironment(scenario, people=1, beams=0)
        environment.reset(seed_of(1001))
        for _ in range(60):
            environment.step(numpy.zeros((1, 2)))
        x, y = environment.observations["people"][0, 0, :2]
        simulation = hunavsim.Simulation(scenario, seed=1001, planner="teleop")
        simulation.step(60)
        rows = simulation.state
        robot, people = rows[rows["id"] == -1][0], rows[rows["id"] >= 0]
        nearest = numpy.hypot(people["x"] - robot["x"], people["y"] - robot["y"]).min()
        self.assertAlmostEqual(float(numpy.hypot(x, y)), nearest, places=5)


if __name__ == "__main__":
    unittest.main()
