#include "app/studies/FailureShrinking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/studies/DeltaDebugging.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

constexpr double kUsualStep = 0.05;  // [s] of the simulation

/// A part of a run that may be unnecessary for the failure.
struct Part {
  enum class Kind { Entity, Value, Variation };
  Kind kind = Kind::Entity;
  std::string list;  // Entity: key of the list of names, "agents"
  std::string text;  // name of the entity; the value as PATH=VALUE
};

std::string settingPath(const std::string& setting) {
  return setting.substr(0, setting.find('='));
}

/// Quoted if YAML would read the name as something else.
std::string yamlName(const std::string& name) {
  return base::emitYaml(base::stringNode(name));
}

/// Whether a value chooses what is tested, which stays.
bool choosesPlanner(const std::string& path) {
  return base::endsWith(path, ".planner") || base::endsWith(path, ".command");
}

/// The parts of a run and the runs without some of them.
class RunParts {
 public:
  RunParts(const RunRequest& request, const sim2d::Scenario& scenario) : request_(request) {
    addEntities("agents", scenario.humans);
    addEntities("obstacles", scenario.obstacles);
    addEntities("doors", scenario.doors);
    addEntities("areas", scenario.areas);
    addEntities("robots", scenario.robots, 1);
    for (const std::string& setting : request.spec.set) {
      if (!choosesPlanner(settingPath(setting))) {
        parts_.push_back({Part::Kind::Value, {}, setting});
      }
    }
    const auto& preset = scenario.desktop.variation.preset;
    if (preset && *preset != sim2d::VariationPreset::None) {
      parts_.push_back({Part::Kind::Variation, {}, "variation.preset"});
    }
  }

  const std::vector<Part>& all() const { return parts_; }

  /// The run with these parts only. Lists of names come first, so that a value of all people does
  /// not concern those who are removed.
  RunRequest with(const ElementSet& kept) const {
    RunRequest request = request_;
    std::vector<std::string> settings;
    for (const auto& [list, required] : lists_) {
      std::vector<std::string> names = required;
      std::size_t available = required.size();
      for (std::size_t k = 0; k < parts_.size(); ++k) {
        const bool isListed = parts_[k].kind == Part::Kind::Entity && parts_[k].list == list;
        available += isListed ? 1 : 0;
        if (isListed && std::binary_search(kept.begin(), kept.end(), k)) {
          names.push_back(yamlName(parts_[k].text));
        }
      }
      if (names.size() < available) {
        settings.push_back(list + "=[" + base::join(names, ", ") + "]");
      }
    }
    for (const std::string& setting : request_.spec.set) {
      if (isKept(Part::Kind::Value, setting, kept)) {
        settings.push_back(setting);
      }
    }
    if (!isKept(Part::Kind::Variation, "variation.preset", kept)) {
      settings.emplace_back("variation.preset=none");
    }
    request.spec.set = std::move(settings);
    return request;
  }

 private:
  template <class Entity>
  void addEntities(const char* list, const std::vector<Entity>& entities,
                   std::size_t required = 0) {
    std::vector<std::string> names;
    sim2d::forEachListed(entities, [&](const Entity& each) {
      if (names.size() < required) {
        names.push_back(yamlName(each.name));
      } else {
        parts_.push_back({Part::Kind::Entity, list, each.name});
      }
    });
    lists_.emplace_back(list, std::move(names));
  }

  /// True also for what is not a part.
  bool isKept(Part::Kind kind, const std::string& text, const ElementSet& kept) const {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (parts_[k].kind == kind && parts_[k].text == text) {
        return std::binary_search(kept.begin(), kept.end(), k);
      }
    }
    return true;
  }

  const RunRequest& request_;
  std::vector<Part> parts_;
  std::vector<std::pair<std::string, std::vector<std::string>>> lists_;  // names that stay
};

/// Runs subsets of the parts, up to a limit.
class SubsetRuns {
 public:
  SubsetRuns(const RunParts& parts, const FailureKind& kind, std::size_t mostRuns,
             const RunMany& run, const ContactJudge& judge)
      : parts_(parts), kind_(kind), mostRuns_(mostRuns), run_(run), judge_(judge) {}

