#pragma once

#include "sim2d/base/Types.h"

/// Poses in frames that move: map, odom, the robot (REP 105). A frame is given as its pose in its
/// parent frame. Headings are in (-pi, pi].
namespace sim2d {

inline bool isIdentity(const base::Pose2& frame) {
  return frame == base::Pose2{};
}

/// A pose that is given in `frame`, in the parent of `frame`. An identity changes no bit.
inline base::Pose2 toParent(const base::Pose2& frame, const base::Pose2& inFrame) {
  if (isIdentity(frame)) {
    return inFrame;
  }
  return {frame.toWorld(inFrame.position), base::wrapToPi(frame.heading + inFrame.heading)};
}

/// The inverse: a pose that is given in the parent of `frame`, in `frame`.
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

/// The frame in which a body that is at `inParent` is at `inFrame`.
inline base::Pose2 frameBetween(const base::Pose2& inParent, const base::Pose2& inFrame) {
  if (inParent == inFrame) {
    return {};
  }
  base::Pose2 frame{base::Vec2::Zero(), base::angleDiff(inParent.heading, inFrame.heading)};
  frame.position = inParent.position - frame.toWorld(inFrame.position);
  return frame;
}

}  // namespace sim2d
