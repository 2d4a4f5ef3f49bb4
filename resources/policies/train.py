#!/usr/bin/env python3
"""Trains the policies that ship with the program: `train.py crossing_policy --out FOLDER`.

1. Imitation (Ross et al. 2011, DAgger): the policy and the sampling planner of teacher.py drive in
   turns; the teacher's decision is recorded for every observation, and the network learns them.
2. Reinforcement learning (Schulman et al. 2017, proximal policy optimization) on the environment's
   reward.

The policy with the highest mean return on seeds from 101 on is written. Equal options give equal
files on one machine. Needs numpy and the module hunavsim; see README.md.
"""

import argparse
import json
import multiprocessing
import os
import sys
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy is loaded: equal results

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import teacher
from network import PERSON, STATE, Adam, Network
from onnx_file import Graph
from worlds import episodes

REPEAT = 4  # steps of the world per decision
DT = 0.05  # [s], of these steps in all scenes
BATCH = 25  # worlds per job
TAIL = 2  # worlds that may be left when a batch ends
SEEDS = 100  # training uses the seeds 1 to 100
VALIDATION = 101  # first seed of the episodes that choose the policy
ACTION_SCALE = numpy.array([0.65, 1.5], numpy.float32)  # tanh in [-1, 1] to v [m/s], omega [rad/s]
ACTION_OFFSET = numpy.array([0.35, 0.0], numpy.float32)
DISCOUNT, TRACE = 0.98, 0.95  # of rewards, of advantages
CLIP = 0.2
SPREAD = numpy.float32(0.15)  # standard deviation of the exploration, in the scale of tanh
RATE = 2e-4  # of learning, in the second phase

# Inputs, rounds, and scenes with the number of batches of each round.
POLICIES = {
    "crossing_policy": {"people": 10, "beams": 0, "imitation": 6, "reinforcement": 5,
                        "scenes": {"crossing_agents": 3, "crowd_agents": 1, "classic_circle": 1}},
    "crowd_policy": {"people": 10, "beams": 48, "imitation": 5, "reinforcement": 0,
                     "scenes": {"crossing_agents": 1, "crowd_agents": 1, "corridor_pass_agents": 1,
                                "doorway_agents": 2, "blind_corner_agents": 1,
                                "classic_circle": 1}},
}


def actions_of(normed):
    """Commands (v, omega) of the network's values in [-1, 1]."""
    return (normed * ACTION_SCALE + ACTION_OFFSET).astype(numpy.float32)


def decide(network, observations):
    """The policy's values in [-1, 1]."""
    return numpy.tanh(network.forward(network.inputs(observations))[0])


def shown(network, observations, rows):
    """What the network sees of these rows."""
    result = {"state": observations["state"][rows],
              "people": observations["people"][rows, :network.people]}
    if network.beams:
        result["lidar"] = observations["lidar"][rows]
    return result


def joined(parts):
    """One dict of arrays from several."""
    return {key: numpy.concatenate([part[key] for part in parts]) for key in parts[0]}


# --- Jobs of the worker processes -----------------------------------------------------------------


def imitate(job):
    """Drives a batch; returns what the network saw, with the teacher's decisions."""
    network, scene, first, share, seed = job
    generator = numpy.random.default_rng(seed)
    worlds = episodes(scene, BATCH, network.beams, REPEAT)
    observations = worlds.reset(first)
    is_teacher = generator.random(BATCH) < share
    disturbed = numpy.zeros(BATCH, int)
    disturbance = numpy.zeros((BATCH, 2), numpy.float32)
    parts = []
    while worlds.active.sum() > TAIL:
        taught = numpy.zeros((BATCH, 2), numpy.float32)
        taught[worlds.active] = teacher.decide({key: array[worlds.active]
                                                for key, array in observations.items()})
        part = shown(network, observations, worlds.active)
        part["taught"] = taught[worlds.active]
        parts.append(part)
        actions = numpy.where(is_teacher[:, None], taught,
                              actions_of(decide(network, observations)))
        starts = (disturbed == 0) & (generator.random(BATCH) < 0.04)
        disturbed = numpy.where(starts, generator.integers(2, 7, BATCH),
                                numpy.maximum(disturbed - 1, 0))
        fresh = actions_of(generator.uniform(-1.0, 1.0, (BATCH, 2)))
        disturbance = numpy.where(starts[:, None], fresh, disturbance)
        observations, _ = worlds.step(numpy.where(disturbed[:, None] > 0, disturbance, actions))
    return joined(parts), worlds.outcomes[~is_teacher]


