#pragma once

#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/PersonMetrics.h"

namespace editor {

class SparklineDelegate;

/// A person with a column of their own.
struct MeasuredPerson {
  int id = 0;  // In the run.
  QString name;
  bool operator==(const MeasuredPerson& other) const {
    return id == other.id && name == other.name;
  }
};

/// All metrics in groups, with a search: a check box selects what is measured, and the columns
/// contain the values at the shown step, also of single people. A change of the selection applies
/// to the live values immediately; "Save" writes it into the metrics file of the scenario.
class MetricsTable : public QWidget {
  Q_OBJECT
 public:
  /// Columns; those of people follow.
  enum Column { NameColumn, NowColumn, UnitColumn, SparklineColumn, FirstPersonColumn };

  MetricsTable(ScenarioDocument& document, MetricsFeed& feed, PersonMetrics& people,
               const Theme& theme);
  void setTheme(const Theme& theme);
  QTreeWidget& tree() const { return *tree_; }
  QLineEdit& search() const { return *search_; }
  QHBoxLayout& top() const { return *top_; }  // The line above the table.

  void chooseAll(bool chosen);
  metrics::Selection selection() const;
  QString count() const { return count_->text(); }  // "9 of 112"
  /// Writes the selection to the metrics file (created beside the scenario if there is none) and
  /// sets its name in the scenario with one undoable command.
  base::Diagnostics save();

  /// The columns of people.
  void setPeople(std::vector<MeasuredPerson> people);
  /// Shows the values of the feed, and those of the people.
  void showValues();
  /// The key of the current metric; empty: none.
  std::string currentKey() const;
  /// Selects the row of a metric without the signal `chosen`; empty or hidden: none.
  void setCurrentKey(const std::string& key);
  bool isVisible(const std::string& key) const;  // The filter shows its row.
  std::string firstVisible() const;              // The key of the first row that is shown.

 Q_SIGNALS:
  void saved(const base::Diagnostics& problems);
  void chosen(const std::string& key);  // By the user.
  void filtered();

 private:
  void build();
  void makeTop();
  void styleTree();
  QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const metrics::MetricInfo& info);
  QTreeWidgetItem* rowFor(const metrics::MetricInfo& info);
  void dropOwnRows();
  void fillRow(QTreeWidgetItem& row, const metrics::MetricResult* result);
  void fillPeople(QTreeWidgetItem& row, const metrics::MetricInfo& info);
  void fillEmptyRows();
  void loadSelection();
  void storeSelection();
  void filter();
  bool filterRow(QTreeWidgetItem& row, const QString& text);
  void showCounts();

  ScenarioDocument& document_;
  MetricsFeed& feed_;
  PersonMetrics& personMetrics_;
  SparklineDelegate* sparkline_;
  QColor pale_;
  QHBoxLayout* top_ = nullptr;
  SearchField* search_ = new SearchField(tr("Find a metric"), tr("Find a metric"), this);
  QLabel* count_ = secondaryLabel({}, this);
  QToolButton* onlyMeasured_ = nullptr;
  QTreeWidget* tree_ = nullptr;
  NoMatchesPlaceholder* nothing_ = nullptr;
  std::vector<QTreeWidgetItem*> groups_;                // By category.
  std::vector<QTreeWidgetItem*> rows_;                  // With check boxes.
  std::map<std::string, QTreeWidgetItem*> rowsByKey_;   // All rows of metrics.
  std::map<std::string, metrics::MetricInfo> ownInfo_;  // Of the user's formulas in the table.
  std::vector<MeasuredPerson> people_;
  bool isSelecting_ = false;  // A selection by the program, not by the user.
};

}  // namespace editor
