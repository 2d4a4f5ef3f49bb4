#pragma once

#include <QLabel>
#include <QStackedLayout>
#include <QTableView>

#include "editor/look/Theme.h"
#include "editor/panels/RunEvents.h"

namespace editor {

class EventsModel;

/// What happened in the run, newest below; a click goes to that moment.
class EventsPanel : public QWidget {
  Q_OBJECT
 public:
  EventsPanel(RunEvents& events, SimulationRunner& runner, const Theme& theme,
              QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  QTableView& table() const { return *table_; }

 Q_SIGNALS:
  void countChanged(int count);

 private:
  void updateState();
  RunEvents& events_;
  EventsModel* model_;
  QStackedLayout* stack_;
  QTableView* table_;
};

}  // namespace editor
