#pragma once

#include <map>
#include <memory>
#include <vector>

#include "editor/canvas/Layers.h"
#include "sim2d/trace/Recording.h"

namespace editor {

/// What bodies of a run are drawn with, by id; robots have negative ones.
class RunBodies {
 public:
  struct Body {
    double radius = 0.35;  // [m]
    Look look = Look::Regular;
    std::vector<Vec2> footprint;  // of a robot, in its frame; empty: a disc
  };
  /// The looks are those of the document's people, where it has them.
  RunBodies(const ScenarioDocument& document, const sim2d::TraceHeader& header);
  const Body& of(int id) const;

 private:
  std::map<int, Body> bodies_;
  Body stranger_;
};

/// What tells runs apart that are drawn over one another, not by colour alone.
struct GhostStyle {
  QColor color;
  QVector<qreal> dashes;  // of its lines, in widths; empty: solid
  QString letter;
};
/// Of the `index`-th of the runs that are compared with the one that is shown, which is "A".
GhostStyle ghostStyle(std::size_t index, const Theme& theme);
constexpr std::size_t kGhostStyles = 5;

/// Where everybody was some time before the moment that is shown, and where they will be then:
/// discs that fade, and rings that fade.
class OnionLayer : public FullLayer {
 public:
  struct Skin {
    sim2d::FramePtr frame;
    int place = 0;  // -1: the nearest before, 1: the nearest after …
  };
  static constexpr int kSkins = 3;  // on each side
  using FullLayer::FullLayer;
  void show(std::vector<Skin> skins, std::shared_ptr<const sim2d::TraceHeader> header);
  const std::vector<Skin>& skins() const { return skins_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  std::vector<Skin> skins_;
  std::shared_ptr<const sim2d::TraceHeader> header_;
};

/// Other runs at the moment that is shown: outlines in the style of each, with the way of the last
/// seconds. Who stands where the shown run has them is not drawn twice.
class GhostLayer : public FullLayer {
 public:
  struct Ghost {
    std::size_t style = 0;
    sim2d::FramePtr frame;
    std::shared_ptr<const sim2d::TraceHeader> header;
    std::map<int, std::vector<Vec2>> trails;  // by id, up to where they are [m]
  };
  using FullLayer::FullLayer;
  /// `shown`: the state of the run that they are compared with; null: all are drawn.
  void show(std::vector<Ghost> ghosts, sim2d::FramePtr shown);
  const std::vector<Ghost>& ghosts() const { return ghosts_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Of a body that is drawn [px/m aside]; for tests.
  bool isApart(const Ghost& ghost, int id) const;

 private:
  void paintGhost(QPainter& painter, const Ghost& ghost) const;

  std::vector<Ghost> ghosts_;
  sim2d::FramePtr shown_;
};

/// The outline of a body where it stands: a ring or the footprint, and its heading.
void paintOutline(QPainter& painter, const RunBodies::Body& body, const base::Pose2& pose);

}  // namespace editor
