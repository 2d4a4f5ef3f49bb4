"""The network of the policies: one encoder for all people, one for the state, one for the lidar.

Each number x of an observation enters as (x / scale, tanh(x / near)), so that near places are seen
in detail. All people pass the same encoder together with the state, and their codes are added: the
order of people has no influence, and what is learned from one person holds for the others.

    codes   = [sum of relu(people, state), relu(state), relu(lidar)]
    outputs = relu(relu(codes)), 64 units each, then a linear layer

Gradients are computed by hand (`backward`); `dense_layers` gives the same function as four plain
dense layers, in which the weights of the people's encoder are repeated.
"""

import numpy

STATE, PERSON = 5, 5  # columns
PERSON_UNITS, STATE_UNITS, LIDAR_UNITS, HIDDEN = 24, 32, 48, 64
STATE_SCALES = numpy.array([[10.0, 10.0, 1.0, 1.0, 1.0], [2.0, 2.0, 0.5, 0.5, 1.0]], numpy.float32)
PERSON_SCALES = numpy.array([[5.0, 5.0, 1.0, 1.0, 0.3], [1.5, 1.5, 1.0, 1.0, 0.1]], numpy.float32)
LIDAR_SCALES = numpy.array([10.0, 1.5], numpy.float32)


def _both(values, scales):
    return numpy.concatenate([values / scales[0], numpy.tanh(values / scales[1])], axis=-1)


