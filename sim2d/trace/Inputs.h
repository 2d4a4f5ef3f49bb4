#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"

namespace sim2d {

enum class InputKind {
  Robot,  // drives by this command instead of its planner's; to `teleop` it is the newest word
  Open,   // a door
  Close,
  Move,  // a person or robot is put somewhere else, at rest
  Add,   // a person like another one comes in
  Set,   // place, velocity and wanted velocity of a person come from outside
  Push,  // a person gets a velocity beside the own
  Stop,  // a person brakes and stays, whatever they want, until Resume or the next entry
  Resume,
  Entry,  // an entry of a person's blackboard gets a value, before the tree is ticked
  Goal    // a robot drives to a place and gives up the goals of the scenario
};
const char* inputKindName(InputKind kind);  // "robot" …

/// What somebody outside does to a running world in one step; what the kind does not name stays 0.
struct Input {
  InputKind kind = InputKind::Move;
  int id = 0;        // of the robot (-1, -2 …) or person; Add: the new person's
  std::string name;  // of the door; Add: of the person who is copied; Entry: "key=value"
  base::Pose2 pose;  // Move, Add, Set, Goal (whose heading does not count)
  base::Vec2 velocity = {0.0, 0.0};      // Set, Push [m/s]; Robot: x ahead, y to its left
  double omega = 0.0;                    // Robot [rad/s]
  base::Vec2 desiredVelocity{0.0, 0.0};  // Set [m/s]
};
bool operator==(const Input& a, const Input& b);

/// All of one step, in the order in which they act.
using StepInputs = std::vector<Input>;
/// With the step that they led to, as in Frame::step.
using RecordedInputs = std::vector<std::pair<std::int64_t, Input>>;

/// Those that led to a step, of some by step.
StepInputs inputsOf(const RecordedInputs& inputs, std::int64_t step);

/// Rows of `inputs.csv` (columns: FORMAT.md); reading gives equal values.
std::string inputsHead();
void appendInputRow(std::string& to, std::int64_t step, const Input& input);
/// Every problem with its place; steps must not run backwards.
base::Result<RecordedInputs> parseInputs(const std::string& text, const std::string& file);

}  // namespace sim2d