def explore(job):
    """Drives a batch with noise; returns what was seen and done, with advantages and returns."""
    network, critic, scene, first, seed = job
    generator = numpy.random.default_rng(seed)
    worlds = episodes(scene, BATCH, network.beams, REPEAT)
    observations = worlds.reset(first)
    parts, rewards, values, actives = [], [], [], []
    while worlds.active.sum() > TAIL:
        active = worlds.active
        everyone = shown(network, observations, slice(None))
        inputs = network.inputs(everyone)
        noise = generator.standard_normal((BATCH, 2)).astype(numpy.float32)
        everyone["done"] = numpy.tanh(network.forward(inputs)[0]) + SPREAD * noise
        everyone["surprise"] = 0.5 * numpy.square(noise).sum(axis=1)
        values.append(critic.forward(inputs)[0][:, 0])
        observations, reward = worlds.step(actions_of(numpy.clip(everyone["done"], -1.0, 1.0)))
        parts.append(everyone)
        rewards.append(reward)
        actives.append(active)
    last = critic.forward(network.inputs(shown(network, observations, slice(None))))[0][:, 0]
    advantages, returns = advantages_of(numpy.array(rewards), numpy.array(values),
                                        numpy.array(actives), last * worlds.active)
    rows = numpy.array(actives).reshape(-1)
    batch = {key: array[rows] for key, array in joined(parts).items()}
    batch["advantage"], batch["return"] = advantages.reshape(-1)[rows], returns.reshape(-1)[rows]
    return batch, worlds.outcomes, numpy.sum(rewards, axis=0)


def advantages_of(rewards, values, actives, next_value):
    """Generalized advantages (Schulman et al. 2016) and returns.

    Rows are decisions; next_value: what is expected after the last one.
    """
    advantages = numpy.zeros(rewards.shape, numpy.float32)
    following = numpy.zeros(rewards.shape[1])
    for row in range(len(rewards) - 1, -1, -1):
        error = rewards[row] + DISCOUNT * next_value - values[row]
        following = numpy.where(actives[row], error + DISCOUNT * TRACE * following, 0.0)
        next_value = numpy.where(actives[row], values[row], 0.0)
        advantages[row] = following
    return advantages, advantages + values


def validate(job):
    """Outcomes and returns of the policy without noise."""
    network, scene, first, count = job
    worlds = episodes(scene, count, network.beams, REPEAT)
    observations = worlds.reset(first)
    total = numpy.zeros(count)
    while worlds.active.any():
        observations, rewards = worlds.step(actions_of(decide(network, observations)))
        total += rewards
    return worlds.outcomes, total


# --- Training -------------------------------------------------------------------------------------


class Curve:
    """The training curve and the progress; keeps the best network of the validations."""

    COLUMNS = "phase,round,decisions,success,contact,return,loss"

    def __init__(self, path, rounds):
        self.rows, self._path = [], path
        self.best, self.best_return = None, -numpy.inf
        self._begin, self._rounds, self._done = time.monotonic(), rounds, 0

    def add(self, phase, number, decisions, outcomes, mean_return, loss):
        """Adds a row and prints it with the time left."""
        self._done += 1
        success = numpy.mean(outcomes == "arrived") if len(outcomes) else numpy.nan
        contact = numpy.mean(outcomes == "collided") if len(outcomes) else numpy.nan
        self.rows.append(f"{phase},{number},{decisions},{success:.4f},{contact:.4f},"
                         f"{mean_return:.4f},{loss:.5f}")
        spent = time.monotonic() - self._begin
        left = spent / self._done * (self._rounds - self._done)
        self.save()
        print(f"{self.rows[-1]}  ({spent:.0f} s, {left:.0f} s left)", flush=True)

    def save(self):
        """Writes the rows as CSV."""
        self._path.write_text("\n".join([self.COLUMNS, *self.rows]) + "\n", encoding="utf-8")


