#include "app/studies/AvoidanceTrials.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/WorkerTasks.h"
#include "app/studies/PathJson.h"
#include "sim2d/base/JsonText.h"

namespace app {

namespace {

using TrialJson = nlohmann::json;

/// Whose contacts count against an action.
enum class Actor { Robot, Person };

/// Watches an action: the paths of both, and contacts.
class TrialWatcher {
 public:
  TrialWatcher(const sim2d::TraceHeader& header, const AvoidanceTarget& target, Actor actor)
      : header_(header), target_(target), actor_(actor) {}

  void addState(const sim2d::Frame& frame) {
    addTo(action_.robotPath, bodyStateIn(frame, target_.robot));
    addTo(action_.personPath, bodyStateIn(frame, target_.person));
  }
  /// Whether a contact in this step counts against the action. `before`: the previous state.
  bool isSpoilt(const sim2d::Frame& before, const sim2d::Frame& frame) const {
    return std::any_of(frame.events.begin(), frame.events.end(), [&](const sim2d::Event& event) {
      return event.kind == sim2d::EventKind::Contact && counts(event, before, frame);
    });
  }
  AvoidingAction& action() { return action_; }

 private:
  static void addTo(std::vector<base::Vec2>& path, const std::optional<BodyState>& state) {
    if (state) {
      path.push_back(state->pose.position);
    }
  }

  bool counts(const sim2d::Event& event, const sim2d::Frame& before,
              const sim2d::Frame& frame) const {
    if (event.id != target_.robot) {
      return false;  // robots are first in events
    }
    if (!event.hasOther) {
      return actor_ == Actor::Robot;  // a wall
    }
    if (event.other == target_.person) {
      return true;
    }
    const auto mark = sim2d::contactMark({frame.step, event}, before, frame, header_);
    return actor_ == Actor::Robot && mark && mark->cause != sim2d::ContactMark::Cause::Person;
  }

  const sim2d::TraceHeader& header_;
  const AvoidanceTarget& target_;
  const Actor actor_;
  AvoidingAction action_;
};

/// Steps to the end of the target. `inputsAt(frame, elapsed)`: of the action.
template <class Inputs>
std::optional<AvoidingAction> simulateAction(RunStepper& stepper, const sim2d::TraceHeader& header,
                                             const AvoidanceTarget& target, Actor actor,
                                             Inputs inputsAt) {
  TrialWatcher watcher(header, target, actor);
  const std::int64_t from = stepper.step();
  watcher.action().time = stepper.frame().time;
  watcher.addState(stepper.frame());
  while (stepper.step() < target.endStep) {
    const sim2d::Frame before = stepper.frame();
    const double elapsed = static_cast<double>(stepper.step() - from) * header.dt;
    if (!stepper.advance(inputsAt(before, elapsed)) || watcher.isSpoilt(before, stepper.frame())) {
      return std::nullopt;
    }
    watcher.addState(stepper.frame());
  }
  return std::move(watcher.action());
}

TrialJson actionJson(const std::optional<AvoidingAction>& action) {
  if (!action) {
    return nullptr;
  }
  return {{"time", action->time},
          {"manoeuvre", action->manoeuvre},
          {"robot", pathJson<TrialJson>(action->robotPath)},
          {"person", pathJson<TrialJson>(action->personPath)}};
}

std::optional<AvoidingAction> actionOf(const TrialJson& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  return AvoidingAction{json.at("time").get<double>(), json.at("manoeuvre").get<std::string>(),
                        pathOfJson(json.at("robot")), pathOfJson(json.at("person"))};
}

const auto kKeepWaiting = [] { return false; };

/// The result of a manoeuvre in a copy of the process, as text.
template <class Manoeuvre, class Try>
std::string trialText(const Manoeuvre& manoeuvre, Try tryOne) {
  ScanResult one;
  one.robot = tryOne(manoeuvre);
  if (one.robot) {
    one.robot->manoeuvre = manoeuvre.name;
  }
  return scanText(one);
}

/// Trials of some manoeuvres, several at a time; the first one of them that avoids the contact.
class ParallelTrials {
 public:
  explicit ParallelTrials(std::size_t count) : results_(count) {}

