#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"

namespace sim2d {

enum class InputKind {
  Robot,  // a velocity command that replaces the planner's; for planner `teleop` the latest command
  Open,   // opens a door
  Close,
  Move,  // moves a person or robot to a pose, at rest
  Add,   // spawns a copy of a person
  Set,   // sets position, velocity and desired velocity of a person
  Push,  // adds a velocity to a person's own for one step
  Stop,  // a person brakes and stays until Resume or until they enter again
  Resume,
  Entry,  // sets an entry of a person's blackboard before the tree is ticked
  Goal    // a robot drives to a position and abandons its scenario goals
};
const char* inputKindName(InputKind kind);  // "robot" …

/// An external input to a running world in one step. Members that the kind does not use are 0.
struct Input {
  InputKind kind = InputKind::Move;
  int id = 0;        // of the robot (-1, -2 …) or person; Add: the new person's
  std::string name;  // of the door; Add: name of the person copied; Entry: "key=value"
  base::Pose2 pose;  // Move, Add, Set, Goal (heading ignored)
  base::Vec2 velocity = {0.0, 0.0};      // Set, Push [m/s]; Robot: x ahead, y to its left
  double omega = 0.0;                    // Robot [rad/s]
  base::Vec2 desiredVelocity{0.0, 0.0};  // Set [m/s]
};
bool operator==(const Input& a, const Input& b);

/// The inputs of one step, in the order of application.
using StepInputs = std::vector<Input>;
/// Each with the step that it led to, as in Frame::step.
using RecordedInputs = std::vector<std::pair<std::int64_t, Input>>;

/// The inputs that led to `step`.
StepInputs inputsOf(const RecordedInputs& inputs, std::int64_t step);

/// Rows of `inputs.csv` (columns: FORMAT.md); reading returns equal values.
std::string inputsHeader();
void appendInputRow(std::string& to, std::int64_t step, const Input& input);
/// Reports all problems with their places; steps must not decrease.
base::Result<RecordedInputs> parseInputs(const std::string& text, const std::string& file);

}  // namespace sim2d
