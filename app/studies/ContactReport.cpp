#include "app/studies/ContactReport.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/run/WorkerTasks.h"
#include "app/studies/Manoeuvres.h"
#include "app/studies/RunStepper.h"

namespace app {

namespace {

const std::function<bool()> kNeverStops = [] { return false; };

std::string firstMessage(const base::Diagnostics& problems) {
  return problems.empty() ? "the simulation could not be created" : problems.front().message;
}

/// The run with a changed scenario.
template <class Change>
RepeatableRun changedRun(const RepeatableRun& run, Change change) {
  RepeatableRun changed = run;
  auto scenario = std::make_shared<sim2d::Scenario>(*run.bundle.scenario);
  change(*scenario);
  changed.bundle.scenario = std::move(scenario);
  return changed;
}

RepeatableRun withoutPerson(const RepeatableRun& run, int person) {
  return changedRun(run, [person](sim2d::Scenario& scenario) {
    for (sim2d::Human& human : scenario.humans) {
      human.listed = human.listed && human.id != person;
    }
  });
}

RepeatableRun withoutRobots(const RepeatableRun& run) {
  return changedRun(run, [](sim2d::Scenario& scenario) {
    for (sim2d::Robot& robot : scenario.robots) {
      robot.listed = false;
    }
  });
}

/// Whether contacts happen again in a run that is being repeated.
class Repetitions {
 public:
  Repetitions(const std::vector<AvoidableContact>& contacts, double settle)
      : contacts_(contacts), happens_(contacts.size(), '0') {
    const auto previous = [&](std::size_t k) {
      double last = -1.0;
      for (std::size_t n = 0; n < k; ++n) {
        const bool isSame =
            contacts[n].robot == contacts[k].robot && contacts[n].person == contacts[k].person;
        last = isSame ? contacts[n].time + settle : last;
      }
      return last;
    };
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      from_.push_back(previous(k));
      until_.push_back(contacts[k].time + settle);
    }
  }
  double end() const { return *std::max_element(until_.begin(), until_.end()); }
  void add(const sim2d::Frame& frame) {
    for (const sim2d::Event& event : frame.events) {
      if (event.kind != sim2d::EventKind::Contact || !event.hasOther) {
        continue;
      }
      for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const bool isPair = event.id == contacts_[k].robot && event.other == contacts_[k].person;
        if (isPair && frame.time > from_[k] && frame.time <= until_[k]) {
          happens_[k] = '1';
        }
      }
    }
  }
  /// '1' or '0' per contact.
  const std::string& text() const { return happens_; }

 private:
  const std::vector<AvoidableContact>& contacts_;
  std::vector<double> from_, until_;  // [s]
  std::string happens_;
};

/// '0' or '1' per contact, or "!" and the problem.
std::string repeatWithout(const RepeatableRun& run, int person,
                          const std::vector<AvoidableContact>& contacts, double settle) {
  const RepeatableRun changed = withoutPerson(run, person);
  base::Result<std::unique_ptr<RunStepper>> stepper = RunStepper::open(changed);
  if (!stepper) {
    return "!" + firstMessage(stepper.diagnostics());
  }
  Repetitions repetitions(contacts, settle);
  while ((*stepper)->frame().time < repetitions.end()) {
    if (!(*stepper)->advance()) {
      return "!" + (*stepper)->world().failure();
    }
    repetitions.add((*stepper)->frame());
  }
  return repetitions.text();
}

/// Other people near the robot or the person during the time before a contact, by id.
std::set<int> peopleNear(const sim2d::Recording& recording, const AvoidableContact& contact,
                         const ContactReportOptions& options) {
  std::set<int> near;
  const std::size_t end = recording.indexAt(contact.step);
  const double begin = contact.time - options.influenceTime;
  for (std::size_t k = recording.indexAtTime(std::max(0.0, begin)); k <= end; ++k) {
    const sim2d::FramePtr frame = recording.frame(k);
    for (const int id : {contact.robot, contact.person}) {
      const std::optional<BodyState> body = bodyStateIn(*frame, id);
      for (std::size_t n = 0; body && n < frame->humans.size(); ++n) {
        const base::Vec2 place(frame->humans.x[n], frame->humans.y[n]);
        if (frame->humans.id[n] != contact.person &&
            (place - body->pose.position).norm() <= options.influenceRange) {
          near.insert(frame->humans.id[n]);
        }
      }
    }
  }
  return near;
}

