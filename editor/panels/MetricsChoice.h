#pragma once

#include <vector>

#include <QtWidgets>

#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

namespace editor {

/// The selection of metrics: check boxes in groups with a search. A change applies to the live
/// table immediately; "Save" writes it into the metrics file of the scenario.
class MetricsChoice : public QWidget {
  Q_OBJECT
 public:
  MetricsChoice(ScenarioDocument& document, MetricsFeed& feed, const Theme& theme);
  void setTheme(const Theme& theme);
  QTreeWidget& tree() const { return *tree_; }
  QLineEdit& search() const { return *search_; }
  void chooseAll(bool chosen);
  metrics::Selection selection() const;
  QString count() const { return count_->text(); }  // "9 of 112"
  /// Writes the selection to the metrics file (created beside the scenario if there is none) and
  /// sets its name in the scenario with one undoable command.
  base::Diagnostics save();

 Q_SIGNALS:
  void saved(const base::Diagnostics& problems);
  void countChanged(const QString& count);

 private:
  void build();
  void loadSelection();
  void storeSelection();
  void filter(const QString& text);
  void showCounts();

  ScenarioDocument& document_;
  MetricsFeed& feed_;
  SearchField* search_;
  QLabel* count_;
  QTreeWidget* tree_ = nullptr;
  NoMatchesPlaceholder* nothing_ = nullptr;
  std::vector<QTreeWidgetItem*> rows_;  // Rows of all groups.
};

}  // namespace editor
