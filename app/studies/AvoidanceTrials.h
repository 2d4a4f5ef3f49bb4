#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Batch.h"
#include "app/studies/Manoeuvres.h"
#include "app/studies/RunStepper.h"

/// Manoeuvres simulated in copies of this process, for AvoidableContact.h.
namespace app {

/// A contact to avoid.
struct AvoidanceTarget {
  int robot = -1, person = 0;
  std::int64_t contactStep = 0;
  std::int64_t endStep = 0;    // up to which the pair must not touch
  std::int64_t firstStep = 0;  // of the instants
  std::int64_t stride = 1;     // steps between two instants
};

/// Which actions are still to be found.
struct WantedActions {
  bool robot = true, person = true;
};

/// The latest avoiding actions in a part of the run.
struct ScanResult {
  std::optional<AvoidingAction> robot, person;
  std::size_t trials = 0;
};

/// The message exchanged with a copy of the process; reading gives equal values.
std::string scanText(const ScanResult& result);
std::optional<ScanResult> scanOf(const std::string& text);

/// Tries all manoeuvres at the instants from the current step up to `until` (excluded), each in a
/// copy of the process. The stepper is at a later step afterwards. Nullopt: no more processes.
std::optional<ScanResult> scanInstants(RunStepper& stepper, const sim2d::TraceHeader& header,
                                       const AvoidanceTarget& target, std::int64_t until,
                                       const WantedActions& wanted);

/// Simulates a manoeuvre of the robot from the current step on, in this process. Nullopt: it does
/// not avoid the contact.
std::optional<AvoidingAction> tryRobot(RunStepper& stepper, const sim2d::TraceHeader& header,
                                       const AvoidanceTarget& target,
                                       const RobotManoeuvre& manoeuvre);
std::optional<AvoidingAction> tryPerson(RunStepper& stepper, const sim2d::TraceHeader& header,
                                        const AvoidanceTarget& target,
                                        const PersonManoeuvre& manoeuvre);

/// Sends a request and waits for the answer. Nullopt: the process has ended, or `wantsStop`
/// returned true.
std::optional<std::string> answerOf(WorkerProcess& process, const std::string& request,
                                    const std::function<bool()>& wantsStop);
/// The answer of `work` in a copy of this process. Nullopt: no more processes, or the copy ended.
std::optional<std::string> inCopy(const std::function<std::string()>& work,
                                  const std::function<bool()>& wantsStop);

}  // namespace app
