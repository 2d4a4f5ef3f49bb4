#include "app/run/RunStages.h"

#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/ListedFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using StageJson = nlohmann::json;

constexpr int kMostStages = 100;  // a folder that goes on from itself would have no end

/// From where the run was started, or beside its folder.
std::string placeOf(const std::string& named, const fs::path& folder) {
  std::error_code none;
  for (const fs::path& path : {fs::path(named), folder / named, folder / ".." / named}) {
    if (!named.empty() && fs::exists(path, none)) {
      return path.string();
    }
  }
  return named;
}

/// `was` with what `is` says beside it.
RunOptions goingOn(const RunOptions& was, const RunOptions& is) {
  RunOptions all = was;
  RunOptions& later = all.then.emplace_back(is);
  later.seed.reset();  // that of the people stays
  if (!is.metrics.metrics.empty()) {
    all.metrics.metrics = is.metrics.metrics;
  }
  if (is.metrics.profile != MetricsWords().profile) {
    all.metrics.profile = is.metrics.profile;
  }
  return all;
}

/// How the run of a folder was made.
struct Making {
  RunOptions options;
  std::string folder;
  std::vector<std::string> inputs;  // SHA-256
  std::string version;
};

base::Result<Making> readMaking(const std::string& folder, const RunWordsReader& readWords) {
  const base::Result<std::string> text = manifestText(folder, "manifest.json");
  if (!text) {
    return text.diagnostics();
  }
  const StageJson manifest = StageJson::parse(*text, nullptr, false);
  Making making;
  std::vector<std::string> words, paths;
  try {
    words = manifest.at("command_line").get<std::vector<std::string>>();
    making.version = manifest.at("program").at("version").get<std::string>();
    for (const StageJson& input : manifest.at("inputs")) {
      paths.push_back(input.at("path").get<std::string>());
      making.inputs.push_back(input.at("sha256").get<std::string>());
    }
  } catch (const StageJson::exception&) {
    return base::error("again.not-told", {}, folder);
  }
  words.erase(words.begin(), words.begin() + (words.empty() ? 0 : 1));
  base::Result<RunOptions> options = readWords(words);
  if (!options) {
    return base::error("again.not-told", {}, folder);
  }
  making.options = *std::move(options);
  making.folder = folder;
  if (making.options.scenario == kStandardInput) {
    return base::error("again.standard-input", {}, folder);
  }
  if (!making.options.scenario.empty() && !paths.empty()) {
    making.options.scenario =
        findInput(making.options.scenario, folder, making.inputs.front()).value_or(paths.front());
  }
  for (std::string* path :
       {&making.options.map, &making.options.trees, &making.options.metrics.metrics}) {
    *path = placeOf(*path, folder);
  }
  return making;
}

/// Of the run that the options go on from, then of the one before that, to one from the beginning.
base::Result<std::vector<Making>> makingsBefore(const RunOptions& options,
                                                const RunWordsReader& readWords) {
  std::vector<Making> makings;
  for (std::string from = options.from; !from.empty(); from = makings.back().options.from) {
    const std::optional<RunMoment> moment = runMomentOf(from);
    const std::string child = makings.empty() ? "" : makings.back().folder;
    if (!moment || makings.size() >= kMostStages) {
      return base::error("again.no-beginning", {}, child);
    }
    base::Result<Making> making =
        readMaking(makings.empty() ? moment->folder : placeOf(moment->folder, child), readWords);
    if (!making) {
      return making.diagnostics();
    }
    makings.push_back(*std::move(making));
  }
  return makings;
}

