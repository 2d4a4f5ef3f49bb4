#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <QLabel>
#include <QTableWidget>
#include <QTimer>

#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The blackboard of the person who is watched, in the state that is shown. In a run that goes on a
/// value can be typed: it acts in the next step and is recorded as an input, so that the run can be
/// repeated.
class TreeEntries : public QWidget {
  Q_OBJECT
 public:
  TreeEntries(SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);
  void showPerson(std::optional<int> id);
  QTableWidget& table() const { return *table_; }
  QString words() const { return words_->text(); }  // in place of the table, or below it

 Q_SIGNALS:
  void said(const QString& text);

 private:
  void follow();
  QString whyEmpty() const;
  bool isOurs(const QString& key) const;  // nobody else sets it
  void showRow(int row, const std::string& key, const std::string& value);
  void take(int row, int column);

  SimulationRunner& runner_;
  Theme theme_;
  std::optional<int> person_;
  QTableWidget* table_;
  QLabel* words_;
  QTimer soon_;  // shows what was typed when the table is done with it
  bool showing_ = false;
  /// What was typed and has not acted yet, with the step that is shown meanwhile.
  std::map<std::string, std::pair<std::string, std::int64_t>> typed_;
};

}  // namespace editor
