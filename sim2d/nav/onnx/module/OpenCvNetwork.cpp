// The module hunavsim_onnx; see hunavsim_onnx.h.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

#include "sim2d/nav/onnx/hunavsim_onnx.h"

struct hunavsim_onnx_network {
  struct Input {
    std::string name;
    std::vector<int> shape;
  };
  std::vector<Input> inputs;
  std::string output;
  cv::dnn::Net net;
};

namespace {

void write(const char* text, char* error, size_t size) {
  if (size > 0) {
    std::snprintf(error, size, "%s", text);
  }
}

/// Calls work() and returns its result; after an exception writes its text and returns `failed`.
template <class Work, class Value>
Value guarded(Work work, Value failed, char* error, size_t size) {
  try {
    return work();
  } catch (const cv::Exception& problem) {
    // Without the place in OpenCV's sources.
    write(problem.err.empty() ? problem.what() : problem.err.c_str(), error, size);
  } catch (const std::exception& problem) {
    write(problem.what(), error, size);
  } catch (...) {
    write("unknown exception", error, size);
  }
  return failed;
}

/// One thread, and OpenCV's same code on every processor: sums have one order.
void configureOpenCv() {
  static std::once_flag done;
  std::call_once(done, [] {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    cv::setNumThreads(0);
    cv::setUseOptimized(false);
  });
}

std::unique_ptr<hunavsim_onnx_network> load(const char* bytes, size_t size,
                                            const hunavsim_onnx_input* inputs, size_t count) {
  configureOpenCv();
  auto network = std::make_unique<hunavsim_onnx_network>();
  network->net = cv::dnn::readNetFromONNX(bytes, size);
  network->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  network->net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  for (size_t i = 0; i < count; ++i) {
    network->inputs.push_back(
        {inputs[i].name, {inputs[i].shape, inputs[i].shape + inputs[i].dimensions}});
  }
  const std::vector<cv::String> outputs = network->net.getUnconnectedOutLayersNames();
  if (outputs.size() != 1) {
    CV_Error(cv::Error::StsBadArg,
             "the network has " + std::to_string(outputs.size()) + " outputs instead of 1");
  }
  network->output = outputs.front();
  return network;
}

int32_t run(hunavsim_onnx_network& network, const float* const* values, float* action,
            size_t count) {
  for (size_t i = 0; i < network.inputs.size(); ++i) {
    const hunavsim_onnx_network::Input& input = network.inputs[i];
    // OpenCV copies the values into the network and does not change them.
    network.net.setInput(cv::Mat(input.shape, CV_32F, const_cast<float*>(values[i])), input.name);
  }
  const cv::Mat output = network.net.forward(network.output);
  if (output.total() != count || output.type() != CV_32F || !output.isContinuous()) {
    CV_Error(cv::Error::StsBadSize, "the output has " + std::to_string(output.total()) +
                                        " values instead of " + std::to_string(count));
  }
  std::copy_n(output.ptr<float>(), count, action);
  return 0;
}

}  // namespace

int32_t hunavsim_onnx_abi() {
  return HUNAVSIM_ONNX_ABI;
}

const char* hunavsim_onnx_opencv() {
  return CV_VERSION;
}

hunavsim_onnx_network* hunavsim_onnx_load(const char* bytes, size_t size,
                                          const hunavsim_onnx_input* inputs, size_t inputCount,
                                          char* error, size_t errorSize) {
  return guarded([&] { return load(bytes, size, inputs, inputCount).release(); },
                 static_cast<hunavsim_onnx_network*>(nullptr), error, errorSize);
}

int32_t hunavsim_onnx_run(hunavsim_onnx_network* network, const float* const* inputs, float* action,
                          size_t actionCount, char* error, size_t errorSize) {
  return guarded([&] { return run(*network, inputs, action, actionCount); }, int32_t{1}, error,
                 errorSize);
}

void hunavsim_onnx_destroy(hunavsim_onnx_network* network) {
  delete network;
}
