#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QAbstractScrollArea>
#include <QTimer>

#include "editor/run/SimulationRunner.h"
#include "editor/trees/TreeGraph.h"

namespace editor {

/// What each node of a tree returned over the time of a run, as bands below each other, one row per
/// node that the graph shows. A click looks at that moment.
class TreeHistory : public QAbstractScrollArea {
  Q_OBJECT
 public:
  struct Stretch {
    std::int64_t from = 0;  // step; to the next one, or to the newest state
    base::NodeStatus status = base::NodeStatus::Idle;
  };

  TreeHistory(const TreeGraph& graph, SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  void showPerson(int id);  // of the tree of the graph, which may be another one now
  void choose(int node);
  /// What is known of a node by now, in order of time.
  const std::vector<Stretch>& stretchesOf(int node) const {
    return bands_[static_cast<std::size_t>(node)];
  }
  QRect bandOf(int node) const;  // in the viewport; null: not shown
  std::int64_t stepAt(int x) const;
  int xOf(std::int64_t step) const;
  QSize sizeHint() const override { return {400, 120}; }

 Q_SIGNALS:
  void chose(int node);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void follow();  // reads what is new
  void readStep(std::int64_t step);
  void findNodes();
  void fitBars();
  int rowOf(int node) const;  // -1 = not shown
  int nodeAtY(int y) const;
  std::int64_t newestStep() const;
  double stepLength() const;  // [s]
  void paintRow(QPainter& painter, int row, int node) const;
  void paintBand(QPainter& painter, const QRect& band, const std::vector<Stretch>& its) const;
  void paintAxis(QPainter& painter) const;

  const TreeGraph& graph_;
  SimulationRunner& runner_;
  Theme theme_;
  int person_ = 0;
  int chosen_ = -1;
  RecordingPtr recording_;  // that was read
  std::int64_t read_ = 0;   // the last step of it
  sim2d::TreeChanges::Paths paths_;
  std::vector<int> nodesOfPaths_;
  QTimer more_;                              // of it is to be read
  bool isOther_ = false;                     // the run is of another tree
  std::vector<std::vector<Stretch>> bands_;  // by node
};

}  // namespace editor
