#pragma once

#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/runs/RunPlots.h"

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
  SearchField* search_ = new SearchField(tr("Find a metric"), tr("Find a metric"), this);
  QLabel* count_ = secondaryLabel({}, this);
  QTreeWidget* tree_ = nullptr;
  NoMatchesPlaceholder* nothing_ = nullptr;
  std::vector<QTreeWidgetItem*> rows_;  // Rows of all groups.
};

class SparklineDelegate;

/// The live table of metrics with a sparkline for each, and a plot of the selected metric.
class MetricsDock : public QWidget {
  Q_OBJECT
 public:
  MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  QTableView& table() const { return *table_; }
  QComboBox& robot() const { return *robot_; }  // Hidden unless the run has several robots.
  /// Sets the metric selection, shown beside the table on request.
  void setChoice(MetricsChoice& choice);
  QToolButton& choose() const { return *choose_; }  // Toggles its visibility.

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeTable();
  QWidget* makeTop();
  QWidget* makeChooser();
  void adaptToWidth();
  void fillChooser();
  void showSnapshot();
  void fillRows();
  void showSelected();
  void fitRows();
  int rowOf(const std::string& key) const;  // -1 = none.
  int firstWithCurve() const;
  std::string selectedKey() const;

  MetricsFeed& feed_;
  QColor pale_;
  SparklineDelegate* sparkline_;
  QSplitter* parts_ = new QSplitter(Qt::Horizontal, this);  // Metric selection and metrics.
  QWidget* choice_ = nullptr;
  QToolButton* choose_ = new QToolButton(this);
  QStackedLayout* stack_ = new QStackedLayout;
  QTableWidget* table_;
  QComboBox* robot_ = new QComboBox(this);
  QWidget* chooser_;  // Includes its label.
  MetricPlot* plot_;
  int fittedRows_ = 0;
  std::string chosen_;        // Key of the metric chosen by the user.
  bool isSelecting_ = false;  // A selection by the program, not by the user.
};

}  // namespace editor
