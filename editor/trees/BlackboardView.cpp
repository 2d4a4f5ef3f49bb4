#include "editor/trees/BlackboardView.h"

#include <algorithm>
#include <utility>

#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/PendingEdit.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

enum EntryColumn { EntryKey, EntryValue, EntryColumns };

constexpr int kKeyWidth = 220;

}  // namespace

BlackboardView::BlackboardView(SimulationRunner& runner, const Theme& theme)
    : runner_(runner),
      theme_(theme),
      table_(new QTableWidget(0, EntryColumns, this)),
      words_(emptyState({}, this)) {
  styleTable(*table_, tr("Blackboard"));
  table_->setHorizontalHeaderLabels({tr("Entry"), tr("Value")});
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setColumnWidth(EntryKey, kKeyWidth);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {table_});
  layout->addWidget(words_, 1);
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &BlackboardView::follow);
  connect(table_, &QTableWidget::cellChanged, this, &BlackboardView::take);
  connect(&runner_, &SimulationRunner::entriesChanged, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::finished, this, &BlackboardView::follow);
  connect(&runner_, &SimulationRunner::inputsRefused, this,
          [this](const base::Diagnostics& problems) {
            typed_.clear();
            Q_EMIT messageChanged(QString::fromStdString(problems.front().message));
            follow();
          });
  setTheme(theme);
}

void BlackboardView::setTheme(const Theme& theme) {
  theme_ = theme;
  follow();
}

void BlackboardView::showPerson(std::optional<int> id) {
  if (id != person_) {
    commitPendingEdit(*table_);  // The text is for the previous person.
    person_ = id;
    typed_.clear();
  }
  if (id != runner_.watched()) {
    runner_.watchBlackboard(id);
  }
  follow();
}

QString BlackboardView::whyEmpty() const {
  if (runner_.state() == SimulationRunner::State::Editing) {
    return tr("The blackboard is available during a run: press Space.");
  }
  if (runner_.isRecorded()) {
    return runner_.canBranchFromShown()
               ? tr("Recorded runs contain no blackboard. \"Branch from here\" (in the menu Run) "
                    "replays the run with it.")
               : tr("Recorded runs contain no blackboard.");
  }
  if (runner_.isLookingBack() || runner_.isFinished()) {
    return tr(
        "Not recorded at this time: the blackboard is recorded from the step in which the person "
        "is selected.");
  }
  return tr("The tree has no entries.");
}

bool BlackboardView::isUserSet(const QString& key) const {
  return key == QLatin1String("id") || key == QLatin1String("dt");
}

void BlackboardView::showRow(int row, const std::string& key, const std::string& value) {
  const auto typed = typed_.find(key);
  const bool waits = typed != typed_.end();
  const QString texts[] = {QString::fromStdString(key),
                           QString::fromStdString(waits ? typed->second.first : value)};
  const bool isEditable = runner_.isLive() && !isUserSet(texts[EntryKey]);
  for (int column = 0; column < EntryColumns; ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      table_->setItem(row, column, item);
    }
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    flags.setFlag(Qt::ItemIsEditable, column == EntryValue && isEditable);
    item->setFlags(flags);
    item->setText(texts[column]);
    item->setForeground(theme_.color(column == EntryKey ? Role::TextSecondary
                                     : waits            ? Role::Accent
                                                        : Role::Text));
    item->setToolTip(waits        ? tr("Takes effect in the next step")
                     : isEditable ? tr("Double-click to change the value")
                                  : texts[column]);
  }
}

void BlackboardView::follow() {
  const app::BlackboardEntries* entries =
      person_ == runner_.watched() ? runner_.shownEntries() : nullptr;
  const bool isShown = person_ && entries != nullptr && !entries->empty();
  table_->setVisible(isShown);
  words_->setVisible(!isShown);
  words_->setText(isShown ? QString() : whyEmpty());
  if (table_->findChild<QLineEdit*>() != nullptr && isShown && runner_.isLive()) {
    return;  // The user is typing.
  }
  const std::int64_t step = runner_.shownFrame() == nullptr ? -1 : runner_.shownFrame()->step;
  for (auto each = typed_.begin(); each != typed_.end();) {
    each = each->second.second < step || !runner_.isLive() ? typed_.erase(each) : std::next(each);
  }
  showing_ = true;
  table_->setRowCount(isShown ? static_cast<int>(entries->size()) : 0);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [key, value] = (*entries)[static_cast<std::size_t>(row)];
    showRow(row, key, value);
  }
  showing_ = false;
}

void BlackboardView::take(int row, int column) {
  if (showing_ || column != EntryValue || !person_ || !runner_.isLive()) {
    return;
  }
  const std::string key = table_->item(row, EntryKey)->text().toStdString();
  const std::string value = table_->item(row, EntryValue)->text().toStdString();
  sim2d::Input input;
  input.kind = sim2d::InputKind::Entry;
  input.id = *person_;
  input.name = key + "=" + value;
  const std::int64_t step = runner_.shownFrame() == nullptr ? 0 : runner_.shownFrame()->step;
  typed_[key] = {value, step};
  runner_.addInput(std::move(input));
  Q_EMIT messageChanged(tr("%1 becomes %2 in the next step, as an input of the run")
                            .arg(QString::fromStdString(key), QString::fromStdString(value)));
  soon_.start();
}

}  // namespace editor
