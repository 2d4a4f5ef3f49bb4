"""Reads the ONNX files of train.py and computes their actions with numpy."""

import json

import numpy


def fields(data):
    """(number, value) of the fields of a protobuf message: whole numbers, bytes, or 4 or 8 bytes."""
    place = 0

    def varint():
        nonlocal place
        value, shift = 0, 0
        while True:
            byte = data[place]
            place += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    while place < len(data):
        key = varint()
        kind = key & 7
        if kind == 0:
            yield key >> 3, varint()
            continue
        length = varint() if kind == 2 else {1: 8, 5: 4}[kind]
        yield key >> 3, data[place:place + length]
        place += length


def _groups(data):
    result = {}
    for number, value in fields(data):
        result.setdefault(number, []).append(value)
    return result


def _text(message, number):
    return message[number][0].decode()


def _tensor(data):
    message = _groups(data)
    return _text(message, 8), numpy.frombuffer(message[9][0], "<f4").reshape(message[1])


class Policy:
    """A policy from a file: `policy(observations)` returns actions (rows, 2)."""

    def __init__(self, path):
        model = _groups(path.read_bytes())
        graph = _groups(model[7][0])
        entries = [_groups(entry) for entry in model.get(14, [])]
        texts = {_text(entry, 1): _text(entry, 2) for entry in entries}
        self.settings = json.loads(texts["hunavsim_policy"])
        self._weights = dict(_tensor(data) for data in graph[5])
        self._inputs = [_text(_groups(data), 1) for data in graph[11]]
        self._output = _text(_groups(graph[12][0]), 1)
        self._nodes = []
        for data in graph[1]:
            node = _groups(data)
            self._nodes.append((_text(node, 4), [each.decode() for each in node[1]],
                                _text(node, 2)))

    def __call__(self, observations):
        values = {**self._weights, **{name: observations[name] for name in self._inputs}}
        operations = {
            "Flatten": lambda x: x.reshape(len(x), -1),
            "Concat": lambda *parts: numpy.concatenate(parts, axis=1),
            "Gemm": lambda x, weights, bias: x @ weights.T + bias,
            "Relu": lambda x: numpy.maximum(x, 0.0),
            "Tanh": numpy.tanh,
        }
        for operation, inputs, output in self._nodes:
            values[output] = operations[operation](*[values[name] for name in inputs])
        return values[self._output]
