#include <array>

#include <QHeaderView>
#include <QScrollBar>
#include <QStackedLayout>
#include <QTableWidget>

#include "editor/look/Form.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/Playback.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

/// What happened in the run, newest below; a click goes to that moment.
class EventsPanel : public QWidget {
 public:
  explicit EventsPanel(PanelContext& context)
      : context_(context), stack_(new QStackedLayout(this)), table_(new QTableWidget(0, 2, this)) {
    styleTable(*table_, tr("Events"));
    QHeaderView* header = table_->horizontalHeader();
    header->hide();
    header->setSectionResizeMode(0, QHeaderView::Fixed);
    header->resizeSection(0, 72);
    header->setStretchLastSection(true);
    stack_->addWidget(emptyState(tr("Nothing has happened yet: press Space to run."), this));
    stack_->addWidget(table_);
    const auto seek = [this](const QModelIndex& at) {
      context_.runner.seek(eventAt(at.row()).step);
    };
    connect(table_, &QTableView::clicked, this, seek);
    connect(table_, &QTableView::activated, this, seek);
    connect(&context.happened, &RunEvents::cleared, this, [this] { setCount(0); });
    connect(&context.happened, &RunEvents::added, this, [this](int, int last) {
      const QScrollBar* bar = table_->verticalScrollBar();
      const bool atEnd = bar->value() == bar->maximum();
      setCount(last + 1);
      if (atEnd) {
        table_->scrollToBottom();
      }
    });
    connect(&context, &PanelContext::themeChanged, this, &EventsPanel::setTheme);
    setTheme(context.theme());
  }

 private:
  const RunEvent& eventAt(int row) const {
    return context_.happened.events()[static_cast<std::size_t>(row)];
  }
  void setTheme(const Theme& theme) {
    for (std::size_t mark = 0; mark < icons_.size(); ++mark) {
      icons_[mark] = eventIcon(static_cast<EventMark>(mark), theme);
    }
    pale_ = theme.color(Role::TextSecondary);
    for (int row = 0; row < table_->rowCount(); ++row) {
      paintRow(row);
    }
  }
  void paintRow(int row) {
    const EventMark mark = markOfEvent(eventAt(row).event.kind);
    table_->item(row, 0)->setForeground(pale_);
    table_->item(row, 1)->setIcon(icons_[static_cast<std::size_t>(mark)]);
  }
  void setCount(int count) {
    int row = table_->rowCount();
    table_->setRowCount(count);
    for (; row < count; ++row) {
      auto* time = new QTableWidgetItem(clockText(eventAt(row).time));
      time->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, 0, time);
      table_->setItem(row, 1, new QTableWidgetItem(eventAt(row).text));
      paintRow(row);
    }
    stack_->setCurrentIndex(count > 0 ? 1 : 0);
    Q_EMIT context_.counted(this, count);
  }

  PanelContext& context_;
  std::array<QIcon, kEventMarks> icons_;
  QColor pale_;
  QStackedLayout* stack_;
  QTableWidget* table_;
};

}  // namespace

void addEventsPanel(PanelRegistry& to) {
  to.add(closedBelow(70, QObject::tr("Events")),
         [](PanelContext& context) { return new EventsPanel(context); });
}

}  // namespace editor
