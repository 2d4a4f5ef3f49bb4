#include "app/run/Fork.h"

#include <algorithm>
#include <utility>

#include "app/run/RunStages.h"
#include "sim2d/base/Text.h"

namespace app {

base::Result<Bundle> goingOnAs(const Bundle& was, const RunOptions& options) {
  RunOptions later = options;
  later.seed.reset();  // that of the people stays
  auto scenario = std::make_shared<sim2d::Scenario>(*was.scenario);
  base::Diagnostics wrong = applyOptions(*scenario, later, was.settings.compatibility);
  if (!base::hasErrors(wrong) && !canGoOnAs(*was.scenario, *scenario)) {
    wrong.push_back(base::error("again.fixed-things", {}, was.path));
  }
  if (base::hasErrors(wrong)) {
    return wrong;
  }
  Bundle is = was;
  is.scenario = std::move(scenario);
  return {std::move(is), std::move(wrong)};
}

base::Result<Bundle> goingOnAs(const Bundle& was, const std::vector<ForkStage>& stages) {
  base::Result<Bundle> is = was;
  for (const ForkStage& stage : stages) {
    if (!is) {
      break;
    }
    is = goingOnAs(*is, stage.options);
  }
  return is;
}

base::Result<sim2d::StepInputs> inputsOfMoves(const std::vector<std::string>& moves,
                                              const sim2d::TraceHeader& header) {
  base::Diagnostics problems;
  sim2d::StepInputs inputs;
  for (const std::string& word : moves) {
    const std::optional<PersonMove> move = personMoveOf(word);
    if (!move) {
      problems.push_back(base::error("again.no-move", {word}));
      continue;
    }
    const auto person =
        std::find_if(header.humans.begin(), header.humans.end(),
                     [&](const sim2d::TraceHuman& human) { return human.name == move->name; });
    if (person == header.humans.end()) {
      problems.push_back(base::error("again.move-of-nobody", {move->name}));
      continue;
    }
    sim2d::Input& input = inputs.emplace_back();
    input.kind = sim2d::InputKind::Move;
    input.id = person->id;
    input.pose = move->pose;
  }
  return problems.empty() ? base::Result<sim2d::StepInputs>(std::move(inputs))
                          : base::Result<sim2d::StepInputs>(std::move(problems));
}

std::string changesText(const RunOptions& options) {
  std::vector<std::string> words;
  for (const std::string& pair : options.set) {
    const std::size_t equals = std::min(pair.find('='), pair.size());
    words.push_back(base::trimmed(pair.substr(0, equals)) + " = " +
                    base::trimmed(pair.substr(std::min(equals + 1, pair.size()))));
  }
  if (options.planner) {
    words.push_back("planner " + *options.planner);
  }
  if (options.robotGoal) {
    words.push_back("goal " + *options.robotGoal);
  }
  if (options.seed) {
    words.push_back("seed " + std::to_string(*options.seed));
  }
  if (options.duration) {
    words.push_back("duration " + base::formatDouble(*options.duration) + " s");
  }
  for (const std::string& move : options.moves) {
    const std::optional<PersonMove> who = personMoveOf(move);
    words.push_back((who ? who->name : move) + " moved");
  }
  return base::join(words, ", ");
}

base::Result<std::shared_ptr<StagedRun>> StagedRun::make(const Bundle& bundle,
                                                         const std::vector<ForkStage>& stages) {
  std::shared_ptr<StagedRun> run(new StagedRun());
  Verdict first = check(bundle);
  if (!first.world) {
    return std::move(first.problems);
  }
  run->world_ = std::move(first.world);
  std::uint64_t seed = static_cast<std::uint64_t>(run->world_->header().seed);
  base::Result<Bundle> as = bundle;
  for (const ForkStage& stage : stages) {
    as = goingOnAs(*as, stage.options);
    if (!as) {
      return as.diagnostics();
    }
    Verdict later = check(*as);
    if (!later.world) {
      return std::move(later.problems);
    }
    if (stage.options.seed) {
      seed = static_cast<std::uint64_t>(*stage.options.seed);
    }
    run->changes_.push_back({stage.step, std::move(later.world), seed});
  }
  return {std::move(run), std::move(first.worldRemarks)};
}

void StagedRun::look(const sim2d::Frame& frame, sim2d::World& world) {
  for (Change& change : changes_) {
    if (change.step == frame.step && change.as != nullptr) {
      world.goOnAs(*change.as, change.seed);
      change.as.reset();
    }
  }
}

}  // namespace app
