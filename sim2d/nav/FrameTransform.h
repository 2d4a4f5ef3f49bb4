#pragma once

#include "sim2d/base/Types.h"

/// Poses in moving frames: map, odom, robot (REP 105). A frame is given by its pose in its parent
/// frame. Headings are in (-pi, pi].
namespace sim2d {

inline bool isIdentity(const base::Pose2& frame) {
  return frame == base::Pose2{};
}

/// Converts a pose from `frame` to the parent of `frame`. With the identity, the result is
/// bit-identical.
inline base::Pose2 toParent(const base::Pose2& frame, const base::Pose2& inFrame) {
  if (isIdentity(frame)) {
    return inFrame;
  }
  return {frame.toWorld(inFrame.position), base::wrapToPi(frame.heading + inFrame.heading)};
}

/// Inverse: converts a pose from the parent of `frame` to `frame`.
inline base::Pose2 toFrame(const base::Pose2& frame, const base::Pose2& inParent) {
  if (isIdentity(frame)) {
    return inParent;
  }
  return {frame.toLocal(inParent.position), base::angleDiff(inParent.heading, frame.heading)};
}

/// The pose of the parent in `frame`.
inline base::Pose2 inverse(const base::Pose2& frame) {
  return toFrame(frame, base::Pose2{});
}

/// The frame in which the pose `inParent` has the coordinates `inFrame`.
inline base::Pose2 frameBetween(const base::Pose2& inParent, const base::Pose2& inFrame) {
  if (inParent == inFrame) {
    return {};
  }
  base::Pose2 frame{base::Vec2::Zero(), base::angleDiff(inParent.heading, inFrame.heading)};
  frame.position = inParent.position - frame.toWorld(inFrame.position);
  return frame;
}

}  // namespace sim2d