  /// `work`: the text of a trial. False: no more processes, or one ended unexpectedly.
  bool run(const std::function<std::string(std::size_t)>& work) {
    WorkerTasks tasks;
    tasks.count = results_.size();
    tasks.jobs = kAtATime;
    tasks.work = work;
    tasks.take = [this](std::size_t task, const std::string& text) {
      results_[task] = scanOf(text);
      hasFailed_ = hasFailed_ || !results_[task];
    };
    tasks.wantsStop = [this] { return hasFailed_ || isDecided(); };
    return runTasks(tasks) && !hasFailed_;
  }
  /// Its index; the number of trials if there is none.
  std::size_t first() const {
    std::size_t k = 0;
    while (k < results_.size() && results_[k] && !results_[k]->robot) {
      ++k;
    }
    return k;
  }
  std::optional<AvoidingAction> action() const {
    return first() < results_.size() ? results_[first()]->robot : std::nullopt;
  }

 private:
  static constexpr int kAtATime = 4;
  /// The first success is known when all before it have ended.
  bool isDecided() const {
    const std::size_t k = first();
    return k == results_.size() || results_[k].has_value();
  }

  std::vector<std::optional<ScanResult>> results_;
  bool hasFailed_ = false;
};

/// The first of the manoeuvres that avoids the contact, each tried in a copy of the process.
/// `preferred`: the index to try first, and the one that was found. False: no more processes.
template <class Manoeuvre, class Try>
bool findAction(const std::vector<Manoeuvre>& all, std::size_t& preferred, Try tryOne,
                ScanResult& result, std::optional<AvoidingAction>& found) {
  preferred = std::min(preferred, all.size() - 1);
  const std::optional<std::string> text =
      inCopy([&] { return trialText(all[preferred], tryOne); }, kKeepWaiting);
  const std::optional<ScanResult> answer = text ? scanOf(*text) : std::nullopt;
  ++result.trials;
  if (!answer || answer->robot) {
    found = answer ? answer->robot : std::nullopt;
    return answer.has_value();
  }
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k != preferred) {
      others.push_back(k);
    }
  }
  ParallelTrials trials(others.size());
  if (!trials.run([&](std::size_t k) { return trialText(all[others[k]], tryOne); })) {
    return false;
  }
  found = trials.action();
  result.trials += std::min(trials.first() + 1, others.size());
  preferred = found ? others[trials.first()] : preferred;
  return true;
}

}  // namespace

std::string scanText(const ScanResult& result) {
  return base::jsonText(TrialJson{{"robot", actionJson(result.robot)},
                                  {"person", actionJson(result.person)},
                                  {"trials", result.trials}},
                        -1);
}

std::optional<ScanResult> scanOf(const std::string& text) {
  const TrialJson json = TrialJson::parse(base::shallowJson(text), nullptr, false);
  try {
    return ScanResult{actionOf(json.at("robot")), actionOf(json.at("person")),
                      json.at("trials").get<std::size_t>()};
  } catch (const TrialJson::exception&) {
    return std::nullopt;
  }
}

std::optional<AvoidingAction> tryRobot(RunStepper& stepper, const sim2d::TraceHeader& header,
                                       const AvoidanceTarget& target,
                                       const RobotManoeuvre& manoeuvre) {
  const sim2d::TraceRobot& robot = *header.robot(target.robot);
  return simulateAction(
      stepper, header, target, Actor::Robot, [&](const sim2d::Frame& frame, double elapsed) {
        const sim2d::BodyTwist command =
            commandOf(manoeuvre, elapsed, robot, twistIn(frame, robot.id), header.dt);
        sim2d::Input input;
        input.kind = sim2d::InputKind::Robot;
        input.id = robot.id;
        input.velocity = {command.linear, command.lateral};
        input.omega = command.angular;
        return sim2d::StepInputs{input};
      });
}

