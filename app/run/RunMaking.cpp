#include "app/run/RunMaking.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/KnownFiles.h"
#include "app/run/RunAgain.h"
#include "sim2d/base/Text.h"

namespace app {

base::Result<RunMaking> makingOf(const std::string& folder, const RunWordsReader& readWords,
                                 const sim2d::ImageLoader& loader) {
  RunOptions on;
  on.from = folder + "@0";
  const base::Result<std::vector<RunStage>> stages = stagesOf(on, readWords);
  if (!stages) {
    return stages.diagnostics();
  }
  KnownFiles files(loader);
  RunMaking making;
  double dt = 0.0;
  for (std::size_t k = 0; k + 1 < stages->size(); ++k) {  // the last is the one that goes on
    const RunStage& stage = (*stages)[k];
    if (k > 0) {
      ForkStage& fork = making.stages.emplace_back();
      fork.step = std::llround(stage.moment->time / dt);
      fork.options = stage.options.then.back();
      fork.options.seed = stage.drawSeed;
      continue;
    }
    const base::Result<RunSettings> settings = runSettingsOf(stage.options);
    if (!settings) {
      return settings.diagnostics();
    }
    making.bundle = readBundle(stage.options, *settings, files);
    base::Diagnostics problems = errorsOf(making.bundle.remarks);
    base::append(problems, making.bundle.wrongWords);
    if (!base::hasErrors(problems)) {
      problems = changedInputs(making.bundle, stage.inputs, stage.folder);
    }
    if (base::hasErrors(problems)) {
      return problems;
    }
    dt = making.bundle.scenario->desktop.dt.value_or(0.05);
  }
  return making;
}

base::Diagnostics otherProgram(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "manifest.json").string();
  const base::Result<std::string> text = base::readTextFile(path);
  const auto manifest = nlohmann::json::parse(text ? *text : "", nullptr, false);
  const nlohmann::json::json_pointer at("/program/version");
  if (!manifest.is_object() || !manifest.contains(at) || !manifest[at].is_string()) {
    return {};
  }
  const auto version = manifest[at].get<std::string>();
  return version == programVersion()
             ? base::Diagnostics()
             : base::Diagnostics{
                   base::warning("trace.other-program", {version, programVersion()}, path)};
}

}  // namespace app
