#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/RunBranch.h"
#include "app/run/Session.h"
#include "sim2d/trace/ContactMarks.h"

/// Last avoidable actions: when robot and person could last have avoided a contact.
///
/// An action is a manoeuvre of one of the two from an instant of the run on: a sequence of commands
/// within the limits of the body (Manoeuvres.h). It is simulated in a copy of the process that is
/// forked at that instant, so all other bodies answer it as they do in a run. It avoids the contact
/// if the two do not touch until `settle` seconds after the time of the contact, and its robot or
/// person causes no other contact meanwhile.
///
/// The last avoidable action is the latest one among all instants before the contact. The set of
/// all actions is monotone in time: the recorded commands up to a later instant and a manoeuvre
/// from there on are an action of each earlier instant too. The set of manoeuvres from one instant
/// is not, so the instants are not bisected: every second one is tried, and those that follow an
/// instant with an action. Related: inevitable collision states (Fraichard & Asama 2004, Advanced
/// Robotics 18(10)).
namespace app {

/// A recorded run that can be repeated from its beginning.
struct RepeatableRun {
  Bundle bundle;  // of its beginning
  std::vector<RunBranch> branches;
  RecordingPtr recording;  // with events and inputs
};

/// The run in a folder. Errors: those of RunReplay; a robot is driven by an external program, which
/// cannot be copied.
base::Result<RepeatableRun> repeatableRunOf(const std::string& folder,
                                            const sim2d::ImageLoader& loader);
/// Simulates the run of a bundle to its end. Errors: those of the bundle; as above.
base::Result<RepeatableRun> repeatableRunOf(const Bundle& bundle,
                                            const std::function<bool()>& wantsStop);

struct AvoidanceOptions {
  double lookback = 10.0;    // longest time before the contact [s]
  double settle = 2.0;       // time after the contact during which an action must hold [s]
  double resolution = 0.05;  // time between two instants, at least one step [s]
  bool tryPeople = true;     // also find the last avoidable actions of people
};

/// A manoeuvre that avoids a contact.
struct AvoidingAction {
  double time = 0.0;                              // its first instant [s]
  std::string manoeuvre;                          // "brake, turn left"
  std::vector<base::Vec2> robotPath, personPath;  // with it, from that instant on, every step [m]
};

/// A contact of a robot with a person.
struct AvoidableContact {
  std::int64_t step = 0;
  double time = 0.0;                                                  // [s]
  int robot = -1, person = 0;                                         // ids
  base::Vec2 position = base::Vec2::Zero();                           // [m]
  sim2d::ContactMark::Cause cause = sim2d::ContactMark::Cause::Both;  // by closing speeds

  /// Start of the uninterrupted sight of the other before the contact [s]; none: out of sight.
  /// Robot: range and field of its detector, no wall in between. Person: kPersonSight and
  /// kPersonField. Gaps up to kSightGap, of people kPersonMemory, do not interrupt it.
  std::optional<double> robotSight, personSight;
  std::optional<AvoidingAction> robotAction, personAction;  // the last ones within `lookback`
  /// Whether braking to a standstill from `robotSight` on avoids it; none without sight.
  std::optional<bool> brakingAvoids;
  std::size_t trials = 0;  // simulated actions

  /// From the first sight on: the last avoidable action is not before it.
  bool couldRobotAvoid() const;
  bool couldPersonAvoid() const;
};
constexpr double kPersonSight = 10.0;       // range [m]
constexpr double kPersonField = base::kPi;  // full angle about the heading [rad]
constexpr double kSightGap = 0.5;           // [s]
constexpr double kPersonMemory = 3.0;       // [s]; people who evade turn away
constexpr double kSameContact = 1.0;        // [s]; touches of a pair within it are one contact

/// The contacts of robots with people in a run, by time; when `wantsStop` returns true, those that
/// are finished. Only one thread of this process may be running, and no world may exist in it.
/// Errors: the replay diverges from the recording; the system has no more processes.
base::Result<std::vector<AvoidableContact>> avoidableContacts(
    const RepeatableRun& run, const AvoidanceOptions& options,
    const std::function<bool()>& wantsStop,
    const std::function<void(std::size_t done, std::size_t all)>& showProgress = {});

/// "robot", "person", "both" or "none": who could have avoided it from the first sight on.
const char* whoCouldAvoid(const AvoidableContact& contact);

}  // namespace app