/// What can change on the way, as it is by itself.
sim2d::Scenario fixedPart(sim2d::Scenario scenario) {
  for (sim2d::Robot& robot : scenario.robots) {
    const sim2d::Robot usual;
    robot.planner = usual.planner;
    robot.command = usual.command;
    robot.plannerParameters = usual.plannerParameters;
    robot.nav2Tree = usual.nav2Tree;
    robot.nav2Topics = usual.nav2Topics;
    if (!robot.nav2Body.value_or(false)) {  // else they also say how large it is
      robot.nav2Params = usual.nav2Params;
      robot.nav2Distro = usual.nav2Distro;
      robot.nav2Values = usual.nav2Values;
    }
    robot.goal = usual.goal;
    robot.goalRadius = usual.goalRadius;
    robot.maxVel = usual.maxVel;
    robot.maxAcc = usual.maxAcc;
    robot.maxOmega = usual.maxOmega;
    robot.maxAlpha = usual.maxAlpha;
  }
  scenario.desktop.duration.reset();
  scenario.desktop.stopOnCollision.reset();
  scenario.desktop.stuckAfter.reset();
  return scenario;
}

}  // namespace

std::optional<RunMoment> runMomentOf(const std::string& word) {
  const std::size_t at = word.rfind('@');
  if (at == std::string::npos || at == 0) {
    return std::nullopt;
  }
  const std::optional<double> time = base::parseDouble(word.substr(at + 1));
  const bool isTime = time && *time >= 0.0 && *time <= 1e6;
  return isTime ? std::optional(RunMoment{word.substr(0, at), *time}) : std::nullopt;
}

std::optional<PersonMove> personMoveOf(const std::string& word) {
  const std::string text = base::trimmed(word);
  const std::size_t end = text.find_first_of(" ,");
  const auto pose = end == std::string::npos ? std::nullopt : parseNumbers(text.substr(end), 3);
  if (!pose) {
    return std::nullopt;
  }
  return PersonMove{text.substr(0, end), {{(*pose)[0], (*pose)[1]}, base::wrapToPi((*pose)[2])}};
}

base::Diagnostics checkFromWords(const RunOptions& options) {
  base::Diagnostics wrong;
  const auto refuse = [&](const char* option, bool isGiven) {
    if (isGiven) {
      wrong.push_back(base::error("again.fixed-option", {option}));
    }
  };
  if (options.from.empty()) {
    if (!options.moves.empty()) {
      wrong.push_back(base::error("again.move-without-run"));
    }
    return wrong;
  }
  if (!runMomentOf(options.from)) {
    wrong.push_back(base::error("again.no-moment", {options.from}));
  }
  for (const std::string& move : options.moves) {
    if (!personMoveOf(move)) {
      wrong.push_back(base::error("again.no-move", {move}));
    }
  }
  refuse("a scenario", !options.scenario.empty());
  refuse("--map", !options.map.empty());
  refuse("--trees", !options.trees.empty());
  refuse("--dt", options.dt.has_value());
  refuse("--model", options.model.has_value());
  refuse("--robot", options.robot.has_value());
  refuse("--robot-start", options.robotStart.has_value());
  refuse("--record-every", options.recordEvery.has_value());
  refuse("--exact", options.exact);
  refuse("--compat", !options.compat.empty());
  refuse("--counterfactual", options.counterfactual);
  return wrong;
}

base::Result<std::vector<RunStage>> stagesOf(const RunOptions& options,
                                             const RunWordsReader& readWords) {
  base::Result<std::vector<Making>> makings = makingsBefore(options, readWords);
  if (!makings) {
    return makings.diagnostics();
  }
  makings->insert(makings->begin(), Making{options, {}, {}, {}});
  std::vector<RunStage> stages;
  for (auto making = makings->rbegin(); making != makings->rend(); ++making) {
    RunStage& stage = stages.emplace_back();
    stage.folder = std::move(making->folder);
    stage.inputs = std::move(making->inputs);
    stage.version = std::move(making->version);
    if (stages.size() == 1) {
      stage.options = making->options;
    } else {
      stage.options = goingOn(stages[stages.size() - 2].options, making->options);
      stage.moment = runMomentOf(making->options.from);
      stage.drawSeed = making->options.seed;
    }
    stage.options.allowCode = options.allowCode;
    stage.options.threads = options.threads;
  }
  return stages;
}

bool canGoOnAs(const sim2d::Scenario& was, const sim2d::Scenario& is) {
  return sim2d::writeScenario(fixedPart(was)) == sim2d::writeScenario(fixedPart(is));
}

}  // namespace app
