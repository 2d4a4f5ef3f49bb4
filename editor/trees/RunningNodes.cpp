#include "editor/trees/RunningNodes.h"

#include <algorithm>

#include "editor/panels/RowDelegate.h"
#include "editor/panels/behavior/TreeOutline.h"

namespace editor {

namespace {

enum RunningColumn { NodeColumn, ValuesColumn, DurationColumn, RunningColumns };

constexpr int kNodeWidth = 240, kValuesWidth = 200;  // [px]

}  // namespace

RunningNodes::RunningNodes(const TreeGraph& graph, const TreeHistory& history,
                           SimulationRunner& runner, const Theme& theme)
    : graph_(graph),
      history_(history),
      runner_(runner),
      theme_(theme),
      table_(new QTableWidget(0, RunningColumns, this)) {
  styleTable(*table_, tr("Running nodes"));
  table_->setHorizontalHeaderLabels({tr("Node"), tr("Values"), tr("Running for")});
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->setColumnWidth(NodeColumn, kNodeWidth);
  table_->setColumnWidth(ValuesColumn, kValuesWidth);
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {table_});
  layout->addWidget(placeholder_, 1);
  connect(table_, &QTableWidget::cellClicked, this,
          [this](int row) { Q_EMIT choiceChanged(running_[static_cast<std::size_t>(row)]); });
  connect(table_, &QTableWidget::cellActivated, this,
          [this](int row) { Q_EMIT choiceChanged(running_[static_cast<std::size_t>(row)]); });
  show({}, -1);
}

void RunningNodes::setTheme(const Theme& theme) {
  theme_ = theme;
  show(std::vector<base::NodeStatus>(statuses_), step_);
}

bool RunningNodes::isRunningLeaf(int node) const {
  const std::vector<int>& children = graph_.childrenOf(node);
  return std::none_of(children.begin(), children.end(), [this](int child) {
    return statuses_[static_cast<std::size_t>(child)] == base::NodeStatus::Running;
  });
}

void RunningNodes::show(const std::vector<base::NodeStatus>& statuses, std::int64_t step) {
  statuses_ = statuses.size() == graph_.nodes().size() ? statuses : decltype(statuses_)();
  step_ = step;
  running_.clear();
  for (std::size_t k = 0; k < statuses_.size(); ++k) {
    if (statuses_[k] == base::NodeStatus::Running) {
      running_.push_back(static_cast<int>(k));
    }
  }
  table_->setVisible(!running_.empty());
  placeholder_->setVisible(running_.empty());
  placeholder_->setText(statuses_.empty()
                            ? tr("Running nodes are listed during a run: press Space.")
                            : tr("No node is running at this time."));
  table_->setRowCount(static_cast<int>(running_.size()));
  for (std::size_t row = 0; row < running_.size(); ++row) {
    fillRow(static_cast<int>(row), running_[row]);
  }
}

void RunningNodes::fillRow(int row, int node) {
  const bt::NodeSpec& spec = *graph_.node(node).node;
  const QString texts[] = {nodeTitle(spec), nodeDetail(spec), durationText(node)};
  const bool isLeaf = isRunningLeaf(node);
  for (int column = 0; column < RunningColumns; ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      table_->setItem(row, column, item);
    }
    QFont font = table_->font();
    font.setWeight(isLeaf && column == NodeColumn ? QFont::DemiBold : QFont::Normal);
    item->setFont(font);
    item->setText(texts[column]);
    item->setForeground(theme_.color(isLeaf ? Role::Text : Role::TextSecondary));
    item->setToolTip(texts[column]);
  }
}

/// "3.2 s"; empty if the start is not recorded.
QString RunningNodes::durationText(int node) const {
  const std::vector<TreeHistory::StatusInterval>& intervals = history_.intervalsOf(node);
  const TreeHistory::StatusInterval* last = nullptr;
  for (const TreeHistory::StatusInterval& each : intervals) {
    last = each.from <= step_ ? &each : last;
  }
  const RecordingPtr recording = runner_.recording();
  if (last == nullptr || last->status != base::NodeStatus::Running || recording == nullptr) {
    return {};
  }
  const double seconds = static_cast<double>(step_ - last->from) * recording->header()->dt;
  return tr("%1 s").arg(seconds, 0, 'f', 1);
}

}  // namespace editor
