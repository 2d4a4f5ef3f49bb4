#pragma once

#include <cstdint>

#include "editor/run/SimulationRunner.h"
#include "editor/trees/TreeGraph.h"

namespace editor {

/// The return values of tree nodes over the time of a run as horizontal bands, one row per visible
/// node of the graph. A click seeks to that time.
class TreeHistory : public QAbstractScrollArea {
  Q_OBJECT
 public:
  struct StatusInterval {
    std::int64_t from = 0;  // First step; up to the next interval, or to the newest state.
    base::NodeStatus status = base::NodeStatus::Idle;
  };

  TreeHistory(const TreeGraph& graph, SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  void showPerson(int id);  // Person whose tree the graph shows; it may have changed.
  void choose(int node);
  /// The known intervals of a node in order of time.
  const std::vector<StatusInterval>& intervalsOf(int node) const {
    return bands_[static_cast<std::size_t>(node)];
  }
  QRect bandOf(int node) const;  // In viewport coordinates; null: hidden.
  std::int64_t stepAt(int x) const;
  int xOf(std::int64_t step) const;
  std::vector<double> labelledTimes() const;  // [s], of the axis.
  QSize sizeHint() const override { return {400, 120}; }

 Q_SIGNALS:
  void choiceChanged(int node);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void follow();  // Reads new states.
  void readStep(std::int64_t step);
  void findNodes();
  void updateScrollBars();
  int rowOf(int node) const;  // -1 = hidden.
  int nodeAtY(int y) const;
  std::int64_t newestStep() const;
  double stepLength() const;  // [s]
  void paintRow(QPainter& painter, int row, int node) const;
  void paintBand(QPainter& painter, const QRect& band,
                 const std::vector<StatusInterval>& its) const;
  void paintAxis(QPainter& painter) const;

  const TreeGraph& graph_;
  SimulationRunner& runner_;
  Theme theme_;
  int person_ = 0;
  int chosen_ = -1;
  RecordingPtr recording_;  // The recording that has been read.
  std::int64_t read_ = 0;   // Last step that has been read.
  sim2d::TreeChanges::Paths paths_;
  std::vector<int> nodesOfPaths_;
  QTimer more_;                                     // Schedules reading of the rest.
  bool isOtherTree_ = false;                        // The run has a different tree.
  std::vector<std::vector<StatusInterval>> bands_;  // By node.
};

}  // namespace editor
