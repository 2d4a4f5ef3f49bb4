#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "editor/canvas/Layers.h"
#include "editor/canvas/OverlayPainter.h"
#include "editor/canvas/Trails.h"
#include "sim2d/trace/Recording.h"

namespace editor {

/// Somebody of the run as they are shown now, between two frames.
struct ShownBody {
  int id = 0;  // of robots: below 0
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s], of the frame
  double radiusPx = 10.0;        // as drawn
  Look look = Look::Regular;
  bool isChosen = false;
};

/// One item that paints everybody of a frame from a sprite atlas, with trails, robot paths, speech
/// and, for selected people, personal spaces and forces.
class FrameLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;

  /// Looks, sizes and names are taken from the document when a run begins.
  void begin();
  /// Trails tell of the recording what was passed over since the frame before; without one they
  /// join what was shown.
  void show(std::shared_ptr<const sim2d::Frame> frame, const sim2d::Recording* recording = nullptr);
  /// Everybody on the way from the frame shown before, where they are after this share of the step;
  /// 1: as the frame has them. Whether that makes a difference.
  bool setShare(double share);
  void end();
  const sim2d::Frame* frame() const { return frame_.get(); }
  /// What was said; shown for some seconds from then on, also when looking back.
  void hear(const std::vector<sim2d::Event>& events, double time);

  /// Whose body is under a point, or within 8 px of it.
  std::optional<int> agentAt(const Vec2& world) const;
  EntityId entityOf(int id) const { return agent(id).entity; }  // none: came in by a source
  QString nameOf(int id) const { return agent(id).name; }
  std::optional<Vec2> positionOf(int agent) const;
  std::vector<ShownBody> shownBodies() const;
  bool isAnybodyChosen() const;  // of those in the frame
  std::vector<Label> labels() const;
  std::vector<QRectF> solidParts() const;

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Agent {
    QString name;
    EntityId entity;
    Look look = Look::Regular;
    sim2d::PersonKind kind = sim2d::PersonKind::Adult;
    double radius = 0.35;         // [m]
    std::vector<Vec2> footprint;  // robots
    sim2d::Kinematics kinematics = sim2d::Kinematics::Differential;
  };
  /// A person, or a robot (with a negative id), in the frame that is shown.
  struct Body {
    int id = 0;
    const Agent* agent = nullptr;
    Pose2 pose;
    Pose2 at;  // in the frame; pose: where it is shown
    bool isMoving = false;
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
  void meet(const sim2d::TraceHeader& header, const sim2d::Frame& frame);
  const Body* body(int id) const;
  const Agent& agent(int id) const;
  std::optional<Label> robotLabel(const Body& body) const;
  std::optional<Label> personLabel(const Body& body) const;
  bool isChosen(const Body& body) const;
  double figureRadiusPx(const Body& body, double pixelsPerMetre) const;
  PersonFigure figureOf(const Body& person, double pixelsPerMetre) const;
  void paintTrails(QPainter& painter) const;
  void paintRobotPaths(QPainter& painter) const;
  void paintPerceived(QPainter& painter) const;
  void paintBelieved(QPainter& painter) const;
  void paintPull(QPainter& painter) const;
  void paintPush(QPainter& painter) const;
  void paintPeople(QPainter& painter) const;
  void paintRobot(QPainter& painter, const Body& robot) const;
  void paintSpeech(QPainter& painter) const;
  void paintHearing(QPainter& painter) const;
  void paintBubble(QPainter& painter, const Body& speaker, const Speech& speech) const;
  void paintForces(QPainter& painter) const;

  void rememberPlaces();
  std::shared_ptr<const sim2d::Frame> frame_;
  std::unordered_map<int, Pose2> before_;  // in the frame shown before, one step earlier
  double share_ = 1.0;
  std::vector<Body> bodies_;  // people, then robots
  std::unordered_map<int, Agent> agents_;
  Agent stranger_;                               // people from sources of whom nothing is known
  std::unordered_map<int, std::size_t> places_;  // in bodies_
  bool hasMet_ = false;
  Trails trails_;
  std::vector<Speech> speeches_;  // by their times, as the next
  std::vector<Hearing> hearings_;
};

/// The force terms on a person that the canvas draws, in the order of the legend. Empty when the
/// frame has no forces or the person is not in it. The last one is the sum.
std::vector<ForceArrow> forcesOn(const sim2d::Frame& frame, int humanId);
constexpr std::size_t kMostTerms = 40;  // people whose terms are drawn; of more the total alone

}  // namespace editor
