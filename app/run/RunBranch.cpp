#include "app/run/RunBranch.h"

#include <algorithm>
#include <utility>

#include "app/run/Nav2Robots.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

/// "anna 2.5 1 0": a person and a new pose.
struct PersonMove {
  std::string name;
  base::Pose2 pose;
};

std::optional<PersonMove> personMoveOf(const std::string& text) {
  const std::string move = base::trimmed(text);
  const std::size_t end = move.find_first_of(" ,");
  const auto pose = end == std::string::npos ? std::nullopt : parseNumbers(move.substr(end), 3);
  if (!pose) {
    return std::nullopt;
  }
  return PersonMove{move.substr(0, end), {{(*pose)[0], (*pose)[1]}, base::wrapToPi((*pose)[2])}};
}

/// The scenario without what can change while a run continues.
sim2d::Scenario fixedPart(sim2d::Scenario scenario) {
  static const sim2d::Robot usual;
  for (sim2d::Robot& robot : scenario.robots) {
    robot.planner = usual.planner;
    robot.command = usual.command;
    robot.plannerParameters = usual.plannerParameters;
    robot.nav2Tree = usual.nav2Tree;
    robot.nav2Topics = usual.nav2Topics;
    if (!robot.nav2Body.value_or(false)) {  // else they also determine its size
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
  for (const RunOption& option : kRunOptions) {
    const bool canChange = (option.use & RunOption::AtBranch) != 0;
    if (canChange && option.setting != nullptr &&
        option.member != RunOption::Member(&RunSpec::seed)) {
      sim2d::fieldOf<sim2d::DesktopSettings>(option.setting)->assign(scenario.desktop, {});
    }
  }
  return scenario;
}

bool canContinueAs(const sim2d::Scenario& was, const sim2d::Scenario& is) {
  return sim2d::writeScenario(fixedPart(was)) == sim2d::writeScenario(fixedPart(is));
}

/// Those `--set` that change fixed values; all of the changes when none does so alone.
base::Diagnostics fixedValues(const Bundle& was, const RunSpec& changes) {
  base::Diagnostics problems;
  for (const std::string& pair : changes.set) {
    RunSpec one;
    one.set = {pair};
    sim2d::Scenario scenario = *was.scenario;
    const base::Diagnostics wrong = applyOptions(scenario, one, was.settings.compatibility);
    if (!base::hasErrors(wrong) && !canContinueAs(*was.scenario, scenario)) {
      problems.push_back(base::error("again.fixed", {pair}, was.path));
    }
  }
  if (problems.empty()) {
    problems.push_back(base::error("again.fixed-things", {}, was.path));
  }
  return problems;
}

}  // namespace

std::optional<RunMoment> runMomentOf(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos || at == 0) {
    return std::nullopt;
  }
  const std::optional<double> time = base::parseDouble(text.substr(at + 1));
  const bool isTime = time && base::kTime.contains(*time);
  return isTime ? std::optional(RunMoment{text.substr(0, at), *time}) : std::nullopt;
}

std::vector<RunBranch> branchesUntil(std::vector<RunBranch> branches, std::int64_t step) {
  branches.erase(std::remove_if(branches.begin(), branches.end(),
                                [step](const RunBranch& each) { return each.step > step; }),
                 branches.end());
  return branches;
}

base::Diagnostics checkBranchOptions(const RunSpec& spec) {
  base::Diagnostics wrong;
  if (spec.from.empty()) {
    if (!spec.moves.empty()) {
      wrong.push_back(base::error("again.move-without-run"));
    }
    return wrong;
  }
  if (!runMomentOf(spec.from)) {
    wrong.push_back(base::error("again.no-moment", {spec.from}));
  }
  for (const std::string& move : spec.moves) {
    if (!personMoveOf(move)) {
      wrong.push_back(base::error("again.no-move", {move}));
    }
  }
  if (!spec.scenario.empty()) {
    wrong.push_back(base::error("again.fixed-option", {"the scenario"}));
  }
  for (const RunOption& option : kRunOptions) {
    if ((option.use & RunOption::FromBeginning) != 0 && option.isGiven(spec)) {
      wrong.push_back(base::error("again.fixed-option", {std::string("--") + option.name}));
    }
  }
  return wrong;
}