class Network:
    """Parameters by name (float32), made at random with a generator."""

    def __init__(self, people, beams, outputs, generator):
        self.people, self.beams, self.outputs = people, beams, outputs
        codes = PERSON_UNITS + STATE_UNITS + (LIDAR_UNITS if beams else 0)
        shapes = {"person": (2 * (PERSON + STATE), PERSON_UNITS), "state": (2 * STATE, STATE_UNITS)}
        if beams:
            shapes["lidar"] = (2 * beams, LIDAR_UNITS)
        shapes.update(codes=(codes, HIDDEN), hidden=(HIDDEN, HIDDEN), out=(HIDDEN, outputs))
        self.parameters = {}
        for name, shape in shapes.items():
            gain = 0.1 if name == "out" else numpy.sqrt(2.0)
            weights = generator.standard_normal(shape) * gain / numpy.sqrt(shape[0])
            self.parameters[name] = weights.astype(numpy.float32)
            self.parameters[name + "_bias"] = numpy.zeros(shape[1], numpy.float32)

    def inputs(self, observations):
        """The numbers that enter the encoders, from a dict of observations."""
        people = observations["people"][:, :self.people]
        result = {"state": _both(observations["state"], STATE_SCALES),
                  "person": _both(people, PERSON_SCALES)}
        if self.beams:
            result["lidar"] = _both(observations["lidar"], LIDAR_SCALES)
        return result

    def forward(self, inputs):
        """Outputs (rows, outputs), and what `backward` needs."""
        p = self.parameters
        own = inputs["state"] @ p["person"][2 * PERSON:] + p["person_bias"]
        rows = inputs["person"]
        flat = rows.reshape(-1, 2 * PERSON) @ p["person"][:2 * PERSON]
        each = numpy.maximum(flat.reshape(*rows.shape[:2], -1) + own[:, None], 0.0)
        codes = [each.sum(axis=1), numpy.maximum(inputs["state"] @ p["state"] + p["state_bias"], 0)]
        if self.beams:
            codes.append(numpy.maximum(inputs["lidar"] @ p["lidar"] + p["lidar_bias"], 0.0))
        codes = numpy.concatenate(codes, axis=1)
        first = numpy.maximum(codes @ p["codes"] + p["codes_bias"], 0.0)
        second = numpy.maximum(first @ p["hidden"] + p["hidden_bias"], 0.0)
        return second @ p["out"] + p["out_bias"], (inputs, each, codes, first, second)

    def backward(self, kept, slope):
        """Gradients of the parameters for the slope (rows, outputs) of a loss."""
        inputs, each, codes, first, second = kept
        p, gradients = self.parameters, {}

        def layer(name, values, slope):
            gradients[name] = values.T @ slope
            gradients[name + "_bias"] = slope.sum(axis=0)

        layer("out", second, slope)
        slope = (slope @ p["out"].T) * (second > 0)
        layer("hidden", first, slope)
        slope = (slope @ p["hidden"].T) * (first > 0)
        layer("codes", codes, slope)
        slope = slope @ p["codes"].T
        end = PERSON_UNITS + STATE_UNITS
        active = slope * (codes > 0)
        layer("state", inputs["state"], active[:, PERSON_UNITS:end])
        if self.beams:
            layer("lidar", inputs["lidar"], active[:, end:])
        people = slope[:, None, :PERSON_UNITS] * (each > 0)
        own = people.sum(axis=1)
        flat = inputs["person"].reshape(-1, 2 * PERSON)
        gradients["person"] = numpy.concatenate([flat.T @ people.reshape(-1, PERSON_UNITS),
                                                 inputs["state"].T @ own])
        gradients["person_bias"] = own.sum(axis=0)
        return gradients

    def dense_layers(self):
        """(weights, bias) of: near (before tanh), codes of all, first, second, outputs.

        The values x are state, people (row by row) and lidar behind each other; the second layer
        takes [x, tanh(near(x))].
        """
        p, count = self.parameters, self.people
        size = STATE + count * PERSON + self.beams
        scales = numpy.concatenate([STATE_SCALES, numpy.tile(PERSON_SCALES, count),
                                    numpy.tile(LIDAR_SCALES[:, None], self.beams)], axis=1)
        units = count * PERSON_UNITS
        width = units + STATE_UNITS + (LIDAR_UNITS if self.beams else 0)
        table = numpy.zeros((2, size, width), numpy.float32)  # of x / scale and tanh
        bias = numpy.zeros(width, numpy.float32)
        pick = numpy.zeros((width, PERSON_UNITS + width - units), numpy.float32)
        for index in range(count):
            block = slice(index * PERSON_UNITS, (index + 1) * PERSON_UNITS)
            place = slice(STATE + index * PERSON, STATE + (index + 1) * PERSON)
            table[:, place, block] = p["person"][:2 * PERSON].reshape(2, PERSON, -1)
            table[:, :STATE, block] = p["person"][2 * PERSON:].reshape(2, STATE, -1)
            bias[block] = p["person_bias"]
            pick[block, :PERSON_UNITS] = numpy.eye(PERSON_UNITS)
        end = units + STATE_UNITS
        table[:, :STATE, units:end] = p["state"].reshape(2, STATE, -1)
        bias[units:end] = p["state_bias"]
        if self.beams:
            table[:, STATE + count * PERSON:, end:] = p["lidar"].reshape(2, self.beams, -1)
            bias[end:] = p["lidar_bias"]
        pick[units:, PERSON_UNITS:] = numpy.eye(width - units)
        table[0] /= scales[0][:, None]
        return [(numpy.diag(1.0 / scales[1]), numpy.zeros(size, numpy.float32)),
                (table.reshape(2 * size, width), bias),
                (pick @ p["codes"], p["codes_bias"]), (p["hidden"], p["hidden_bias"]),
                (p["out"], p["out_bias"])]


class Adam:
    """Steps of Kingma and Ba 2015, with the gradient's norm limited."""

    def __init__(self, network, limit=1.0):
        self._network, self._limit, self._count = network, limit, 0
        zeros = numpy.zeros_like
        self._mean = {name: zeros(value) for name, value in network.parameters.items()}
        self._square = {name: zeros(value) for name, value in network.parameters.items()}

    def step(self, gradients, rate):
        """One step down the gradients."""
        self._count += 1
        norm = numpy.sqrt(sum(float(numpy.square(each).sum()) for each in gradients.values()))
        factor = min(1.0, self._limit / (norm + 1e-8))
        correction = numpy.sqrt(1.0 - 0.999**self._count) / (1.0 - 0.9**self._count)
        for name, gradient in gradients.items():
            gradient = gradient * numpy.float32(factor)
            mean, square = self._mean[name], self._square[name]
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (numpy.square(gradient) - square)
            self._network.parameters[name] -= numpy.float32(rate * correction) * mean / (
                numpy.sqrt(square) + numpy.float32(1e-8))
