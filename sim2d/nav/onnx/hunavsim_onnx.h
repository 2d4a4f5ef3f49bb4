#pragma once

#include <stddef.h>  // NOLINT(modernize-deprecated-headers): C on both sides
#include <stdint.h>  // NOLINT(modernize-deprecated-headers)

/// The interface of the shared module hunavsim_onnx, which runs networks with OpenCV. It is loaded
/// when a planner needs it, so that the program does not depend on OpenCV. Errors are texts; no
/// exception leaves the module.

/* NOLINTBEGIN(readability-identifier-naming): C names */
#ifdef __cplusplus
extern "C" {
#endif

#define HUNAVSIM_ONNX_ABI 1

typedef struct hunavsim_onnx_network hunavsim_onnx_network;

/// An input of the network: its name, and its shape including the batch (1).
typedef struct {
  const char* name;
  const int32_t* shape;
  int32_t dimensions;
} hunavsim_onnx_input;

/// The value of HUNAVSIM_ONNX_ABI that the module was built with.
int32_t hunavsim_onnx_abi(void);

/// Version of OpenCV, for example "4.6.0".
const char* hunavsim_onnx_opencv(void);

/// Reads a model from `bytes`. Null: an error, whose text is written to `error` (at most
/// `error_size` bytes, ending with 0). The inputs' names and shapes are copied.
hunavsim_onnx_network* hunavsim_onnx_load(const char* bytes, size_t size,
                                          const hunavsim_onnx_input* inputs, size_t input_count,
                                          char* error, size_t error_size);

/// Computes the output from one array of values per input and writes its `action_count` values to
/// `action`. 0: success. Equal inputs give equal bits; on another processor the last bits of
/// functions such as tanh, which the C library computes, may differ. A network is used by one
/// thread at a time; different ones at the same time.
int32_t hunavsim_onnx_run(hunavsim_onnx_network* network, const float* const* inputs, float* action,
                          size_t action_count, char* error, size_t error_size);

void hunavsim_onnx_destroy(hunavsim_onnx_network* network);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming) */
