#pragma once

#include <cstdint>
#include <vector>

#include <QtWidgets>

#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"
#include "editor/trees/TreeGraph.h"
#include "editor/trees/TreeHistory.h"

namespace editor {

/// The nodes that are running in the shown state, in the order of the tree, each with the time
/// since it started. Leaves are emphasized.
class RunningNodes : public QWidget {
  Q_OBJECT
 public:
  RunningNodes(const TreeGraph& graph, const TreeHistory& history, SimulationRunner& runner,
               const Theme& theme);
  void setTheme(const Theme& theme);
  /// The return values by node at this step; empty: no run is shown.
  void show(const std::vector<base::NodeStatus>& statuses, std::int64_t step);
  QTableWidget& table() const { return *table_; }
  QString placeholder() const { return placeholder_->text(); }  // Instead of the table.

 Q_SIGNALS:
  void choiceChanged(int node);

 private:
  void fillRow(int row, int node);
  bool isRunningLeaf(int node) const;
  QString durationText(int node) const;

  const TreeGraph& graph_;
  const TreeHistory& history_;
  SimulationRunner& runner_;
  Theme theme_;
  std::vector<base::NodeStatus> statuses_;
  std::vector<int> running_;  // One per row.
  std::int64_t step_ = -1;
  QTableWidget* table_;
  QLabel* placeholder_ = emptyState({}, this);
};

}  // namespace editor
