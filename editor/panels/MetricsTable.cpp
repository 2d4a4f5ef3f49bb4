#include "editor/panels/MetricsTable.h"

#include <algorithm>
#include <cmath>

#include "editor/document/EditCommands.h"
#include "editor/look/CoreText.h"
#include "editor/look/TableExport.h"
#include "editor/panels/MetricDelegates.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kNowWidth = 68;
constexpr int kMetricUnitWidth = 52;
constexpr int kSparklineWidth = 96;
constexpr int kPersonWidth = 72;
constexpr int kOpenGroups = 2;  // Number of groups that are expanded initially.
constexpr int kMetricIndent = 16;
constexpr auto kNumberAlignment = static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
constexpr auto kTextAlignment = static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);

bool isTicked(const QTreeWidgetItem* row) {
  return row->checkState(MetricsTable::NameColumn) == Qt::Checked;
}

void setMeasured(QTreeWidgetItem* row, bool chosen) {
  row->setCheckState(MetricsTable::NameColumn, chosen ? Qt::Checked : Qt::Unchecked);
}

std::string keyOf(const QTreeWidgetItem& row) {
  return row.data(MetricsTable::NameColumn, kSavedKeyRole).toString().toStdString();
}

/// Rows with check boxes are metrics of the registry.
const metrics::MetricInfo& infoOf(const QTreeWidgetItem* row) {
  return metrics::standardRegistry().find(keyOf(*row))->info;
}

/// "Path length", then its formula and source.
QString descriptionOf(const metrics::MetricInfo& info) {
  QStringList lines;
  lines << coreText(info.name) << QString::fromStdString(info.formula)
        << QString::fromStdString(info.source);
  lines.removeAll(QString());
  return lines.join(QLatin1Char('\n'));
}

void setTextIfChanged(QTreeWidgetItem& row, int column, const QString& text) {
  if (row.text(column) != text) {
    row.setText(column, text);
  }
}

QVariant exactValue(const metrics::MetricResult& result) {
  return result.value.value && std::isfinite(*result.value.value)
             ? QVariant(QString::fromStdString(base::formatDouble(*result.value.value)))
             : QVariant();
}

}  // namespace

MetricsTable::MetricsTable(ScenarioDocument& document, MetricsFeed& feed, PersonMetrics& people,
                           const Theme& theme)
    : document_(document),
      feed_(feed),
      personMetrics_(people),
      sparkline_(new SparklineDelegate(feed, this)) {
  makeTop();
  tree_ = new QTreeWidget(this);  // Last, for the tab order.
  styleTree();
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 4, 0, 0}, 4);
  layout->addLayout(top_);
  nothing_ = new NoMatchesPlaceholder(*search_, *tree_, this);
  layout->addWidget(tree_, 1);
  layout->addWidget(nothing_, 1);
  build();
  connect(search_, &QLineEdit::textChanged, this, &MetricsTable::filter);
  // A click on the current row, or on its check box, is a choice, too.
  connect(tree_, &QTreeWidget::itemClicked, this, [this] { Q_EMIT chosen(currentKey()); });
  connect(tree_, &QTreeWidget::itemChanged, this, [this] {
    Q_EMIT chosen(currentKey());
    storeSelection();
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
    if (!isSelecting_) {
      Q_EMIT chosen(currentKey());
    }
  });
  connect(&document_, &ScenarioDocument::pathChanged, this, [this] {
    feed_.setSelection(std::nullopt);  // Uses that of the new file.
    loadSelection();
  });
  connect(&personMetrics_, &PersonMetrics::updated, this, &MetricsTable::showValues);
  setTheme(theme);
  loadSelection();
}

void MetricsTable::makeTop() {
  onlyMeasured_ = linkButton(tr("Measured"), tr("Show only the metrics that are measured"), this,
                             [this] { filter(); });
  onlyMeasured_->setCheckable(true);
  auto* all =
      linkButton(tr("All"), tr("Measure all listed metrics"), this, [this] { chooseAll(true); });
  auto* none =
      linkButton(tr("None"), tr("Measure no listed metric"), this, [this] { chooseAll(false); });
  auto* saving =
      linkButton(tr("Save choice"), tr("Save the choice to the metrics file of the scenario"), this,
                 [this] { Q_EMIT saved(save()); });
  search_->setMinimumWidth(120);
  top_ = configuredLayout(new QHBoxLayout, {12, 0, 12, 0}, 12,
                          {search_, count_, onlyMeasured_, all, none, saving});
  top_->setStretchFactor(search_, 1);
}

