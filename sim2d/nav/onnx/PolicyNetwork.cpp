#include "sim2d/nav/onnx/PolicyNetwork.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <dlfcn.h>
#include <filesystem>
#include <utility>

#include "sim2d/base/ProgramFile.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/onnx/hunavsim_onnx.h"

namespace sim2d {

namespace {

namespace fs = std::filesystem;

constexpr const char* kModuleName = "hunavsim_onnx.so";

/// The functions of the module.
struct PolicyModule {
  decltype(&hunavsim_onnx_abi) abi = nullptr;
  decltype(&hunavsim_onnx_opencv) opencv = nullptr;
  decltype(&hunavsim_onnx_load) load = nullptr;
  decltype(&hunavsim_onnx_run) run = nullptr;
  decltype(&hunavsim_onnx_destroy) destroy = nullptr;

  bool isComplete() const {
    return abi != nullptr && abi() == HUNAVSIM_ONNX_ABI && opencv != nullptr && load != nullptr &&
           run != nullptr && destroy != nullptr;
  }
};

template <class Function>
void findModuleFunction(void* handle, const char* name, Function& to) {
  to = reinterpret_cast<Function>(::dlsym(handle, name));
}

/// Loads the module. It stays loaded: OpenCV's libraries cannot be unloaded safely.
base::Result<PolicyModule> loadPolicyModule() {
  const std::string file = policyModuleFile();
  if (file.empty()) {
    return base::error("onnx.no-module", {std::string(kModuleName) + " was not found"});
  }
  void* const handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) {
    const char* const why = ::dlerror();  // thread-local
    return base::error("onnx.no-module", {printableText(why == nullptr ? file : why)});
  }
  PolicyModule module;
  findModuleFunction(handle, "hunavsim_onnx_abi", module.abi);
  findModuleFunction(handle, "hunavsim_onnx_opencv", module.opencv);
  findModuleFunction(handle, "hunavsim_onnx_load", module.load);
  findModuleFunction(handle, "hunavsim_onnx_run", module.run);
  findModuleFunction(handle, "hunavsim_onnx_destroy", module.destroy);
  ::dlclose(handle);
  if (!module.isComplete()) {
    return base::error("onnx.no-module", {file + " belongs to another version of this program"});
  }
  return module;
}

class OnnxNetwork : public PolicyNetwork {
 public:
  OnnxNetwork(std::string file, const PolicyMetadata& metadata, const PolicyModule& module,
              hunavsim_onnx_network* network)
      : file_(std::move(file)), metadata_(metadata), module_(module), network_(network) {}
  ~OnnxNetwork() override { module_.destroy(network_); }
  OnnxNetwork(const OnnxNetwork&) = delete;
  OnnxNetwork& operator=(const OnnxNetwork&) = delete;
  OnnxNetwork(OnnxNetwork&&) = delete;
  OnnxNetwork& operator=(OnnxNetwork&&) = delete;

  const PolicyMetadata& metadata() const override { return metadata_; }

  base::Result<std::vector<float>> action(const PolicyObservation& observation) override {
    std::vector<const float*> inputs;  // in the order of policyInputsOf
    for (const std::vector<float>* const values :
         {&observation.state, &observation.people, &observation.lidar, &observation.grid}) {
      if (!values->empty()) {
        inputs.push_back(values->data());
      }
    }
    std::vector<float> action(static_cast<std::size_t>(metadata_.actions));
    std::array<char, kErrorSize> text{};
    if (module_.run(network_, inputs.data(), action.data(), action.size(), text.data(),
                    text.size()) != 0) {
      return base::error("onnx.not-run", {printableText(text.data())}, file_);
    }
    if (!std::all_of(action.begin(), action.end(), [](float v) { return std::isfinite(v); })) {
      return base::error("onnx.not-finite", {}, file_);
    }
    return action;
  }

  static constexpr std::size_t kErrorSize = 1000;

 private:
  const std::string file_;
  const PolicyMetadata metadata_;
  const PolicyModule module_;
  hunavsim_onnx_network* const network_;
};

base::Result<std::unique_ptr<PolicyNetwork>> loadOnnxNetwork(const std::string& model,
                                                             const std::string& file,
                                                             const PolicyMetadata& metadata) {
  const base::Result<PolicyModule> module = loadPolicyModule();
  if (!module) {
    return module.diagnostics();
  }
  const std::vector<PolicyInput> inputs = policyInputsOf(metadata.sizes);
  std::vector<hunavsim_onnx_input> plain;
  plain.reserve(inputs.size());
  for (const PolicyInput& input : inputs) {
    plain.push_back({input.name, input.shape.data(), static_cast<int32_t>(input.shape.size())});
  }
  std::array<char, OnnxNetwork::kErrorSize> text{};
  hunavsim_onnx_network* const network = module->load(model.data(), model.size(), plain.data(),
                                                      plain.size(), text.data(), text.size());
  if (network == nullptr) {
    return base::error("onnx.not-loaded", {printableText(text.data())}, file);
  }
  std::unique_ptr<PolicyNetwork> made =
      std::make_unique<OnnxNetwork>(file, metadata, *module, network);
  const base::Result<std::vector<float>> action = made->action(PolicyObservation(metadata.sizes));
  return action ? base::Result<std::unique_ptr<PolicyNetwork>>(std::move(made))
                : action.diagnostics();
}

}  // namespace

base::Result<std::unique_ptr<PolicyNetwork>> readPolicyNetwork(const std::string& file) {
  const base::Result<std::string> model = base::readTextFile(file);
  if (!model) {
    return model.diagnostics();
  }
  const base::Result<PolicyMetadata> metadata = readPolicyMetadata(*model, file);
  return metadata ? loadOnnxNetwork(*model, file, *metadata) : metadata.diagnostics();
}

std::string policyModuleFile() {
  std::error_code error;
  const fs::path own = fs::weakly_canonical(base::codeFile(), error).parent_path();
  if (fs::is_regular_file(own / kModuleName, error)) {
    return (own / kModuleName).string();
  }
  for (fs::path folder = own; folder.has_relative_path(); folder = folder.parent_path()) {
    const fs::path file = folder / "lib/hunavsim" / kModuleName;
    if (fs::is_regular_file(file, error)) {
      return file.string();
    }
  }
  return {};
}

base::Result<std::string> policyModuleVersion() {
  const base::Result<PolicyModule> module = loadPolicyModule();
  if (!module) {
    return module.diagnostics();
  }
  return std::string("OpenCV ") + module->opencv();
}

}  // namespace sim2d