/// Adds the results of runs without single people. False: no more processes.
bool addInfluences(const RepeatableRun& run, const ContactReportOptions& options,
                   const std::function<bool()>& wantsStop, ContactReport& report) {
  std::vector<AvoidableContact> contacts;
  std::vector<std::set<int>> near;
  std::set<int> all;
  for (const ReportedContact& each : report.contacts) {
    contacts.push_back(each.contact);
    near.push_back(peopleNear(*run.recording, each.contact, options));
    all.insert(near.back().begin(), near.back().end());
  }
  const std::vector<int> people(all.begin(), all.end());
  WorkerTasks tasks;
  tasks.count = people.size();
  tasks.jobs = options.jobs;
  tasks.wantsStop = wantsStop;
  tasks.work = [&](std::size_t task) {
    return repeatWithout(run, people[task], contacts, options.avoidance.settle);
  };
  std::map<int, std::string> results;
  tasks.take = [&](std::size_t task, const std::string& text) {
    results[people[task]] = text.empty() ? "!the process ended unexpectedly" : text;
  };
  const bool hasProcesses = runTasks(tasks);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    for (const auto& [person, text] : results) {
      if (near[k].count(person) > 0) {
        const bool isKnown = text.front() != '!';
        report.contacts[k].withoutPeople.push_back(
            {person, !isKnown || text[k] == '1', isKnown ? std::string() : text.substr(1)});
      }
    }
  }
  return hasProcesses;
}

/// Compares people with the run without robots; a problem is in the report.
void addEffects(const RepeatableRun& run, const std::function<bool()>& wantsStop,
                ContactReport& report) {
  const RepeatableRun changed = withoutRobots(run);
  base::Result<std::unique_ptr<RunStepper>> stepper = RunStepper::open(changed);
  if (!stepper) {
    report.problem = firstMessage(stepper.diagnostics());
    return;
  }
  const std::int64_t last = run.recording->stepOf(run.recording->size() - 1);
  const auto alone = std::make_shared<sim2d::Recording>(run.recording->header()->recordEvery);
  alone->append((*stepper)->frame());
  while ((*stepper)->step() < last && !wantsStop()) {
    if (!(*stepper)->advance()) {
      report.problem = (*stepper)->world().failure();
      return;
    }
    alone->append((*stepper)->frame());
  }
  if (!wantsStop()) {
    report.effects =
        metrics::personEffects(run.recording->trace(), alone->trace((*stepper)->world().header()));
  }
}

ContactReport reportOf(const RepeatableRun& run) {
  ContactReport report;
  const sim2d::TraceHeader& header = *run.recording->header();
  report.scenario = header.scenario;
  report.seed = header.seed;
  for (const sim2d::TraceRobot& robot : header.robots) {
    report.names[robot.id] = robot.name;
    report.planners += (report.planners.empty() ? "" : "+") + robot.planner;
  }
  for (const sim2d::TraceHuman& human : header.humans) {
    report.names[human.id] = human.name;
  }
  return report;
}

}  // namespace

std::string ContactReport::nameOf(int id) const {
  const auto found = names.find(id);
  return found != names.end() ? found->second : std::to_string(id);
}

base::Result<ContactReport> reportContacts(
    const RepeatableRun& run, const ContactReportOptions& options,
    const std::function<bool()>& wantsStop,
    const std::function<void(const std::string& what)>& showProgress) {
  const std::function<bool()> stops = wantsStop ? wantsStop : kNeverStops;
  const auto show = [&](const std::string& what) {
    if (showProgress) {
      showProgress(what);
    }
  };
  ContactReport report = reportOf(run);
  base::Result<std::vector<AvoidableContact>> contacts =
      avoidableContacts(run, options.avoidance, stops, [&](std::size_t done, std::size_t all) {
        show(std::to_string(done) + " of " + std::to_string(all) + " contacts");
      });
  if (!contacts) {
    return contacts.diagnostics();
  }
  for (AvoidableContact& contact : *contacts) {
    report.contacts.push_back({std::move(contact), {}});
  }
  if (options.influenceRange > 0.0 && !report.contacts.empty() && !stops()) {
    show("runs without single people");
    if (!addInfluences(run, options, stops, report)) {
      return base::error("contacts.no-process", {}, run.bundle.path);
    }
  }
  if (options.compareWithoutRobots && !run.recording->header()->robots.empty() && !stops()) {
    show("run without robots");
    addEffects(run, stops, report);
  }
  return report;
}

}  // namespace app