void MetricsTable::styleTree() {
  styleList(*tree_, tr("Metrics"));
  makeTableSavable(*tree_, tr("Metrics"));
  tree_->setColumnCount(FirstPersonColumn);
  tree_->setHeaderLabels({tr("Metric"), tr("Since start"), tr("Unit"), tr("Over time")});
  tree_->headerItem()->setToolTip(NowColumn,
                                  tr("The value from the start of the run to the shown time"));
  tree_->headerItem()->setToolTip(
      SparklineColumn, tr("The curve of the values per step, or of the values since the start if "
                          "the metric has none per step"));
  tree_->headerItem()->setTextAlignment(NowColumn, kNumberAlignment);
  tree_->setWordWrap(true);
  tree_->setIndentation(kMetricIndent);
  tree_->setItemDelegate(new MetricNameDelegate(tree_));
  tree_->setItemDelegateForColumn(SparklineColumn, sparkline_);
  QHeaderView* header = tree_->header();
  header->setStretchLastSection(false);
  header->setHighlightSections(false);
  header->setFixedHeight(kListRowHeight);
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  for (const auto& [column, width] :
       {std::pair(NowColumn, kNowWidth), std::pair(UnitColumn, kMetricUnitWidth),
        std::pair(SparklineColumn, kSparklineWidth)}) {
    header->resizeSection(column, std::max(width, header->sectionSizeHint(column)));
  }
  connect(header, &QHeaderView::sectionResized, tree_, [this](int column) {
    if (column == NameColumn) {
      tree_->doItemsLayout();
    }
  });
}

void MetricsTable::setTheme(const Theme& theme) {
  search_->setTheme(theme);
  sparkline_->setTheme(theme);
  pale_ = theme.color(Role::TextSecondary);
  const QSignalBlocker quiet(tree_);
  for (QTreeWidgetItemIterator each(tree_); *each != nullptr; ++each) {
    (*each)->setForeground(UnitColumn, pale_);
  }
  showCounts();
  showValues();
}

void MetricsTable::build() {
  const QSignalBlocker quiet(tree_);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  for (int i = 0; i < metrics::kCategories; ++i) {
    const auto category = static_cast<metrics::Category>(i);
    auto* group =
        new QTreeWidgetItem(tree_, QStringList(coreText(metrics::categoryName(category))));
    group->setFont(NameColumn, bold);
    group->setTextAlignment(NowColumn, kNumberAlignment);
    group->setExpanded(i < kOpenGroups);
    groups_.push_back(group);
  }
  for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
    rowFor(entry.info);
  }
}

QTreeWidgetItem* MetricsTable::addRow(QTreeWidgetItem* parent, const metrics::MetricInfo& info) {
  auto* row = new QTreeWidgetItem(parent);
  row->setText(NameColumn, coreText(info.name));
  row->setText(UnitColumn, QString::fromStdString(info.unit));
  row->setTextAlignment(NowColumn, kNumberAlignment);
  row->setTextAlignment(UnitColumn, kTextAlignment);
  row->setData(NameColumn, kSavedKeyRole, QString::fromStdString(info.key));
  row->setToolTip(NameColumn, descriptionOf(info));
  rowsByKey_[info.key] = row;
  return row;
}

/// The row of a metric, which is created if it is new: below the metric that it is a part of, else
/// in its group.
QTreeWidgetItem* MetricsTable::rowFor(const metrics::MetricInfo& info) {
  if (const auto found = rowsByKey_.find(info.key); found != rowsByKey_.end()) {
    return found->second;
  }
  const auto whole = info.partOf.empty() ? rowsByKey_.end() : rowsByKey_.find(info.partOf);
  if (whole != rowsByKey_.end()) {
    return addRow(whole->second, info);
  }
  QTreeWidgetItem* row = addRow(groups_[static_cast<std::size_t>(info.category)], info);
  if (metrics::standardRegistry().find(info.key) != nullptr) {
    row->setCheckState(NameColumn, Qt::Unchecked);
    rows_.push_back(row);
  } else {
    ownInfo_[info.key] = info;
    row->setForeground(UnitColumn, pale_);
  }
  return row;
}

/// Removes formulas of another scenario.
void MetricsTable::dropOwnRows() {
  for (auto own = ownInfo_.begin(); own != ownInfo_.end();) {
    const bool isMeasured =
        metrics::findResult(feed_.shown(), own->first) != nullptr || feed_.shown().empty();
    if (isMeasured) {
      ++own;
      continue;
    }
    delete rowsByKey_[own->first];
    rowsByKey_.erase(own->first);
    own = ownInfo_.erase(own);
  }
}

