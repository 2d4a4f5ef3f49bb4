#pragma once

#include <functional>

#include "editor/canvas/MapScene.h"

namespace editor {

/// Functions that draw the perception and the planner data of robots in a frame (`Frame::senses`)
/// in the scene.

/// The last scan of a lidar: the visible area, and a dot where a beam hits.
void paintScan(QPainter& painter, const Theme& theme, const sim2d::RobotTelemetry::Scan& scan);
/// Candidate trajectories of a planner. With cost terms: coloured by cost, expensive ones first and
/// the chosen one last. Otherwise: the chosen one strong, others paler with higher cost, colliding
/// ones in the error colour. Without any: the lookahead point, the arc to it, and the goal.
void paintCandidates(QPainter& painter, const Theme& theme, const sim2d::RobotTelemetry& senses);
/// Rings at the positions of tracked bodies, and a line to the true position if it differs.
/// `place` returns the true position; none: no body has that number.
void paintTracks(
    QPainter& painter, const Theme& theme, const std::vector<sim2d::RobotTelemetry::Body>& bodies,
    const std::function<std::optional<Vec2>(const sim2d::RobotTelemetry::Body&)>& place);
/// A line from the true to the estimated position of a robot.
void paintLocalizationError(QPainter& painter, const Theme& theme, const Vec2& from,
                            const Vec2& believed);
/// A costmap or mask. `image`: picture of the grid. `hole`: area left out because a finer costmap
/// covers it; may be empty.
void paintCells(QPainter& painter, const sim2d::CostGrid& grid, const QImage& image,
                const QRectF& hole = {});
/// The border of a costmap that moves with the robot.
void paintCostEdge(QPainter& painter, const Theme& theme, const sim2d::CostGrid& grid);

/// Returns true if the beam hits something; other beams end at the range of the lidar.
bool isBeamHit(const sim2d::RobotTelemetry::Scan& scan, std::size_t beam);
/// End of a beam, world frame.
Vec2 beamEnd(const sim2d::RobotTelemetry::Scan& scan, std::size_t beam);
/// The estimated pose of the robot if it differs from the true one; the state is one step older
/// than the frame. None also if the robot does not perceive anything (it stands still or is
/// controlled externally).
std::optional<Pose2> divergentPoseEstimate(const sim2d::Frame& frame, std::size_t robot);
/// The relative cost of each trajectory: 0 the best, 1 the worst of the collision-free ones.
std::vector<double> relativeCosts(const std::vector<sim2d::RobotTelemetry::Candidate>& ways);

constexpr double kTrackGap = 0.08;  // Gap between a ring and its body [m].

/// The colour scale for the costs of a planner's candidate trajectories.
struct CostScale {
  double low = 0.0, high = 0.0;  // Best cost; 90th percentile of the collision-free ones.
  std::size_t open = 0, refused = 0;
};
CostScale costScaleOf(const std::vector<sim2d::RobotTelemetry::Candidate>& ways);
/// 0 at the best cost, 1 at the upper end and above.
double costShare(const CostScale& scale, double cost);
/// From blue over mauve to orange; distinguishable with red-green colour blindness.
QColor trajectoryCostColor(const Theme& theme, double share);

/// Colour of a cell: transparent if free, stronger with higher cost. Inscribed, lethal and unknown
/// cells have their own colours.
QColor costColor(const Theme& theme, std::uint8_t cost);
/// One pixel per cell, the highest y first.
QImage costImage(const sim2d::CostGrid& grid, const Theme& theme);
/// Colour of a cell in the mask of a costmap filter; transparent without effect. Speed limits are
/// stronger the lower they are.
QColor maskColor(const Theme& theme, sim2d::MaskGrid::Kind kind, std::uint8_t percent);
QImage maskImage(const sim2d::MaskGrid& mask, const Theme& theme);
QRectF areaOf(const sim2d::CostGrid& grid);  // Scene coordinates.

/// The arc from a robot pose, tangential to its heading, to a point, as driven by pure pursuit.
/// Straight if the point lies ahead.
std::vector<Vec2> pursuitArc(const Pose2& robot, const Vec2& target);

/// A robot of the shown frame with its perception and its planner data.
struct ObservedRobot {
  const sim2d::RobotTelemetry* senses = nullptr;
  QString name;
};
/// The single selected robot, if the shown frame contains its perception.
std::optional<ObservedRobot> selectedRobot(const MapScene& scene);
/// The robot whose planner data is shown: the selected one, else the first that reports any.
std::optional<ObservedRobot> observedPlanner(const MapScene& scene);
/// Returns true if the candidate trajectories have cost terms, which colours and legend show.
bool hasCostTerms(const sim2d::RobotTelemetry& senses);

}  // namespace editor
