#include "sim2d/nav/onnx/PolicyFile.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/onnx/ProtobufReader.h"

namespace sim2d {

namespace {

using PolicyJson = nlohmann::ordered_json;

constexpr int kPolicyFormat = 1;  // incremented by incompatible changes

struct PolicyKey {
  const char* key;
  base::Range range;
  bool isInteger;
};
constexpr PolicyKey kPolicyKeys[] = {{"format", base::kAnyNumber, true},
                                     {"people", {0.0, 10000.0}, true},
                                     {"beams", {0.0, 10000.0}, true},
                                     {"grid_cells", {0.0, 1000.0}, true},
                                     {"grid_resolution", {0.01, 10.0}, false},
                                     {"repeat", {1.0, 1000.0}, true},
                                     {"dt", {0.0001, 10.0}, false},
                                     {"actions", {2.0, 3.0}, true}};

/// Reads the numbers of the object in the order of kPolicyKeys.
class PolicyNumbers {
 public:
  PolicyNumbers(const PolicyJson& object, const std::string& file) : object_(object), file_(file) {
    for (const PolicyKey& key : kPolicyKeys) {
      read(key);
    }
    for (const auto& item : object.items()) {
      noteUnknown(item.key());
    }
  }

  double of(std::string_view key) const {
    for (std::size_t i = 0; i < std::size(kPolicyKeys); ++i) {
      if (key == kPolicyKeys[i].key) {
        return values_[i];
      }
    }
    return 0.0;
  }
  const base::Diagnostics& problems() const { return problems_; }

 private:
  void report(const char* code, base::ProblemValues values) {
    problems_.push_back(base::error(code, std::move(values), file_));
  }

  void read(const PolicyKey& key) {
    const auto found = object_.find(key.key);
    values_.push_back(0.0);
    if (found == object_.end()) {
      report("onnx.no-key", {key.key});
      return;
    }
    const std::string text = printableText(base::jsonText(*found, -1));
    if (key.isInteger ? !found->is_number_integer() : !found->is_number()) {
      report("onnx.wrong-type", {key.key, key.isInteger ? "an integer" : "a number", text});
      return;
    }
    values_.back() = found->get<double>();
    if (!key.range.contains(values_.back())) {
      report("onnx.out-of-range", {key.key, text, key.range.low, key.range.high});
    }
  }

  void noteUnknown(const std::string& key) {
    std::vector<std::string> known;
    for (const PolicyKey& each : kPolicyKeys) {
      known.emplace_back(each.key);
    }
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      report("onnx.unknown-key", {printableText(key), base::nearestName(key, known)});
    }
  }

  const PolicyJson& object_;
  const std::string& file_;
  std::vector<double> values_;
  base::Diagnostics problems_;
};

}  // namespace

base::Result<PolicyMetadata> parsePolicyMetadata(const std::string& text, const std::string& file) {
  const PolicyJson json =
      PolicyJson::parse(base::shallowJson(text), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) {
    return base::error("onnx.not-json", {printableText(text)}, file);
  }
  // Another format may have other keys.
  if (const auto format = json.find("format");
      format != json.end() && format->is_number_integer() && *format != kPolicyFormat) {
    return base::error("onnx.wrong-format",
                       {printableText(base::jsonText(*format, -1)), kPolicyFormat}, file);
  }
  const PolicyNumbers numbers(json, file);
  if (!numbers.problems().empty()) {
    return numbers.problems();
  }
  PolicyMetadata metadata;
  metadata.sizes.people = static_cast<std::size_t>(numbers.of("people"));
  metadata.sizes.beams = static_cast<std::size_t>(numbers.of("beams"));
  metadata.sizes.gridCells = static_cast<std::size_t>(numbers.of("grid_cells"));
  metadata.sizes.gridResolution = numbers.of("grid_resolution");
  metadata.repeat = static_cast<int>(numbers.of("repeat"));
  metadata.dt = numbers.of("dt");
  metadata.actions = static_cast<int>(numbers.of("actions"));
  return metadata;
}