void MetricsTable::setPeople(std::vector<MeasuredPerson> people) {
  if (people == people_) {
    return;
  }
  people_ = std::move(people);
  const QSignalBlocker quiet(tree_);
  const auto count = static_cast<int>(people_.size());
  tree_->setColumnCount(FirstPersonColumn + count);
  if (QTreeWidgetItem* current = tree_->currentItem()) {
    tree_->setCurrentItem(current);  // Selects the new columns, too.
  }
  for (int k = 0; k < count; ++k) {
    const int column = FirstPersonColumn + k;
    const QString& name = people_[static_cast<std::size_t>(k)].name;
    const QFontMetrics metrics(tree_->header()->font());
    QTreeWidgetItem* head = tree_->headerItem();
    head->setText(column, metrics.elidedText(name, Qt::ElideMiddle, kPersonWidth - 16));
    head->setToolTip(column, tr("As if %1 were the only person").arg(name));
    head->setTextAlignment(column, kNumberAlignment);
    tree_->header()->setSectionResizeMode(column, QHeaderView::Fixed);
    tree_->header()->resizeSection(column, kPersonWidth);
    for (const auto& [key, row] : rowsByKey_) {
      row->setTextAlignment(column, kNumberAlignment);
    }
  }
  std::vector<int> ids;
  ids.reserve(people_.size());
  for (const MeasuredPerson& person : people_) {
    ids.push_back(person.id);
  }
  personMetrics_.setPeople(std::move(ids));
  showValues();
}

void MetricsTable::showValues() {
  const QSignalBlocker quiet(tree_);
  dropOwnRows();
  for (const metrics::MetricResult& result : feed_.shown()) {
    QTreeWidgetItem& row = *rowFor(result.info);
    fillRow(row, &result);
    fillPeople(row, result.info);
  }
  fillEmptyRows();
  tree_->viewport()->update();
}

/// Metrics that are not measured have no values.
void MetricsTable::fillEmptyRows() {
  for (const auto& [key, row] : rowsByKey_) {
    if (metrics::findResult(feed_.shown(), key) == nullptr) {
      fillRow(*row, nullptr);
      for (int column = FirstPersonColumn; column < tree_->columnCount(); ++column) {
        setTextIfChanged(*row, column, {});
      }
    }
  }
}

void MetricsTable::fillRow(QTreeWidgetItem& row, const metrics::MetricResult* result) {
  const bool isKnown = result != nullptr && result->value.value.has_value();
  setTextIfChanged(row, NowColumn, result == nullptr ? QString() : metricText(*result));
  row.setData(NowColumn, kExactValueRole, isKnown ? exactValue(*result) : QVariant());
  row.setData(NowColumn, Qt::ForegroundRole, isKnown ? QVariant() : QVariant(pale_));
  const QString why = result == nullptr ? QString() : QString::fromStdString(result->value.why);
  row.setToolTip(NowColumn, why.isEmpty() ? QString() : tr("No value: %1").arg(why));
  const bool isOfRobot =
      result != nullptr && !isKnown && result->info.needs.robot && feed_.robots().empty();
  setTextIfChanged(row, SparklineColumn, isOfRobot ? tr("needs a robot") : QString());
  row.setData(SparklineColumn, Qt::ForegroundRole, pale_);
}

void MetricsTable::fillPeople(QTreeWidgetItem& row, const metrics::MetricInfo& info) {
  for (std::size_t k = 0; k < people_.size(); ++k) {
    const int column = FirstPersonColumn + static_cast<int>(k);
    const metrics::MetricResult* result = personMetrics_.find(people_[k].id, info.key);
    setTextIfChanged(row, column, result == nullptr ? QString() : metricText(*result));
    row.setData(column, kExactValueRole, result == nullptr ? QVariant() : exactValue(*result));
    row.setToolTip(column, result == nullptr || result->value.why.empty()
                               ? QString()
                               : tr("No value: %1").arg(QString::fromStdString(result->value.why)));
  }
}

std::string MetricsTable::currentKey() const {
  const QTreeWidgetItem* row = tree_->currentItem();
  return row == nullptr ? std::string() : keyOf(*row);
}

void MetricsTable::setCurrentKey(const std::string& key) {
  const QScopedValueRollback<bool> selecting(isSelecting_, true);
  const auto found = rowsByKey_.find(key);
  tree_->setCurrentItem(found == rowsByKey_.end() || !isVisible(key) ? nullptr : found->second);
}

bool MetricsTable::isVisible(const std::string& key) const {
  const auto found = rowsByKey_.find(key);
  return found != rowsByKey_.end() && !found->second->isHidden() &&
         (found->second->parent() == nullptr || !found->second->parent()->isHidden());
}

std::string MetricsTable::firstVisible() const {
  for (QTreeWidgetItemIterator each(tree_, QTreeWidgetItemIterator::NotHidden); *each != nullptr;
       ++each) {
    if ((*each)->parent() != nullptr) {
      return keyOf(**each);
    }
  }
  return {};
}

