#include "app/studies/AvoidableContact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "app/studies/AvoidanceTrials.h"
#include "app/studies/ContactList.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kCheckpointGap = 0.5;  // [s]

/// Repeats a run once and analyses its contacts. At regular instants it leaves a copy of the
/// process behind, a checkpoint, which answers requests about what follows from there on.
class ContactAnalysis {
 public:
  ContactAnalysis(const RepeatableRun& run, const AvoidanceOptions& options,
                  const std::function<bool()>& wantsStop)
      : run_(run),
        options_(options),
        wantsStop_(wantsStop),
        contacts_(contactsIn(*run.recording)) {}

  std::size_t count() const { return contacts_.size(); }
  /// `finished`: called after each contact.
  base::Diagnostics analyse(const std::function<void(std::size_t)>& finished);
  std::vector<AvoidableContact> take() { return std::move(contacts_); }

 private:
  struct Checkpoint {
    std::int64_t step = 0;
    WorkerProcess process;
  };
  struct Pair {
    MutualSight sight;
    std::optional<WorkerProcess> begin;  // checkpoint at the begin of the robot's sight
  };

  void prepare();
  void updateSights();
  bool addCheckpoint();
  std::optional<WorkerProcess> startCheckpoint();
  std::string answer(const std::string& request);
  bool analyse(std::size_t k);
  bool analyseStep(std::size_t& next, const std::function<void(std::size_t)>& finished);
  bool findActions(std::size_t k);
  bool tryBraking(std::size_t k);
  base::Diagnostics failure(const char* code) const;

  const RepeatableRun& run_;
  const AvoidanceOptions options_;
  const std::function<bool()>& wantsStop_;
  std::vector<AvoidableContact> contacts_;
  std::vector<AvoidanceTarget> targets_;  // parallel to contacts_
  sim2d::TraceHeader header_;
  std::unique_ptr<RunStepper> stepper_;
  std::map<std::pair<int, int>, Pair> pairs_;  // that touch later
  std::vector<Checkpoint> checkpoints_;        // by step
  std::int64_t gap_ = 1;                       // steps between two checkpoints
};

void ContactAnalysis::prepare() {
  header_ = *run_.recording->header();
  const double dt = header_.dt;
  const auto stepsOf = [dt](double time) { return std::llround(time / dt); };
  gap_ = std::max<std::int64_t>(1, stepsOf(kCheckpointGap));
  std::map<std::pair<int, int>, std::int64_t> lastContact;
  for (const AvoidableContact& contact : contacts_) {
    AvoidanceTarget& target = targets_.emplace_back();
    target.robot = contact.robot;
    target.person = contact.person;
    target.contactStep = contact.step;
    target.endStep = contact.step + stepsOf(options_.settle);
    target.stride = std::max<std::int64_t>(1, stepsOf(options_.resolution));
    const double start = header_.robot(contact.robot)->startTime;
    target.firstStep =
        std::max<std::int64_t>({0, contact.step - stepsOf(options_.lookback), stepsOf(start)});
    const std::pair<int, int> pair(contact.robot, contact.person);
    const auto [last, isFirst] = lastContact.try_emplace(pair, contact.step);
    if (!isFirst) {
      target.firstStep = std::max(target.firstStep, last->second + 1);
      last->second = contact.step;
    }
    pairs_.try_emplace(pair,
                       Pair{MutualSight(run_.bundle, contact.robot, contact.person), std::nullopt});
  }
}

base::Diagnostics ContactAnalysis::failure(const char* code) const {
  return {base::error(code, {stepper_->frame().time}, run_.bundle.path)};
}

base::Diagnostics ContactAnalysis::analyse(const std::function<void(std::size_t)>& finished) {
  prepare();
  base::Result<std::unique_ptr<RunStepper>> stepper = RunStepper::open(run_);
  if (!stepper) {
    return stepper.diagnostics();
  }
  stepper_ = *std::move(stepper);
  for (std::size_t next = 0; next < contacts_.size() && !wantsStop_();) {
    if (!stepper_->isAsRecorded()) {
      return failure("contacts.goes-elsewhere");
    }
    updateSights();
    const bool isDone = analyseStep(next, finished);
    if (!isDone && wantsStop_()) {
      contacts_.resize(next);
    }
    if (next == contacts_.size()) {
      return {};
    }
    if (!isDone || !addCheckpoint()) {
      return {base::error("contacts.no-process", {}, run_.bundle.path)};
    }
    if (!stepper_->advance()) {
      return {base::error("contacts.world-failed",
                          {stepper_->frame().time, stepper_->world().failure()}, run_.bundle.path)};
    }
  }
  const auto isAhead = [this](const AvoidableContact& contact) {
    return contact.step >= stepper_->step();
  };
  contacts_.erase(std::find_if(contacts_.begin(), contacts_.end(), isAhead), contacts_.end());
  return {};
}

/// Analyses the contacts of the current step, which begin at `next`. False: a stop was requested,
/// or there are no more processes; `next` is then the first one without a result.
bool ContactAnalysis::analyseStep(std::size_t& next,
                                  const std::function<void(std::size_t)>& finished) {
  for (; next < contacts_.size() && contacts_[next].step == stepper_->step(); ++next) {
    if (!analyse(next)) {
      return false;
    }
    finished(next + 1);
  }
  return true;
}

void ContactAnalysis::updateSights() {
  for (auto& [ids, pair] : pairs_) {
    if (pair.sight.update(stepper_->frame(), stepper_->world().obstacles())) {
      pair.begin = startCheckpoint();
    }
  }
}

