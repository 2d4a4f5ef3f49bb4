#include "editor/panels/EventsPanel.h"

#include <array>

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QScrollBar>

#include "editor/look/Form.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/PlaybackActions.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

/// Columns: time, mark and sentence.
class EventsModel : public QAbstractTableModel {
 public:
  EventsModel(const RunEvents& events, QObject* parent)
      : QAbstractTableModel(parent), events_(events) {}

  void setTheme(const Theme& theme) {
    for (int i = 0; i < static_cast<int>(icons_.size()); ++i) {
      icons_.at(static_cast<std::size_t>(i)) = eventIcon(static_cast<EventMark>(i), theme);
    }
    pale_ = theme.color(Role::TextSecondary);
    if (count_ > 0) {
      Q_EMIT dataChanged(index(0, 0), index(count_ - 1, 1));
    }
  }
  void clear() {
    beginResetModel();
    count_ = 0;
    endResetModel();
  }
  void add(int last) {
    beginInsertRows({}, count_, last);
    count_ = last + 1;
    endInsertRows();
  }
  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : count_;
  }
  int columnCount(const QModelIndex& = {}) const override { return 2; }
  QVariant data(const QModelIndex& index, int role) const override {
    if (!index.isValid()) {
      return {};
    }
    const RunEvent& event = events_.events()[static_cast<std::size_t>(index.row())];
    const bool isTime = index.column() == 0;
    switch (role) {
      case Qt::DisplayRole:
        return isTime ? clockText(event.time) : event.text;
      case Qt::DecorationRole:
        return isTime ? QVariant()
                      : icons_.at(static_cast<std::size_t>(markOfEvent(event.event.kind)));
      case Qt::ForegroundRole:
        return isTime ? pale_ : QVariant();
      case Qt::TextAlignmentRole:
        return static_cast<int>((isTime ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      default:
        return {};
    }
  }

 private:
  const RunEvents& events_;
  std::array<QIcon, 7> icons_;
  QColor pale_;
  int count_ = 0;
};

EventsPanel::EventsPanel(RunEvents& events, SimulationRunner& runner, const Theme& theme,
                         QWidget* parent)
    : QWidget(parent),
      events_(events),
      model_(new EventsModel(events, this)),
      stack_(new QStackedLayout(this)),
      table_(new QTableView(this)) {
  styleTable(*table_, *model_, tr("Events"));
  table_->horizontalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Fixed);
  table_->setColumnWidth(0, 72);
  table_->horizontalHeader()->setStretchLastSection(true);
  stack_->addWidget(emptyState(tr("Nothing has happened yet: press Space to run."), this));
  stack_->addWidget(table_);
  const auto seek = [this, &runner](const QModelIndex& index) {
    runner.seek(events_.events()[static_cast<std::size_t>(index.row())].step);
  };
  connect(table_, &QTableView::clicked, this, seek);
  connect(table_, &QTableView::activated, this, seek);
  connect(&events_, &RunEvents::cleared, this, [this] {
    model_->clear();
    updateState();
  });
  connect(&events_, &RunEvents::added, this, [this](int, int last) {
    const QScrollBar* bar = table_->verticalScrollBar();
    const bool atEnd = bar->value() == bar->maximum();
    model_->add(last);
    updateState();
    if (atEnd) {
      table_->scrollToBottom();
    }
  });
  setTheme(theme);
}

void EventsPanel::setTheme(const Theme& theme) {
  model_->setTheme(theme);
}

void EventsPanel::updateState() {
  stack_->setCurrentIndex(model_->rowCount() > 0 ? 1 : 0);
  Q_EMIT countChanged(model_->rowCount());
}

void addEventsPanel(PanelRegistry& to) {
  to.add({70, QObject::tr("Events"), Qt::BottomDockWidgetArea}, [](PanelContext& context) {
    auto* panel = new EventsPanel(context.happened, context.runner, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &EventsPanel::setTheme);
    QObject::connect(panel, &EventsPanel::countChanged, &context,
                     [&context, panel](int count) { Q_EMIT context.counted(panel, count); });
    return panel;
  });
}

}  // namespace editor
