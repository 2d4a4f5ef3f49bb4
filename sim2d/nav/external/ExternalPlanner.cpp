#include "sim2d/nav/external/ExternalPlanner.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/external/CommandWords.h"
#include "sim2d/nav/external/ExternalProcess.h"
#include "sim2d/nav/external/PlannerProtocol.h"

namespace sim2d {
namespace {

constexpr double kLongestTimeout = 3600.0;  // [s]

base::Diagnostics ofExternalRobot(const std::string& robot, const base::Diagnostics& problems) {
  base::Diagnostics all;
  all.reserve(problems.size());
  for (const base::Diagnostic& problem : problems) {
    all.push_back(base::within("robot '" + robot + "'", problem));
  }
  return all;
}

class ExternalPlanner : public Planner {
 public:
  ExternalPlanner(PlannerSetup setup, const ExternalCommand& command,
                  std::unique_ptr<ExternalProcess> process, base::StopFlagPtr stop)
      : setup_(std::move(setup)),
        command_(command),
        process_(std::move(process)),
        stop_(std::move(stop)) {}
  ~ExternalPlanner() override {
    if (isReady_ && !stop_->isHeeded()) {
      process_->finish(endLine("over"));
    }
  }
  ExternalPlanner(const ExternalPlanner&) = delete;
  ExternalPlanner& operator=(const ExternalPlanner&) = delete;
  ExternalPlanner(ExternalPlanner&&) = delete;
  ExternalPlanner& operator=(ExternalPlanner&&) = delete;

  base::Result<BodyTwist> command(const Observation& observation) override {
    if (problems_.empty() && !isReady_) {
      greet(observation);
    }
    base::Result<ExternalAnswer> answer =
        problems_.empty() ? next(observation) : base::Result<ExternalAnswer>(problems_);
    if (!answer) {
      fail(answer.diagnostics());
      return ofExternalRobot(setup_.robot, problems_);
    }
    path_ = std::move(answer->path);
    return answer->twist;
  }

  std::vector<Vec2> path() const override { return path_; }

 private:
  void fail(const base::Diagnostics& problems) {
    problems_ = problems;
    path_.clear();
    process_->abandon();
  }

  void greet(const Observation& observation) {
    const base::Result<std::string> answer =
        process_->ask(greetingLine(setup_, observation), command_.firstTimeout);
    const base::Result<std::string> name =
        answer ? readReady(*answer) : base::Result<std::string>(answer.diagnostics());
    if (!name) {
      fail(name.diagnostics());
      return;
    }
    isReady_ = true;
    wallVersion_ = observation.navigation->version();
  }

  base::Result<ExternalAnswer> next(const Observation& observation) {
    ObservationParts parts;
    parts.walls = observation.navigation->version() != wallVersion_;
    parts.scan = observation.scan != nullptr && observation.scan->time != scanTime_;
    const base::Result<std::string> answer =
        process_->ask(observationLine(observation, parts), command_.timeout);
    if (!answer) {
      return answer.diagnostics();
    }
    wallVersion_ = observation.navigation->version();
    if (parts.scan) {
      scanTime_ = observation.scan->time;
    }
    return readAnswer(*answer);
  }

  const PlannerSetup setup_;
  const ExternalCommand command_;
  std::unique_ptr<ExternalProcess> process_;
  const base::StopFlagPtr stop_;
  bool isReady_ = false;
  int wallVersion_ = -1;            // of the walls that it knows
  std::optional<double> scanTime_;  // [s], of the last scan that it got
  std::vector<Vec2> path_;
  base::Diagnostics problems_;  // it has failed
};

base::Diagnostics timeProblems(const ExternalCommand& command) {
  for (const double seconds : {command.timeout, command.firstTimeout}) {
    if (!(seconds > 0.0 && seconds <= kLongestTimeout)) {
      return {base::error("external.bad-timeout", {kLongestTimeout, seconds})};
    }
  }
  return {};
}

base::Result<std::unique_ptr<ExternalProcess>> startExternal(const ExternalCommand& command,
                                                             CodePermission permission,
                                                             const base::StopFlagPtr& stop) {
  if (base::trimmed(command.command).empty()) {
    return base::error("external.no-command");
  }
  if (!permission.allowed) {
    return base::error("external.not-allowed", {command.command});
  }
  const base::Diagnostics wrong = timeProblems(command);
  return wrong.empty() ? ExternalProcess::start(command.command, stop) : wrong;
}

}  // namespace

base::Result<std::shared_ptr<Planner>> makeExternalPlanner(const PlannerSetup& setup,
                                                           const ExternalCommand& command,
                                                           CodePermission permission,
                                                           const base::StopFlagPtr& stop) {
  base::Result<std::unique_ptr<ExternalProcess>> process = startExternal(command, permission, stop);
  if (!process) {
    return ofExternalRobot(setup.robot, process.diagnostics());
  }
  return std::shared_ptr<Planner>(
      std::make_shared<ExternalPlanner>(setup, command, *std::move(process), stop));
}

base::Diagnostics checkExternalCommand(const PlannerSetup& setup, const ExternalCommand& command) {
  base::Diagnostics problems = timeProblems(command);
  if (!ExternalProcess::isSocket(command.command)) {
    const base::Result<std::vector<std::string>> words = commandWords(command.command);
    base::append(problems, words ? programFile(words->front()).diagnostics() : words.diagnostics());
  }
  return ofExternalRobot(setup.robot, problems);
}

}  // namespace sim2d
