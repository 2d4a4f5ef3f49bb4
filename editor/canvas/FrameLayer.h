#pragma once

#include <unordered_map>

#include "editor/canvas/Layers.h"
#include "editor/canvas/OverlayPainter.h"
#include "editor/canvas/Trails.h"

namespace editor {

/// A body of the run as currently shown, interpolated between two frames.
struct ShownBody {
  int id = 0;  // Negative for robots.
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // Velocity in the frame [m/s].
  double radiusPx = 10.0;        // Radius as drawn.
  Look look = Look::Regular;
  bool isChosen = false;
};

/// A single item that draws all bodies of a frame from a sprite atlas, with trails, robot paths,
/// speech and, for selected people, personal spaces and forces.
class FrameLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;

  /// Starts a run; appearance, sizes and names are read from the document.
  void begin();
  /// Shows a frame. With a recording, trails include the frames that were skipped since the
  /// previous one; otherwise they connect the shown frames.
  void show(sim2d::FramePtr frame, const sim2d::Recording* recording = nullptr);
  /// Interpolates all bodies between the previous and the current frame; 1: current frame. Returns
  /// true if the picture changes.
  bool setInterpolation(double share);
  void end() {
    frame_.reset();
    whole_.reset();
    bodies_.clear();
    before_.clear();
    places_.clear();
    speeches_.clear();
    hearings_.clear();
  }
  const sim2d::Frame* frame() const { return frame_.get(); }
  /// Leaves out what robots perceive and plan. Only the newest state of a run contains these data,
  /// so views of several runs beside each other would otherwise differ.
  void setSensesHidden(bool hidden);
  bool areSensesHidden() const { return areSensesHidden_; }
  /// Adds speech events. They are shown for some seconds from `time` on, also when looking back.
  void addSpeech(const std::vector<sim2d::Event>& events, double time);

  /// The agent whose body is at a point, or within 8 px of it.
  std::optional<int> agentAt(const Vec2& world) const;
  EntityId entityOf(int id) const { return agent(id).entity; }  // None for spawned agents.
  QString nameOf(int id) const { return agent(id).name; }
  std::optional<Vec2> positionOf(int id) const {
    const Body* found = body(id);
    return found == nullptr ? std::nullopt : std::optional<Vec2>(found->pose.position);
  }
  std::vector<ShownBody> shownBodies() const;
  /// True if a body of the frame is selected.
  bool hasSelectedBody() const {
    return std::any_of(bodies_.begin(), bodies_.end(),
                       [this](const Body& body) { return isChosen(body); });
  }
  std::vector<Label> labels() const;
  std::vector<QRectF> labelObstacles() const;

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Agent {
    QString name;
    EntityId entity;
    Look look = Look::Regular;
    sim2d::PersonKind kind = sim2d::PersonKind::Adult;
    double radius = 0.35;              // [m]
    std::vector<Vec2> footprint = {};  // Robots only.
    sim2d::Kinematics kinematics = sim2d::Kinematics::Differential;
  };
  /// A person, or a robot (negative id), in the current frame.
  struct Body {
    int id = 0;
    const Agent* agent = nullptr;
    Pose2 pose;
    Pose2 at;                      // Pose in the frame; `pose` is the interpolated one.
    Vec2 velocity = Vec2::Zero();  // [m/s]
    bool isRobot() const { return id < 0; }
  };
  struct Speech {
    int id = 0;
    QString text;
    double since = 0.0;  // [s]
  };
  struct Hearing {
    int listener = 0, speaker = 0;
    double since = 0.0;  // [s]
  };
  void updateAgents(const sim2d::TraceHeader& header, const sim2d::Frame& frame);
  const Body* body(int id) const {
    const auto found = places_.find(id);
    return found == places_.end() ? nullptr : &bodies_[found->second];
  }
  const Agent& agent(int id) const {
    const auto found = agents_.find(id);
    return found == agents_.end() ? unknownAgent_ : found->second;
  }
  bool isLabelled(const Body& body, bool isNamed) const;
  bool isChosen(const Body& body) const {
    return body.agent->entity ? document().isSelected(body.agent->entity)
                              : mapScene().spawnedAgent() == body.id;
  }
  double figureRadiusPx(const Body& body, double pixelsPerMetre) const;
  PersonFigure figureOf(const Body& person, double pixelsPerMetre) const;
  void paintTrails(QPainter& painter) const;
  void paintRobotPaths(QPainter& painter) const;
  void paintScans(QPainter& painter) const;
  void paintCandidateTrajectories(QPainter& painter) const;
  void paintEstimatedPoses(QPainter& painter) const;
  void paintPull(QPainter& painter) const;
  void paintPush(QPainter& painter) const;
  void paintPlacement(QPainter& painter) const;
  void paintPeople(QPainter& painter) const;
  void paintRobot(QPainter& painter, const Body& robot) const;
  void paintRobots(QPainter& painter) const;
  void paintSpeech(QPainter& painter) const;
  void paintHearing(QPainter& painter) const;
  void paintBubble(QPainter& painter, const Body& speaker, const Speech& speech) const;
  void paintForces(QPainter& painter) const;

  sim2d::FramePtr frame_;
  sim2d::FramePtr whole_;  // The same, with its senses.
  bool areSensesHidden_ = false;
  std::unordered_map<int, Pose2> before_;  // Poses in the previous frame, one step earlier.
  double interpolation_ = 1.0;
  std::vector<Body> bodies_;  // People, then robots.
  std::unordered_map<int, Agent> agents_;
  Agent unknownAgent_;                           // For agents not in the document or header.
  std::unordered_map<int, std::size_t> places_;  // Index in bodies_.
  bool hasBodySizes_ = false;
  Trails trails_;
  std::vector<Speech> speeches_;  // Sorted by time, as are the hearings.
  std::vector<Hearing> hearings_;
};

constexpr std::size_t kMaxTerms = 40;  // With more people, only the total is drawn.

}  // namespace editor