std::vector<PolicyInput> policyInputsOf(const PolicySizes& sizes) {
  const auto number = [](std::size_t size) { return static_cast<int>(size); };
  std::vector<PolicyInput> inputs = {{"state", {1, number(kPolicyStateColumns)}}};
  if (sizes.people > 0) {
    inputs.push_back({"people", {1, number(sizes.people), number(kPolicyPersonColumns)}});
  }
  if (sizes.beams > 0) {
    inputs.push_back({"lidar", {1, number(sizes.beams)}});
  }
  if (sizes.gridCells > 0) {
    inputs.push_back({"grid", {1, 1, number(sizes.gridCells), number(sizes.gridCells)}});
  }
  return inputs;
}

namespace {

/// A tensor that a graph declares as input or output: ValueInfoProto of onnx.proto.
struct DeclaredTensor {
  std::string name;
  std::uint64_t elementType = 0;    // TensorProto.DataType; 0: not declared
  std::vector<std::int64_t> shape;  // 0: any size
  bool hasShape = false;
};

/// The parts of a ModelProto that are read here.
struct OnnxModel {
  bool hasGraph = false;
  bool isDamaged = false;
  std::optional<std::string> metadata;
  std::vector<DeclaredTensor> inputs, outputs;
  std::vector<std::string> initializers;  // weights; old files list them as inputs too
};

/// Calls visit(field) for each field; false if the message is damaged.
template <class Visit>
bool forEachField(std::string_view message, Visit visit) {
  ProtobufReader reader(message);
  while (const std::optional<ProtobufField> field = reader.next()) {
    visit(*field);
  }
  return !reader.isDamaged();
}

/// The text or message with that number; empty if there is none.
std::string_view bytesOf(std::string_view message, std::uint64_t number) {
  std::string_view found;
  forEachField(message, [&](const ProtobufField& field) {
    if (field.number == number && field.hasBytes) {
      found = field.bytes;
    }
  });
  return found;
}

/// The integer with that number; 0 if there is none.
std::uint64_t numberOf(std::string_view message, std::uint64_t number) {
  std::uint64_t found = 0;
  forEachField(message, [&](const ProtobufField& field) {
    if (field.number == number && field.isVarint) {
      found = field.value;
    }
  });
  return found;
}

DeclaredTensor declaredTensor(std::string_view message) {
  constexpr std::uint64_t kName = 1, kType = 2, kTensorType = 1, kElementType = 1, kShape = 2,
                          kDim = 1, kSize = 1;
  DeclaredTensor tensor;
  tensor.name = std::string(bytesOf(message, kName));
  const std::string_view type = bytesOf(bytesOf(message, kType), kTensorType);
  tensor.elementType = numberOf(type, kElementType);
  forEachField(bytesOf(type, kShape), [&](const ProtobufField& dim) {
    if (dim.number == kDim && dim.hasBytes) {
      tensor.shape.push_back(static_cast<std::int64_t>(numberOf(dim.bytes, kSize)));
      tensor.hasShape = true;
    }
  });
  return tensor;
}

void readGraph(std::string_view graph, OnnxModel& model) {
  constexpr std::uint64_t kInitializer = 5, kInput = 11, kOutput = 12, kTensorName = 8;
  model.hasGraph = true;
  model.isDamaged |= !forEachField(graph, [&](const ProtobufField& field) {
    if (field.number == kInitializer) {
      model.initializers.emplace_back(bytesOf(field.bytes, kTensorName));
    } else if (field.number == kInput) {
      model.inputs.push_back(declaredTensor(field.bytes));
    } else if (field.number == kOutput) {
      model.outputs.push_back(declaredTensor(field.bytes));
    }
  });
}

OnnxModel readModel(std::string_view bytes) {
  constexpr std::uint64_t kGraph = 7, kMetadata = 14, kKey = 1, kValue = 2;
  OnnxModel model;
  model.isDamaged = !forEachField(bytes, [&](const ProtobufField& field) {
    if (field.number == kGraph && field.hasBytes) {
      readGraph(field.bytes, model);
    } else if (field.number == kMetadata && bytesOf(field.bytes, kKey) == kPolicyMetadataKey) {
      model.metadata = std::string(bytesOf(field.bytes, kValue));
    }
  });
  return model;
}

/// Names of TensorProto.DataType.
std::string elementTypeName(const DeclaredTensor& tensor) {
  static constexpr const char* kNames[] = {"",           "float32", "uint8",  "int8",   "uint16",
                                           "int16",      "int32",   "int64",  "string", "bool",
                                           "float16",    "float64", "uint32", "uint64", "complex64",
                                           "complex128", "bfloat16"};
  return tensor.elementType < std::size(kNames) ? kNames[tensor.elementType]
                                                : "type " + std::to_string(tensor.elementType);
}

std::string shapeText(const std::vector<std::int64_t>& shape) {
  std::vector<std::string> sizes;
  sizes.reserve(shape.size());
  for (const std::int64_t size : shape) {
    sizes.push_back(size > 0 ? std::to_string(size) : "?");
  }
  return "[" + base::join(sizes, ", ") + "]";
}

/// A size of 0 fits any other one.
bool doesFit(const std::vector<std::int64_t>& declared, const std::vector<std::int64_t>& wanted) {
  return declared.size() == wanted.size() &&
         std::equal(declared.begin(), declared.end(), wanted.begin(),
                    [](std::int64_t a, std::int64_t b) { return a <= 0 || a == b; });
}

void checkTensor(const DeclaredTensor& tensor, const std::vector<std::int64_t>& wanted,
                 const std::string& file, base::Diagnostics& problems) {
  constexpr std::uint64_t kFloat = 1;
  if (tensor.elementType != 0 && tensor.elementType != kFloat) {
    problems.push_back(
        base::error("onnx.wrong-element-type", {tensor.name, elementTypeName(tensor)}, file));
  }
  if (tensor.hasShape && !doesFit(tensor.shape, wanted)) {
    problems.push_back(base::error(
        "onnx.wrong-shape", {tensor.name, shapeText(tensor.shape), shapeText(wanted)}, file));
  }
}

base::Diagnostics tensorProblems(const OnnxModel& model, const PolicyMetadata& metadata,
                                 const std::string& file) {
  base::Diagnostics problems;
  const std::vector<PolicyInput> wanted = policyInputsOf(metadata.sizes);
  for (const PolicyInput& input : wanted) {
    const auto found = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&](const auto& each) { return each.name == input.name; });
    if (found == model.inputs.end()) {
      problems.push_back(base::error("onnx.no-input", {input.name}, file));
    } else {
      checkTensor(*found, {input.shape.begin(), input.shape.end()}, file, problems);
    }
  }
  for (const DeclaredTensor& input : model.inputs) {
    const auto isSame = [&](const PolicyInput& each) { return input.name == each.name; };
    const bool isWeight = std::find(model.initializers.begin(), model.initializers.end(),
                                    input.name) != model.initializers.end();
    if (!isWeight && std::none_of(wanted.begin(), wanted.end(), isSame)) {
      problems.push_back(base::error("onnx.unknown-input", {printableText(input.name)}, file));
    }
  }
  if (model.outputs.size() != 1 || model.outputs.front().name != kPolicyOutput) {
    problems.push_back(base::error("onnx.wrong-output", {kPolicyOutput}, file));
  } else {
    checkTensor(model.outputs.front(), {1, metadata.actions}, file, problems);
  }
  return problems;
}

}  // namespace

base::Result<PolicyMetadata> readPolicyMetadata(std::string_view model, const std::string& file) {
  const OnnxModel parts = readModel(model);
  if (!parts.hasGraph || parts.isDamaged) {
    return base::error("onnx.no-onnx", {}, file);
  }
  if (!parts.metadata) {
    return base::error("onnx.no-metadata", {kPolicyMetadataKey}, file);
  }
  base::Result<PolicyMetadata> metadata = parsePolicyMetadata(*parts.metadata, file);
  if (!metadata) {
    return metadata;
  }
  const base::Diagnostics problems = tensorProblems(parts, *metadata, file);
  return problems.empty() ? metadata : base::Result<PolicyMetadata>(problems);
}

}  // namespace sim2d
