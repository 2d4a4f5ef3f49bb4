#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The blackboard of the watched person in the shown state. During a run values can be edited: they
/// take effect in the next step and are recorded as inputs, so that the run is reproducible.
class BlackboardView : public QWidget {
  Q_OBJECT
 public:
  BlackboardView(SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  void showPerson(std::optional<int> id);
  QTableWidget& table() const { return *table_; }
  QString words() const { return words_->text(); }  // Shown instead of the table, or below it.

 Q_SIGNALS:
  void messageChanged(const QString& text);

 private:
  void follow();
  QString whyEmpty() const;
  bool isUserSet(const QString& key) const;  // No other source sets the entry.
  void showRow(int row, const std::string& key, const std::string& value);
  void take(int row, int column);

  SimulationRunner& runner_;
  Theme theme_;
  std::optional<int> person_;
  QTableWidget* table_;
  QLabel* words_;
  QTimer soon_;  // Shows the typed text after the table has finished editing.
  bool showing_ = false;
  /// Edited values that have not taken effect yet, with the step shown at that time.
  std::map<std::string, std::pair<std::string, std::int64_t>> typed_;
};

}  // namespace editor