  /// The first true result is judged; those behind it are not.
  base::Result<std::vector<bool>> fails(const std::vector<ElementSet>& subsets) {
    std::vector<bool> results(subsets.size(), false);
    if (runs_ + subsets.size() > mostRuns_) {
      isComplete_ = false;
      return results;
    }
    std::vector<RunRequest> requests;
    requests.reserve(subsets.size());
    for (const ElementSet& subset : subsets) {
      requests.push_back(parts_.with(subset));
    }
    runs_ += requests.size();
    const base::Result<std::vector<ResultRow>> rows = run_(requests);
    if (!rows) {
      return rows.diagnostics();
    }
    for (std::size_t k = 0; k < rows->size(); ++k) {
      if (failureKindOf((*rows)[k]) == kind_) {
        const base::Result<bool> counts = countsAsFailure(kind_, requests[k], judge_);
        if (!counts) {
          return counts.diagnostics();
        }
        if (*counts) {
          results[k] = true;
          break;
        }
      }
    }
    return results;
  }

  std::size_t count() const { return runs_; }
  bool isComplete() const { return isComplete_; }

 private:
  const RunParts& parts_;
  const FailureKind& kind_;
  const std::size_t mostRuns_;
  const RunMany& run_;
  const ContactJudge& judge_;
  std::size_t runs_ = 0;
  bool isComplete_ = true;
};

/// The run until a step after its end; the run itself if that is another kind of failure.
base::Diagnostics shortenDuration(ShrunkFailure& failure, double dt, const FailureKind& kind,
                                  const RunMany& run) {
  const double end = base::parseDouble(failure.row.simulated).value_or(0.0);
  RunRequest shorter = failure.request;
  shorter.spec.duration = std::round((end + dt) * 1e6) / 1e6;
  if (failure.request.spec.duration && *failure.request.spec.duration <= *shorter.spec.duration) {
    return {};
  }
  ++failure.runs;
  const base::Result<std::vector<ResultRow>> rows = run({shorter});
  if (rows && failureKindOf(rows->front()) == kind) {
    failure.request = std::move(shorter);
    failure.row = rows->front();
  }
  return rows.diagnostics();
}

void describeRemoved(ShrunkFailure& failure, const std::vector<Part>& parts,
                     const ElementSet& kept) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool isKept = std::binary_search(kept.begin(), kept.end(), k);
    const bool isPerson = parts[k].list == "agents";
    failure.peopleBefore += isPerson ? 1 : 0;
    failure.people += isPerson && isKept ? 1 : 0;
    if (!isKept && parts[k].kind == Part::Kind::Entity) {
      failure.removed.push_back(parts[k].text);
    } else if (!isKept) {
      failure.reset.push_back(settingPath(parts[k].text));
    }
  }
}

}  // namespace

base::Result<bool> countsAsFailure(const FailureKind& kind, const RunRequest& request,
                                   const ContactJudge& judge) {
  const bool isAsked =
      judge && kind.end == FailureEnd::Contact && kind.side != FailureSide::Obstacle;
  return isAsked ? judge(request) : base::Result<bool>(true);
}

base::Result<ShrunkFailure> shrunkFailure(const RunRequest& failing, const ResultRow& row,
                                          const FailureKind& kind, std::size_t mostRuns,
                                          const RunMany& run, const ContactJudge& judge) {
  RunSpec spec = failing.spec;
  spec.scenario = failing.scenario;
  spec.seed = failing.seed;
  sim2d::ScenarioReading reading = sim2d::readScenario(failing.scenario);
  base::Diagnostics problems = errorsOf(reading.diagnostics);
  base::append(problems, errorsOf(applyOptions(reading.scenario, spec, {})));
  if (!problems.empty()) {
    return problems;
  }
  const RunParts parts(failing, reading.scenario);
  SubsetRuns tests(parts, kind, mostRuns, run, judge);
  const base::Result<ElementSet> kept = minimalFailure(
      parts.all().size(),
      [&tests](const std::vector<ElementSet>& subsets) { return tests.fails(subsets); });
  if (!kept) {
    return kept.diagnostics();
  }
  ShrunkFailure failure;
  failure.request = parts.with(*kept);
  failure.row = row;
  failure.runs = tests.count();
  failure.isMinimal = tests.isComplete();
  describeRemoved(failure, parts.all(), *kept);
  if (kept->size() < parts.all().size()) {
    const base::Result<std::vector<ResultRow>> rows = run({failure.request});
    if (!rows) {
      return rows.diagnostics();
    }
    failure.row = rows->front();
  }
  if (kind.end != FailureEnd::Time) {
    const double dt = reading.scenario.desktop.dt.value_or(kUsualStep);
    base::Diagnostics stopped = shortenDuration(failure, dt, kind, run);
    if (base::hasErrors(stopped)) {
      return stopped;
    }
  }
  return failure;
}

bool isEntityList(const std::string& setting) {
  static constexpr const char* kLists[] = {"agents", "obstacles", "doors", "areas", "robots"};
  const std::string path = settingPath(setting);
  return std::find(std::begin(kLists), std::end(kLists), path) != std::end(kLists);
}

}  // namespace app