std::optional<WorkerProcess> ContactAnalysis::startCheckpoint() {
  return WorkerProcess::start(
      [this](const std::string& request, const WorkerProcess::SendMessage& /*tell*/) {
        return answer(request);
      });
}

/// A checkpoint where the window of a later contact needs one. False: no more processes.
bool ContactAnalysis::addCheckpoint() {
  const std::int64_t step = stepper_->step();
  const auto isNeededFrom = [this](std::int64_t at) {
    return std::any_of(targets_.begin(), targets_.end(), [&](const AvoidanceTarget& target) {
      return target.firstStep < at + gap_ && at < target.contactStep &&
             target.contactStep > stepper_->step();
    });
  };
  checkpoints_.erase(
      std::remove_if(checkpoints_.begin(), checkpoints_.end(),
                     [&](const Checkpoint& each) { return !isNeededFrom(each.step); }),
      checkpoints_.end());
  if (step % gap_ != 0 || !isNeededFrom(step)) {
    return true;
  }
  std::optional<WorkerProcess> process = startCheckpoint();
  if (!process) {
    return false;
  }
  checkpoints_.push_back({step, *std::move(process)});
  return true;
}

/// In a checkpoint. The request: "brake K" or "scan K ROBOT PERSON" for contact K, with 0 or 1 for
/// each action that is wanted. The work is done in a copy of it, so that it stays at its step.
std::string ContactAnalysis::answer(const std::string& request) {
  const std::vector<std::string> words = base::split(request, ' ');
  const AvoidanceTarget& target = targets_[static_cast<std::size_t>(*base::parseInt(words[1]))];
  const auto work = [&]() -> std::string {
    if (words.front() == "brake") {
      ScanResult result;
      result.trials = 1;
      result.robot = tryRobot(*stepper_, header_, target,
                              robotManoeuvres(*header_.robot(target.robot), {}).front());
      return scanText(result);
    }
    const std::int64_t until = std::min(stepper_->step() + gap_, target.contactStep);
    const std::optional<ScanResult> result =
        scanInstants(*stepper_, header_, target, until, {words[2] == "1", words[3] == "1"});
    return result ? scanText(*result) : std::string();
  };
  return inCopy(work, [] { return false; }).value_or("");
}

bool ContactAnalysis::analyse(std::size_t k) {
  AvoidableContact& contact = contacts_[k];
  const Pair& pair = pairs_.at({contact.robot, contact.person});
  contact.robotSight = pair.sight.robotSight();
  contact.personSight = pair.sight.personSight();
  return tryBraking(k) && findActions(k);
}

bool ContactAnalysis::tryBraking(std::size_t k) {
  AvoidableContact& contact = contacts_[k];
  Pair& pair = pairs_.at({contact.robot, contact.person});
  if (!contact.robotSight) {
    return true;
  }
  if (!pair.begin) {
    return false;
  }
  const auto text = answerOf(*pair.begin, "brake " + std::to_string(k), wantsStop_);
  const std::optional<ScanResult> result = text ? scanOf(*text) : std::nullopt;
  if (result) {
    contact.brakingAvoids = result->robot.has_value();
    contact.trials += result->trials;
  }
  return result.has_value();
}

bool ContactAnalysis::findActions(std::size_t k) {
  AvoidableContact& contact = contacts_[k];
  const AvoidanceTarget& target = targets_[k];
  WantedActions wanted{true, options_.tryPeople};
  for (std::size_t n = checkpoints_.size(); n-- > 0 && (wanted.robot || wanted.person);) {
    Checkpoint& checkpoint = checkpoints_[n];
    if (checkpoint.step >= target.contactStep || checkpoint.step + gap_ <= target.firstStep) {
      continue;
    }
    const auto text = answerOf(
        checkpoint.process,
        "scan " + std::to_string(k) + (wanted.robot ? " 1" : " 0") + (wanted.person ? " 1" : " 0"),
        wantsStop_);
    std::optional<ScanResult> result = text ? scanOf(*text) : std::nullopt;
    if (!result) {
      return false;
    }
    contact.trials += result->trials;
    if (result->robot) {
      contact.robotAction = std::move(result->robot);
      wanted.robot = false;
    }
    if (result->person) {
      contact.personAction = std::move(result->person);
      wanted.person = false;
    }
  }
  return true;
}

bool isSince(const std::optional<AvoidingAction>& action, const std::optional<double>& sight) {
  constexpr double kRounding = 1e-9;  // [s]
  return action && sight && action->time >= *sight - kRounding;
}

}  // namespace

bool AvoidableContact::couldRobotAvoid() const {
  return isSince(robotAction, robotSight);
}

bool AvoidableContact::couldPersonAvoid() const {
  return isSince(personAction, personSight);
}

const char* whoCouldAvoid(const AvoidableContact& contact) {
  const bool robot = contact.couldRobotAvoid(), person = contact.couldPersonAvoid();
  return robot && person ? "both" : robot ? "robot" : person ? "person" : "none";
}

base::Result<std::vector<AvoidableContact>> avoidableContacts(
    const RepeatableRun& run, const AvoidanceOptions& options,
    const std::function<bool()>& wantsStop,
    const std::function<void(std::size_t done, std::size_t all)>& showProgress) {
  const std::function<bool()> stops = wantsStop ? wantsStop : [] { return false; };
  ContactAnalysis analysis(run, options, stops);
  const std::size_t all = analysis.count();
  base::Diagnostics problems = analysis.analyse([&](std::size_t done) {
    if (showProgress) {
      showProgress(done, all);
    }
  });
  return base::hasErrors(problems) ? base::Result<std::vector<AvoidableContact>>(problems)
                                   : base::Result<std::vector<AvoidableContact>>(analysis.take());
}

}  // namespace app
