#pragma once

#include "app/run/Futures.h"
#include "editor/canvas/Layers.h"

namespace editor {

/// How the bodies of a run are drawn, by id; robots have negative ids.
class BodyStyles {
 public:
  struct Body {
    double radius = 0.35;  // [m]
    Look look = Look::Regular;
    std::vector<Vec2> footprint;  // Footprint of a robot in its own frame; empty: a disc.
  };
  /// The appearance is that of the document's people, where it has them.
  BodyStyles(const ScenarioDocument& document, const sim2d::TraceHeader& header);
  const Body& of(int id) const {
    const auto found = bodies_.find(id);
    return found == bodies_.end() ? unknownAgent_ : found->second;
  }

 private:
  std::map<int, Body> bodies_;
  Body unknownAgent_;
};

/// The style that distinguishes overlaid runs, not by colour alone.
struct GhostStyle {
  QColor color;
  QVector<qreal> dashes;  // Dash pattern in line widths; empty: solid.
  QString letter;
};
/// The style of the `index`-th run compared with the shown run, which is "A".
GhostStyle ghostStyle(std::size_t index, const Theme& theme);
constexpr std::size_t kGhostStyles = 5;

/// Onion skin: the positions of all bodies at some times before and after the shown time, as fading
/// discs (past) and rings (future).
class OnionLayer : public FullLayer {
 public:
  struct Skin {
    sim2d::FramePtr frame;
    int place = 0;  // -1: the nearest before, 1: the nearest after …
  };
  static constexpr int kSkins = 3;  // Number on each side.
  using FullLayer::FullLayer;
  void show(std::vector<Skin> skins, std::shared_ptr<const sim2d::TraceHeader> header);
  const std::vector<Skin>& skins() const { return skins_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::vector<Skin> skins_;
  std::shared_ptr<const sim2d::TraceHeader> header_;
};

/// Draws other runs at the shown time: outlines in the style of each run, with the trail of the
/// last seconds. Bodies at the same place as in the shown run are not drawn again.
class GhostLayer : public FullLayer {
 public:
  struct Ghost {
    std::size_t style = 0;
    sim2d::FramePtr frame;
    std::shared_ptr<const sim2d::TraceHeader> header;
    std::map<int, std::vector<Vec2>> trails;  // By id, up to the current positions [m].
    bool hasEnded = false;                    // Its last state; drawn fainter.
  };
  using FullLayer::FullLayer;
  /// `shown`: the state of the run that they are compared with; null: all bodies are drawn.
  void show(std::vector<Ghost> ghosts, sim2d::FramePtr shown);
  const std::vector<Ghost>& ghosts() const { return ghosts_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Returns true if the ghost's body is drawn because it differs from the shown run. For tests.
  bool isDisplaced(const Ghost& ghost, int id) const;

 private:
  void paintGhost(QPainter& painter, const Ghost& ghost) const;

  std::vector<Ghost> ghosts_;
  sim2d::FramePtr shown_;
};

/// Draws the outline of a body at a pose: a ring or the footprint, and its heading.
void paintOutline(QPainter& painter, const BodyStyles::Body& body, const base::Pose2& pose);

/// Draws the trajectories of the predicted futures of a run: those of robots, where a collision is
/// marked by colour and a cross, and, fainter, those of people.
class FuturesLayer : public FullLayer {
 public:
  using Futures = std::shared_ptr<const std::vector<app::Future>>;
  using FullLayer::FullLayer;
  void show(Futures futures);  // Null: none.
  const Futures& futures() const { return futures_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintContact(QPainter& painter, const Vec2& where) const;
  void paintPeople(QPainter& painter, const app::Future& future) const;
  void paintRobots(QPainter& painter, const app::Future& future) const;

  Futures futures_;
};

}  // namespace editor