std::optional<AvoidingAction> tryPerson(RunStepper& stepper, const sim2d::TraceHeader& header,
                                        const AvoidanceTarget& target,
                                        const PersonManoeuvre& manoeuvre) {
  const sim2d::TraceHuman* const person = header.human(target.person);
  const std::optional<BodyState> state = bodyStateIn(stepper.frame(), target.person);
  if (person == nullptr || !state) {
    return std::nullopt;  // spawned later
  }
  return simulateAction(stepper, header, target, Actor::Person,
                        [&](const sim2d::Frame&, double elapsed) {
                          return inputsOf(manoeuvre, elapsed, *person, state->pose.heading);
                        });
}

namespace {

/// The search for the latest action of one of the two, instant by instant. Every second instant is
/// tried, and those that follow an instant with an action.
class ActionScan {
 public:
  explicit ActionScan(std::optional<AvoidingAction>& latest) : latest_(latest) {}

  /// `number`: of the instant, counted back from the contact. False: no more processes.
  template <class Manoeuvre, class Try>
  bool add(std::int64_t number, const std::vector<Manoeuvre>& all, Try tryOne, ScanResult& result) {
    const bool isTried = number % 2 == 0 || wasAvoidable_;
    std::optional<AvoidingAction> found;
    if (isTried && !findAction(all, preferred_, tryOne, result, found)) {
      return false;
    }
    wasAvoidable_ = found.has_value();
    if (found) {
      latest_ = std::move(found);
    }
    return true;
  }

 private:
  std::optional<AvoidingAction>& latest_;
  std::size_t preferred_ = 0;  // index of the manoeuvre that was found last
  bool wasAvoidable_ = true;   // at the last instant; unknown at first
};

}  // namespace

std::optional<ScanResult> scanInstants(RunStepper& stepper, const sim2d::TraceHeader& header,
                                       const AvoidanceTarget& target, std::int64_t until,
                                       const WantedActions& wanted) {
  ScanResult result;
  ActionScan robot(result.robot), person(result.person);
  bool hasStep = true;
  for (; hasStep && stepper.step() < until; hasStep = stepper.advance()) {
    const std::int64_t before = target.contactStep - stepper.step();
    if (stepper.step() < target.firstStep || before % target.stride != 0) {
      continue;
    }
    const std::int64_t number = before / target.stride;
    const auto ofRobot = [&](const RobotManoeuvre& each) {
      return tryRobot(stepper, header, target, each);
    };
    const auto ofPerson = [&](const PersonManoeuvre& each) {
      return tryPerson(stepper, header, target, each);
    };
    if (wanted.robot && !robot.add(number,
                                   robotManoeuvres(*header.robot(target.robot),
                                                   twistIn(stepper.frame(), target.robot)),
                                   ofRobot, result)) {
      return std::nullopt;
    }
    if (wanted.person && !person.add(number, personManoeuvres(), ofPerson, result)) {
      return std::nullopt;
    }
  }
  return result;
}

std::optional<std::string> answerOf(WorkerProcess& process, const std::string& request,
                                    const std::function<bool()>& wantsStop) {
  if (!process.sendRequest(request)) {
    return std::nullopt;
  }
  std::string answer;
  while (!wantsStop()) {
    if (waitForData({process.descriptor()}).empty()) {
      continue;
    }
    const WorkerProcess::ReadResult read = process.readMessage(answer);
    if (read != WorkerProcess::ReadResult::Part) {
      return read == WorkerProcess::ReadResult::Answer ? std::optional(answer) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<std::string> inCopy(const std::function<std::string()>& work,
                                  const std::function<bool()>& wantsStop) {
  std::optional<WorkerProcess> process =
      WorkerProcess::start([&work](const std::string& /*request*/,
                                   const WorkerProcess::SendMessage& /*tell*/) { return work(); });
  return process ? answerOf(*process, {}, wantsStop) : std::nullopt;
}

}  // namespace app