class Trainer:
    """One policy with its worker processes."""

    def __init__(self, settings, options, pool):
        self._generator = numpy.random.default_rng(options.seed)
        self._settings, self._options, self._pool = settings, options, pool
        self.network, self._critic = [
            Network(settings["people"], settings["beams"], outputs, self._generator)
            for outputs in (2, 1)]
        self.curve = Curve(options.out / f"{options.policy}.csv",
                           options.imitation + options.reinforcement)
        self._memory = []

    def _jobs(self, number):
        """(scene, first seed, seed of the noise) of the jobs of a round."""
        blocks = SEEDS // BATCH
        jobs = [(scene, 1 + (number + index) % blocks * BATCH)
                for scene, batches in self._settings["scenes"].items() for index in range(batches)]
        noise = self._generator.integers(0, 2**32, len(jobs))
        return [(*job, int(seed)) for job, seed in zip(jobs, noise)]

    def validate(self):
        """Outcomes and mean return on the seeds from VALIDATION on; keeps the best network."""
        count = self._options.validation
        jobs = [(self.network, scene, VALIDATION, count) for scene in self._settings["scenes"]]
        results = self._pool.map(validate, jobs, chunksize=1)
        outcomes = numpy.concatenate([each[0] for each in results])
        mean_return = float(numpy.mean([each[1] for each in results]))
        if mean_return > self.curve.best_return:
            self.curve.best_return = mean_return
            self.curve.best = {name: value.copy()
                               for name, value in self.network.parameters.items()}
            name = self._options.policy
            (self._options.out / f"{name}.onnx").write_bytes(onnx_bytes(self.network, name))
        return outcomes, mean_return

    def imitate(self):
        """The first phase."""
        adam = Adam(self.network)
        rounds = self._options.imitation
        for number in range(rounds):
            share = max(0.2, 0.8 - number / 5)
            jobs = [(self.network, scene, first, share, seed)
                    for scene, first, seed in self._jobs(number)]
            results = self._pool.map(imitate, jobs, chunksize=1)
            self._memory += [each[0] for each in results]
            data = joined(self._memory)
            is_last = number == rounds - 1
            loss = self._fit(adam, data, 2, 1e-3)
            if is_last:
                for rate in (5e-4, 2e-4, 1e-4):
                    loss = self._fit(adam, data, 3, rate)
            outcomes, mean_return = numpy.concatenate([each[1] for each in results]), numpy.nan
            if is_last:
                outcomes, mean_return = self.validate()
            self.curve.add("imitation", number + 1, len(data["state"]), outcomes, mean_return, loss)
        self._memory = []

    def _fit(self, adam, data, epochs, rate):
        """Learns the teacher's decisions; returns the mean squared error of the last epoch."""
        target = numpy.clip((data["taught"] - ACTION_OFFSET) / ACTION_SCALE, -0.98, 0.98)
        inputs = self.network.inputs(data)
        for _ in range(epochs):
            total = 0.0
            for rows in self._batches(len(target), 256):
                output, kept = self.network.forward({key: each[rows]
                                                     for key, each in inputs.items()})
                value = numpy.tanh(output)
                error = value - target[rows]
                total += float(numpy.square(error).sum())
                slope = error * (1.0 - numpy.square(value)) / len(rows)
                adam.step(self.network.backward(kept, slope), rate)
        return total / len(target)

    def _batches(self, count, size):
        order = self._generator.permutation(count)
        return [order[start:start + size] for start in range(0, count, size)]

    def reinforce(self):
        """The second phase."""
        adam, critic_adam = Adam(self.network, 0.5), Adam(self._critic)
        rounds = self._options.reinforcement
        decisions = 0
        for number in range(rounds):
            jobs = [(self.network, self._critic, scene, first, seed)
                    for scene, first, seed in self._jobs(number)]
            results = self._pool.map(explore, jobs, chunksize=1)
            data = joined([each[0] for each in results])
            decisions += len(data["state"])
            inputs = self.network.inputs(data)
            loss = self._fit_critic(critic_adam, inputs, data["return"])
            if number >= 3:  # the critic knows the policy by then
                self._improve(adam, inputs, data)
            outcomes = numpy.concatenate([each[1] for each in results])
            mean_return = float(numpy.mean([each[2] for each in results]))
            self.curve.add("reinforcement", number + 1, decisions, outcomes, mean_return, loss)
            if number % 5 == 4 or number == rounds - 1:
                outcomes, mean_return = self.validate()
                print(f"  validation: success {numpy.mean(outcomes == 'arrived'):.3f}, "
                      f"return {mean_return:.3f}", flush=True)

    def _fit_critic(self, adam, inputs, returns):
        total = 0.0
        for _ in range(3):
            total = 0.0
            for rows in self._batches(len(returns), 512):
                value, kept = self._critic.forward({key: each[rows]
                                                    for key, each in inputs.items()})
                error = value - returns[rows, None]
                total += float(numpy.square(error).sum())
                adam.step(self._critic.backward(kept, error / len(rows)), 1e-3)
        return total / len(returns)

    def _improve(self, adam, inputs, data):
        """Steps of the clipped objective, until the policy has changed enough."""
        advantages = data["advantage"]
        advantages = (advantages - advantages.mean()) / (advantages.std() + 1e-6)
        for _ in range(4):
            changes = []
            for rows in self._batches(len(advantages), 512):
                output, kept = self.network.forward({key: each[rows]
                                                     for key, each in inputs.items()})
                value = numpy.tanh(output)
                offset = (data["done"][rows] - value) / SPREAD
                log_ratio = data["surprise"][rows] - 0.5 * numpy.square(offset).sum(axis=1)
                ratio, gain = numpy.exp(log_ratio), advantages[rows]
                changes.append(float(numpy.mean(ratio - 1.0 - log_ratio)))
                is_used = numpy.where(gain > 0, ratio < 1.0 + CLIP, ratio > 1.0 - CLIP)
                factor = -(gain * ratio * is_used) / len(rows)
                slope = factor[:, None] * offset / SPREAD * (1.0 - numpy.square(value))
                adam.step(self.network.backward(kept, slope.astype(numpy.float32)), RATE)
            if numpy.mean(changes) > 0.02:
                break


