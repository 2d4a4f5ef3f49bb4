#include "app/studies/SearchStudy.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "app/run/BundleReader.h"
#include "app/run/Certificate.h"
#include "app/studies/AvoidableContact.h"
#include "app/studies/FailureScenario.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;

std::string withCapital(std::string text) {
  if (!text.empty()) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text;
}

std::string amountText(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

/// Shrinks failures and makes their files.
class FailureSaver {
 public:
  FailureSaver(const Experiment& experiment, const SearchStudyOptions& options, const RunMany& run)
      : experiment_(experiment), options_(options), run_(run) {}

  base::Result<SavedFailure> save(const FoundFailure& found) const {
    base::Result<ShrunkFailure> shrunk =
        shrunkFailure(found.request, found.row, found.kind, options_.plan.shrinkRuns, run_,
                      options_.plan.countsAgainstRobot);
    if (!shrunk) {
      return shrunk.diagnostics();
    }
    SavedFailure saved;
    saved.kind = found.kind;
    saved.run = found.run;
    saved.shrunk = *std::move(shrunk);
    saved.file = "failures/" + found.kind.name() + ".yaml";
    return write(std::move(saved), withCapital(found.kind.text()));
  }

  base::Result<SavedFailure> saveWorst(const FoundFailure& found) const {
    SavedFailure saved;
    saved.kind = found.kind;
    saved.run = found.run;
    saved.isShrunk = false;
    saved.shrunk.request = found.request;
    saved.shrunk.row = found.row;
    saved.file = "failures/worst.yaml";
    return write(std::move(saved), "Worst run by " + options_.plan.worst);
  }

 private:
  base::Result<SavedFailure> write(SavedFailure saved, const std::string& title) const {
    const std::string path = absolutePath(pathIn(options_.folder, saved.file));
    base::Result<sim2d::Scenario> scenario =
        standaloneScenario(saved.shrunk.request, path, options_.loader);
    if (!scenario) {
      return scenario.diagnostics();
    }
    addCard(*scenario, saved, title);
    saved.text = sim2d::writeScenario(*scenario);
    const base::Result<ResultRow> row =
        runOfScenarioText(saved.text, path, saved.shrunk.request, options_.loader);
    if (!row) {
      return row.diagnostics();
    }
    saved.isRepeated = areEqualRuns(*row, saved.shrunk.row);
    return saved;
  }

  void addCard(sim2d::Scenario& scenario, const SavedFailure& saved,
               const std::string& title) const {
    const sim2d::ScenarioCard& original = scenario.desktop.card;
    sim2d::ScenarioCard card;
    card.title = title;
    card.family = kFailureFamily;
    card.purpose = "Whether a robot avoids a failure that a search has found";
    card.robotTask = original.robotTask.value_or("Drive to the goal");
    card.people = peopleText(scenario);
    card.outcome = "The robot reaches its goal without contact";
    card.difficulty = sim2d::Difficulty::Hard;
    card.licence = original.licence;
    card.metrics = {"success", "minimum_distance_to_people", "time_to_reach_goal"};
    const std::string study = fs::path(experiment_.path).filename().string();
    const std::string from = fs::path(saved.shrunk.request.scenario).stem().string();
    card.source = "hunavsim search " + study + ", run " + std::to_string(saved.run) + ": " + from +
                  ", seed " + std::to_string(saved.shrunk.request.seed) +
                  (saved.isShrunk ? shrinkText(saved.shrunk) : std::string(", as found"));
    scenario.desktop.card = card;
  }

  static std::string peopleText(const sim2d::Scenario& scenario) {
    constexpr std::size_t kNamed = 5;
    std::vector<std::string> names;
    for (const sim2d::Human& human : scenario.humans) {
      names.push_back(human.name);
    }
    const std::size_t count = names.size();
    if (count == 0) {
      return "None";
    }
    names.resize(std::min(count, kNamed));
    return amountText(count, "person", "people") + ": " + base::join(names, ", ") +
           (count > kNamed ? " …" : "");
  }

  static std::string shrinkText(const ShrunkFailure& shrunk) {
    return "; shrunk from " + amountText(shrunk.peopleBefore, "person", "people") + " to " +
           std::to_string(shrunk.people) + " in " + amountText(shrunk.runs, "run", "runs");
  }

  const Experiment& experiment_;
  const SearchStudyOptions& options_;
  const RunMany& run_;
};

}  // namespace

base::Result<SearchStudy> runSearchStudy(const Experiment& experiment, const SearchSpace& space,
                                         const SearchStudyOptions& options, const RunMany& run) {
  const auto showPhase = [&](const std::string& phase) {
    if (options.showPhase) {
      options.showPhase(phase);
    }
  };
  showPhase("searching");
  base::Result<SearchResult> result = search(space, options.plan, run);
  if (!result) {
    return result.diagnostics();
  }
  SearchStudy study{&experiment, &space, options.plan, *std::move(result), {}, {}};
  const FailureSaver saver(experiment, options, run);
  const fs::path scenarios = fs::path(options.folder) / "failures";
  std::error_code problem;
  fs::create_directories(scenarios, problem);
  if (problem) {
    return base::error("file.cannot-make-folder", {problem.message()}, scenarios.string());
  }
  for (const FoundFailure& found : study.result.failures) {
    showPhase("shrinking " + std::to_string(study.failures.size() + 1) + " of " +
              std::to_string(study.result.failures.size()));
    base::Result<SavedFailure> saved = saver.save(found);
    if (!saved) {
      return saved.diagnostics();
    }
    study.failures.push_back(*std::move(saved));
  }
  if (study.result.worst) {
    base::Result<SavedFailure> saved = saver.saveWorst(*study.result.worst);
    if (!saved) {
      return saved.diagnostics();
    }
    study.worst = *std::move(saved);
  }
  if (study.failures.empty() && !study.worst) {
    fs::remove(scenarios, problem);  // only if it is empty
  }
  return study;
}

ContactJudge avoidabilityJudge(const sim2d::ImageLoader& loader, std::function<bool()> wantsStop) {
  return [loader, wantsStop = std::move(wantsStop)](const RunRequest& request) {
    const RunSpec spec = specOf(request);
    const base::Result<RunSettings> settings = runSettingsOf(spec);
    if (!settings) {
      return base::Result<bool>(true);
    }
    const base::Result<RepeatableRun> run =
        repeatableRunOf(readBundle(spec, *settings, loader), wantsStop);
    if (!run) {
      return base::Result<bool>(true);
    }
    AvoidanceOptions options;
    options.tryPeople = false;
    const base::Result<std::vector<AvoidableContact>> contacts =
        avoidableContacts(*run, options, wantsStop);
    return base::Result<bool>(!contacts || contacts->empty() || contacts->back().couldRobotAvoid());
  };
}

}  // namespace app
