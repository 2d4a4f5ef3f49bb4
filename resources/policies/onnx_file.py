"""Writes a chain of ONNX operations as a file: the few messages of onnx.proto3 that it needs.

Field numbers are those of https://github.com/onnx/onnx/blob/main/onnx/onnx.proto3 (IR version 7,
operator set 11, which OpenCV 4.6 reads).
"""

import numpy

_FLOAT = 1  # TensorProto.DataType
_ATTRIBUTE_INT = 2  # AttributeProto.AttributeType


def _varint(value):
    result = bytearray()
    while value >= 0x80:
        result.append(value & 0x7F | 0x80)
        value >>= 7
    result.append(value)
    return bytes(result)


def _number(field, value):
    return _varint(field << 3) + _varint(value)


def _bytes(field, value):
    data = value.encode() if isinstance(value, str) else value
    return _varint(field << 3 | 2) + _varint(len(data)) + data


def _tensor(name, array):
    data = numpy.ascontiguousarray(array, "<f4")
    sizes = b"".join(_number(1, size) for size in data.shape)
    return sizes + _number(2, _FLOAT) + _bytes(8, name) + _bytes(9, data.tobytes())


def _value_info(name, shape):
    sizes = b"".join(_bytes(1, _number(1, size)) for size in shape)
    return _bytes(1, name) + _bytes(2, _bytes(1, _number(1, _FLOAT) + _bytes(2, sizes)))


def _node(operation, inputs, output, attributes):
    fields = [_bytes(1, each) for each in inputs] + [_bytes(2, output), _bytes(3, output),
                                                     _bytes(4, operation)]
    for name, value in attributes.items():
        fields.append(_bytes(5, _bytes(1, name) + _number(3, value)
                             + _number(20, _ATTRIBUTE_INT)))
    return b"".join(fields)


class Graph:
    """Operations in the order in which they are computed; all values are float32."""

    def __init__(self, name):
        self._name = name
        self._nodes, self._weights, self._inputs, self._outputs = [], [], [], []

    def input(self, name, shape):
        """Adds an input; returns its name."""
        self._inputs.append(_bytes(11, _value_info(name, shape)))
        return name

    def add(self, operation, inputs, output, **attributes):
        """Adds an operation with whole-numbered attributes; returns the name of its output."""
        self._nodes.append(_bytes(1, _node(operation, inputs, output, attributes)))
        return output

    def dense(self, value, weights, bias, output):
        """Adds output = value @ weights + bias, as Gemm; returns its name."""
        # Transposed: OpenCV 4.6 does not know the default of transB.
        self._weights.append(_bytes(5, _tensor(output + "_weights", numpy.transpose(weights))))
        self._weights.append(_bytes(5, _tensor(output + "_bias", bias)))
        return self.add("Gemm", [value, output + "_weights", output + "_bias"], output,
                        transB=1)

    def output(self, name, shape):
        """Declares a computed value as an output."""
        self._outputs.append(_bytes(12, _value_info(name, shape)))

    def model(self, metadata):
        """The bytes of the file (ModelProto); metadata: a dict of texts."""
        graph = b"".join([*self._nodes, _bytes(2, self._name), *self._weights, *self._inputs,
                          *self._outputs])
        parts = [_number(1, 7), _bytes(2, "hunavsim"), _bytes(7, graph),
                 _bytes(8, _bytes(1, "") + _number(2, 11))]
        parts += [_bytes(14, _bytes(1, key) + _bytes(2, text)) for key, text in metadata.items()]
        return b"".join(parts)
