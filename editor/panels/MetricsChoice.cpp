#include <algorithm>

#include "editor/document/EditCommands.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kKeyRole = Qt::UserRole;
constexpr int kUnitColumnWidth = 56;
constexpr int kIndent = 16;

/// Draws rows as tall as their wrapped name.
class NameDelegate : public QStyledItemDelegate {
 public:
  explicit NameDelegate(QTreeWidget* tree) : QStyledItemDelegate(tree), tree_(*tree) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    int height = kListRowHeight;
    if (index.column() == 0 && index.parent().isValid()) {
      const QRect letters = option.fontMetrics.boundingRect(
          QRect(0, 0, room(index), 1000), Qt::TextWordWrap, index.data(Qt::DisplayRole).toString());
      height = std::max(height, letters.height() + kListRowPadding);
    }
    return {QStyledItemDelegate::sizeHint(option, index).width(), height};
  }

 private:
  /// Width available for a name [px].
  int room(const QModelIndex& index) const {
    QStyleOptionViewItem row;
    initStyleOption(&row, index);
    row.widget = &tree_;
    row.text = QString(200, QLatin1Char('m'));  // Long enough to fill the available width.
    row.rect = QRect(0, 0, tree_.columnWidth(0) - 2 * kIndent, kListRowHeight);
    const QStyle& style = *tree_.style();
    const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &row, &tree_) + 1;
    return style.subElementRect(QStyle::SE_ItemViewItemText, &row, &tree_).width() - 2 * margin;
  }
  const QTreeWidget& tree_;
};

bool isChosen(const QTreeWidgetItem* row) {
  return row->checkState(0) == Qt::Checked;
}

void choose(QTreeWidgetItem* row, bool chosen) {
  row->setCheckState(0, chosen ? Qt::Checked : Qt::Unchecked);
}

/// The tree contains only metrics of the registry.
const metrics::MetricInfo& infoOf(const QTreeWidgetItem* row) {
  const std::string key = row->data(0, kKeyRole).toString().toStdString();
  return metrics::standardRegistry().find(key)->info;
}

void styleChoices(QTreeWidget& tree) {
  styleList(tree, QObject::tr("Metrics to measure"));
  tree.setColumnCount(2);
  tree.setHeaderHidden(true);
  tree.setWordWrap(true);
  tree.setIndentation(kIndent);
  tree.setItemDelegate(new NameDelegate(&tree));
  tree.header()->setStretchLastSection(false);
  tree.header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree.header()->setSectionResizeMode(1, QHeaderView::Fixed);
  tree.header()->resizeSection(1, kUnitColumnWidth);
  QObject::connect(tree.header(), &QHeaderView::sectionResized, &tree, [&tree](int column) {
    if (column == 0) {
      tree.doItemsLayout();
    }
  });
}

}  // namespace

MetricsChoice::MetricsChoice(ScenarioDocument& document, MetricsFeed& feed, const Theme& theme)
    : document_(document), feed_(feed) {
  auto* all =
      linkButton(tr("All"), tr("Measure all listed metrics"), this, [this] { chooseAll(true); });
  auto* none =
      linkButton(tr("None"), tr("Measure no listed metric"), this, [this] { chooseAll(false); });
  auto* saving = linkButton(tr("Save"), tr("Save the choice to the metrics file of the scenario"),
                            this, [this] { Q_EMIT saved(save()); });
  auto* links = configuredLayout(new QHBoxLayout, {12, 0, 12, 0}, 12, {count_, all, none, saving});
  links->setStretchFactor(count_, 1);
  tree_ = new QTreeWidget(this);  // Last, for the tab order.
  styleChoices(*tree_);
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 4}, 4);
  layout->addLayout(configuredLayout(new QHBoxLayout, {12, 0, 12, 0}, 0, {search_}));
  layout->addLayout(links);
  nothing_ = new NoMatchesPlaceholder(*search_, *tree_, this);
  layout->addWidget(tree_, 1);
  layout->addWidget(nothing_, 1);
  build();
  connect(search_, &QLineEdit::textChanged, this, &MetricsChoice::filter);
  connect(tree_, &QTreeWidget::itemChanged, this, &MetricsChoice::storeSelection);
  connect(&document_, &ScenarioDocument::pathChanged, this, [this] {
    feed_.setSelection(std::nullopt);  // Uses that of the new file.
    loadSelection();
  });
  setTheme(theme);
  loadSelection();
}