base::Result<Bundle> continueWith(const Bundle& was, const RunSpec& changes) {
  RunSpec later = changes;
  later.seed.reset();  // people keep what was drawn for them
  auto scenario = std::make_shared<sim2d::Scenario>(*was.scenario);
  Bundle is = was;
  base::append(is.wrongOptions, applyOptions(*scenario, later, was.settings.compatibility));
  if (!changes.set.empty()) {
    base::append(is.wrongOptions, wrongNav2Values(*scenario, was.path));
  }
  if (base::hasErrors(is.wrongOptions)) {
    return is;
  }
  if (!canContinueAs(*was.scenario, *scenario)) {
    return fixedValues(was, changes);
  }
  is.scenario = std::move(scenario);
  if (!changes.metrics.empty()) {
    is.metrics.metrics = changes.metrics;
  }
  if (changes.metricsProfile != MetricsOptions().metricsProfile) {
    is.metrics.metricsProfile = changes.metricsProfile;
  }
  listInputs(is);
  return is;
}

base::Result<Bundle> continueWith(const Bundle& was, const std::vector<RunBranch>& branches) {
  base::Result<Bundle> is = was;
  for (const RunBranch& branch : branches) {
    is = continueWith(*is, branch.changes);
    if (!is || base::hasErrors(is->wrongOptions)) {
      return is ? base::Result<Bundle>(is->wrongOptions) : is;
    }
  }
  return is;
}

base::Result<sim2d::StepInputs> inputsOfMoves(const std::vector<std::string>& moves,
                                              const sim2d::TraceHeader& header,
                                              const std::string& file) {
  base::Diagnostics problems;
  sim2d::StepInputs inputs;
  for (const std::string& text : moves) {
    const std::optional<PersonMove> move = personMoveOf(text);
    if (!move) {
      problems.push_back(base::error("again.no-move", {text}, file));
      continue;
    }
    const auto* const person = base::findBy(header.humans, &sim2d::TraceHuman::name, move->name);
    if (person == nullptr) {
      problems.push_back(base::error("again.move-of-nobody", {move->name}, file));
      continue;
    }
    sim2d::Input& input = inputs.emplace_back();
    input.kind = sim2d::InputKind::Move;
    input.id = person->id;
    input.pose = move->pose;
  }
  return base::resultOf(std::move(inputs), std::move(problems));
}

std::string changesText(const RunSpec& changes) {
  std::vector<std::string> parts;
  for (const std::string& pair : changes.set) {
    const std::size_t equals = std::min(pair.find('='), pair.size());
    parts.push_back(base::trimmed(pair.substr(0, equals)) + " = " +
                    base::trimmed(pair.substr(std::min(equals + 1, pair.size()))));
  }
  if (changes.planner) {
    parts.push_back("planner " + *changes.planner);
  }
  if (changes.robotGoal) {
    parts.push_back("goal " + *changes.robotGoal);
  }
  if (changes.seed) {
    parts.push_back("seed " + std::to_string(*changes.seed));
  }
  if (changes.duration) {
    parts.push_back("duration " + base::formatDouble(*changes.duration) + " s");
  }
  for (const std::string& text : changes.moves) {
    const std::optional<PersonMove> move = personMoveOf(text);
    parts.push_back((move ? move->name : text) + " moved");
  }
  return base::join(parts, ", ");
}

BranchedRun::BranchedRun(Bundle bundle, const std::vector<RunBranch>& branches)
    : bundle_(std::move(bundle)) {
  if (!checkLast()) {
    return;
  }
  seed_ = static_cast<std::uint64_t>(header_.seed);
  std::unique_ptr<sim2d::World> first = std::move(verdict_.world);
  for (const RunBranch& branch : branches) {
    base::Result<Bundle> next = continueWith(bundle_, branch.changes);
    if (!next) {
      verdict_ = Verdict();
      verdict_.problems = next.diagnostics();
      return;
    }
    bundle_ = *std::move(next);
    if (!checkLast()) {
      return;
    }
    if (branch.changes.seed) {
      seed_ = static_cast<std::uint64_t>(*branch.changes.seed);
    }
    changes_.push_back({branch.step, std::move(verdict_.world), seed_});
  }
  verdict_.world = std::move(first);
}

/// Checks the bundle as it is now; false: there is no world.
bool BranchedRun::checkLast() {
  verdict_ = check(bundle_);
  if (!verdict_.ok()) {
    verdict_.world.reset();
  }
  if (verdict_.world != nullptr) {
    header_ = verdict_.world->header();
  }
  return verdict_.world != nullptr;
}

void BranchedRun::apply(const sim2d::Frame& frame, sim2d::World& world) {
  for (Change& change : changes_) {
    if (change.step == frame.step && change.next != nullptr) {
      world.continueWith(*change.next, change.seed);
      change.next.reset();
    }
  }
}

}  // namespace app