void MetricsTable::loadSelection() {
  const QSignalBlocker quiet(tree_);
  const metrics::Selection selection = feed_.selection();
  for (QTreeWidgetItem* row : rows_) {
    setMeasured(row, selection.selects(infoOf(row)));
  }
  showCounts();
}

metrics::Selection MetricsTable::selection() const {
  metrics::Selection selection = feed_.selection();
  metrics::Selection::Keys keys;
  bool all = true;
  for (const QTreeWidgetItem* row : rows_) {
    const metrics::MetricInfo& info = infoOf(row);
    const bool theirs = info.hunav > 0;
    all = all && isTicked(row);
    if (theirs && !isTicked(row)) {
      keys.off.insert(info.key);
    } else if (!theirs && isTicked(row)) {
      keys.on.insert(info.key);
    }
  }
  selection.keys = all ? std::nullopt : std::optional(keys);
  return selection;
}

void MetricsTable::storeSelection() {
  showCounts();
  feed_.setSelection(selection());
}

void MetricsTable::chooseAll(bool chosen) {
  const QSignalBlocker quiet(tree_);
  for (QTreeWidgetItem* row : rows_) {
    if (!row->isHidden()) {
      setMeasured(row, chosen);
    }
  }
  storeSelection();
}

/// Shows the row if it or one of its parts matches; returns whether it is shown.
bool MetricsTable::filterRow(QTreeWidgetItem& row, const QString& text) {
  const bool isMatch = row.text(NameColumn).contains(text, Qt::CaseInsensitive) ||
                       QString::fromStdString(keyOf(row)).contains(text, Qt::CaseInsensitive);
  bool isPartShown = false;
  for (int k = 0; k < row.childCount(); ++k) {
    isPartShown = filterRow(*row.child(k), isMatch ? QString() : text) || isPartShown;
  }
  const bool hasCheckBox = row.data(NameColumn, Qt::CheckStateRole).isValid();
  const bool isMeasured = !onlyMeasured_->isChecked() || !hasCheckBox || isTicked(&row);
  const bool isShown = (isMatch || isPartShown) && isMeasured;
  row.setHidden(!isShown);
  return isShown;
}

void MetricsTable::filter() {
  const QString text = search_->text().trimmed();
  bool isAny = false;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    QTreeWidgetItem& group = *groups_[i];
    bool isShown = false;
    for (int row = 0; row < group.childCount(); ++row) {
      isShown = filterRow(*group.child(row), text) || isShown;
    }
    group.setHidden(!isShown);
    if (!text.isEmpty()) {
      group.setExpanded(isShown);
    }
    isAny = isAny || isShown;
  }
  nothing_->setMatchFound(isAny);
  Q_EMIT filtered();
}

void MetricsTable::showCounts() {
  const QSignalBlocker quiet(tree_);
  std::map<QTreeWidgetItem*, std::pair<int, int>> counts;  // By group: chosen, all.
  for (QTreeWidgetItem* row : rows_) {
    row->setData(NameColumn, Qt::ForegroundRole, isTicked(row) ? QVariant() : QVariant(pale_));
    auto& [chosen, all] = counts[row->parent()];
    chosen += isTicked(row) ? 1 : 0;
    ++all;
  }
  int chosen = 0;
  for (const auto& [group, count] : counts) {
    group->setText(NowColumn, QStringLiteral("%1 / %2").arg(count.first).arg(count.second));
    chosen += count.first;
  }
  const std::size_t total = rows_.size();
  count_->setText(tr("%1 of %2").arg(chosen).arg(total));
  count_->setToolTip(tr("%1 of %2 metrics are measured").arg(chosen).arg(total));
}

base::Diagnostics MetricsTable::save() {
  if (document_.path().isEmpty()) {
    return {base::error("document.save-first")};
  }
  const QFileInfo scenario(document_.path());
  const std::optional<std::string>& named = document_.scenario().desktop.metrics.file;
  const QString name = named ? QString::fromStdString(*named)
                             : scenario.completeBaseName() + QStringLiteral("_metrics.yaml");
  const std::string path = scenario.absoluteDir().filePath(name).toStdString();
  metrics::MetricsFile file;
  if (QFileInfo::exists(QString::fromStdString(path))) {
    const base::Result<metrics::MetricsFile> before = metrics::readMetricsFile(path);
    if (!before) {
      return before.diagnostics();
    }
    file = *before;
  }
  file.selection.keys = selection().keys;
  base::Diagnostics problems = base::writeFileAtomically(path, metrics::writeMetricsFile(file));
  if (!base::hasErrors(problems) && !named) {
    pushChange<ScenarioSettings>(
        document_, kSettingsId, tr("Set metrics file"),
        [&](ScenarioSettings& settings) { settings.desktop.metrics.file = name.toStdString(); });
  }
  return problems;
}

}  // namespace editor