# --- The file -------------------------------------------------------------------------------------


def onnx_bytes(network, name):
    """The ONNX file of a policy."""
    graph = Graph(name)
    parts = [graph.input("state", [1, STATE]),
             graph.add("Flatten", [graph.input("people", [1, network.people, PERSON])],
                       "people_flat", axis=1)]
    if network.beams:
        parts.append(graph.input("lidar", [1, network.beams]))
    near, codes, first, second, out = network.dense_layers()
    values = graph.add("Concat", parts, "values", axis=1)
    bounded = graph.add("Tanh", [graph.dense(values, *near, "near")], "bounded")
    value = graph.add("Concat", [values, bounded], "features", axis=1)
    for title, layer in (("codes", codes), ("first", first), ("second", second)):
        value = graph.add("Relu", [graph.dense(value, *layer, title + "_sum")], title)
    normed = graph.add("Tanh", [graph.dense(value, *out, "out_sum")], "normed")
    graph.dense(normed, numpy.diag(ACTION_SCALE), ACTION_OFFSET, "action")
    graph.output("action", [1, 2])
    metadata = {"format": 1, "people": network.people, "beams": network.beams, "grid_cells": 0,
                "grid_resolution": 0.1, "repeat": REPEAT, "dt": DT, "actions": 2}
    return graph.model({"hunavsim_policy": json.dumps(metadata)})


def parse(arguments):
    """The options of the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("policy", choices=POLICIES)
    parser.add_argument("--out", type=Path, default=Path("."), help="folder (default: here)")
    parser.add_argument("--seed", type=int, default=1, help="of all random numbers (default: 1)")
    parser.add_argument("--imitation", type=int, help="rounds (default: the policy's)")
    parser.add_argument("--reinforcement", type=int, help="rounds (default: the policy's)")
    parser.add_argument("--validation", type=int, default=15, help="episodes per scene (15)")
    parser.add_argument("--scenes", nargs="+", metavar="NAME", help="instead of the policy's own")
    parser.add_argument("--processes", type=int, default=2, help="(default: 2)")
    options = parser.parse_args(arguments)
    for name in ("imitation", "reinforcement"):
        if getattr(options, name) is None:
            setattr(options, name, POLICIES[options.policy][name])
    if options.imitation < 1:
        parser.error("--imitation must be at least 1")
    return options


def main(arguments=None):
    """Trains one policy; returns its network."""
    options = parse(arguments)
    settings = dict(POLICIES[options.policy])
    if options.scenes:
        settings["scenes"] = {scene: 1 for scene in options.scenes}
    options.out.mkdir(parents=True, exist_ok=True)
    with multiprocessing.get_context("fork").Pool(options.processes) as pool:
        trainer = Trainer(settings, options, pool)
        trainer.imitate()
        trainer.reinforce()
    trainer.network.parameters = trainer.curve.best
    return trainer.network


if __name__ == "__main__":
    main()
