#include "app/capsule/UnpackedInputs.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/capsule/Unpacked.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/JsonText.h"

namespace capsule {

namespace {

using UnpackedJson = nlohmann::json;

/// Without external code, which may have been left out.
std::vector<app::InputHash> packedOnly(std::vector<app::InputHash> used,
                                       const CapsuleManifest& manifest) {
  const bool hasOmitted = omittedCode(manifest) != nullptr;
  used.erase(std::remove_if(used.begin(), used.end(),
                            [hasOmitted](const app::InputHash& input) {
                              return hasOmitted && input.sha256.empty();
                            }),
             used.end());
  return used;
}

base::Diagnostics checkBatch(const CapsuleManifest& manifest, const std::string& root,
                             const std::string& file, const sim2d::ImageLoader& loader) {
  base::Result<app::Experiment> experiment =
      app::readExperiment(pathOfInput(manifest.inputs.front(), root));
  if (!experiment) {
    return experiment.diagnostics();
  }
  experiment->allowCode = true;  // nothing is started here
  app::ExperimentRunner runner(*experiment, {}, loader);
  base::Diagnostics problems =
      app::errorsOf(runner.check(base::Severity::Info, app::ExperimentRunner::Checked::FirstRuns));
  base::append(problems,
               foreignInputs(packedOnly(runner.inputs(), manifest), manifest, root, file));
  return problems;
}

base::Diagnostics checkRun(const CapsuleManifest& manifest, const std::string& root,
                           const std::string& file, const sim2d::ImageLoader& loader) {
  const base::Result<app::RunSpec> spec = specOfUnpackedRun(manifest, root);
  const base::Result<app::RunSettings> settings =
      spec ? app::runSettingsOf(*spec) : base::Result<app::RunSettings>(spec.diagnostics());
  if (!settings) {
    return settings.diagnostics();
  }
  const app::Bundle bundle = app::readBundle(*spec, *settings, loader);
  base::Diagnostics problems = app::errorsOf(bundle.remarks);
  base::append(problems, app::errorsOf(bundle.wrongOptions));
  std::vector<app::InputHash> used;
  for (const std::string& path : app::inputsOf(bundle)) {
    used.push_back({path, app::sha256OfFile(path).value_or("")});
  }
  base::append(problems, foreignInputs(used, manifest, root, file));
  return problems;
}

}  // namespace

base::Result<app::RunSpec> specOfUnpackedRun(const CapsuleManifest& manifest,
                                             const std::string& root) {
  const std::string folder = app::pathIn(root, "study");
  const base::Result<app::Manifest> ofRun = app::readManifest(folder);
  if (!ofRun) {
    return ofRun.diagnostics();
  }
  std::vector<std::string> words;
  try {
    words = UnpackedJson::parse(base::shallowJson(ofRun->text))
                .at("command_line")
                .get<std::vector<std::string>>();
  } catch (const UnpackedJson::exception&) {
    return base::error("trace.bad-manifest", {}, app::pathIn(folder, app::Manifest::kName));
  }
  words.erase(words.begin(), words.begin() + (words.empty() ? 0 : 1));
  base::Result<app::RunSpec> spec = app::runSpecOfCommandLine(words);
  if (spec) {
    spec->scenario = pathOfInput(manifest.inputs.front(), root);
  }
  return spec;
}

base::Diagnostics checkUnpackedInputs(const CapsuleManifest& manifest, const std::string& root,
                                      const std::string& file, const sim2d::ImageLoader& loader) {
  const app::DataFolderOverride shipped(app::pathIn(root, kSharedFolder));
  return manifest.isBatch ? checkBatch(manifest, root, file, loader)
                          : checkRun(manifest, root, file, loader);
}

}  // namespace capsule