void MetricsChoice::setTheme(const Theme& theme) {
  search_->setTheme(theme);
  const QSignalBlocker quiet(tree_);
  for (QTreeWidgetItemIterator each(tree_); *each != nullptr; ++each) {
    (*each)->setForeground(1, theme.color(Role::TextSecondary));
  }
}

void MetricsChoice::build() {
  const QSignalBlocker quiet(tree_);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  for (int i = 0; i < metrics::kCategories; ++i) {
    const auto category = static_cast<metrics::Category>(i);
    const QString title = QString::fromLatin1(metrics::categoryName(category));
    auto* group = new QTreeWidgetItem(tree_, QStringList(title));
    group->setFont(0, bold);
    group->setTextAlignment(1, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
    group->setExpanded(i < 2);
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      if (entry.info.category != category || !entry.info.partOf.empty()) {
        continue;
      }
      const QString name = QString::fromStdString(entry.info.name);
      auto* row = new QTreeWidgetItem(group, {name, QString::fromStdString(entry.info.unit)});
      row->setTextAlignment(1, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
      row->setData(0, kKeyRole, QString::fromStdString(entry.info.key));
      row->setToolTip(0, QStringLiteral("%1\n%2\n%3")
                             .arg(name, QString::fromStdString(entry.info.formula),
                                  QString::fromStdString(entry.info.source)));
      row->setCheckState(0, Qt::Unchecked);
      rows_.push_back(row);
    }
  }
}

void MetricsChoice::loadSelection() {
  const QSignalBlocker quiet(tree_);
  const metrics::Selection selection = feed_.selection();
  for (QTreeWidgetItem* row : rows_) {
    choose(row, selection.selects(infoOf(row)));
  }
  showCounts();
}

metrics::Selection MetricsChoice::selection() const {
  metrics::Selection selection = feed_.selection();
  metrics::Selection::Keys keys;
  bool all = true;
  for (const QTreeWidgetItem* row : rows_) {
    const metrics::MetricInfo& info = infoOf(row);
    const bool theirs = info.hunav > 0;
    all = all && isChosen(row);
    if (theirs && !isChosen(row)) {
      keys.off.insert(info.key);
    } else if (!theirs && isChosen(row)) {
      keys.on.insert(info.key);
    }
  }
  selection.keys = all ? std::nullopt : std::optional(keys);
  return selection;
}

void MetricsChoice::storeSelection() {
  showCounts();
  feed_.setSelection(selection());
}

void MetricsChoice::chooseAll(bool chosen) {
  const QSignalBlocker quiet(tree_);
  for (QTreeWidgetItem* row : rows_) {
    if (!row->isHidden()) {
      choose(row, chosen);
    }
  }
  storeSelection();
}

void MetricsChoice::filter(const QString& text) {
  std::map<QTreeWidgetItem*, bool> shown;  // By group.
  for (QTreeWidgetItem* row : rows_) {
    const bool fits = row->text(0).contains(text, Qt::CaseInsensitive) ||
                      row->data(0, kKeyRole).toString().contains(text, Qt::CaseInsensitive);
    row->setHidden(!fits);
    shown[row->parent()] |= fits;
  }
  for (const auto& [group, any] : shown) {
    group->setHidden(!any);
    group->setExpanded(text.isEmpty() ? tree_->indexOfTopLevelItem(group) < 2 : any);
  }
  nothing_->setMatchFound(
      std::any_of(shown.begin(), shown.end(), [](const auto& each) { return each.second; }));
}

void MetricsChoice::showCounts() {
  const QSignalBlocker quiet(tree_);
  std::map<QTreeWidgetItem*, int> counts;  // By group.
  for (const QTreeWidgetItem* row : rows_) {
    counts[row->parent()] += isChosen(row) ? 1 : 0;
  }
  int chosen = 0;
  for (const auto& [group, here] : counts) {
    group->setText(1, QStringLiteral("%1 / %2").arg(here).arg(group->childCount()));
    chosen += here;
  }
  const std::size_t total = rows_.size();
  count_->setText(tr("%1 of %2").arg(chosen).arg(total));
  count_->setToolTip(tr("%1 of %2 metrics are selected").arg(chosen).arg(total));
  Q_EMIT countChanged(count_->text());
}

base::Diagnostics MetricsChoice::save() {
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
