#include "editor/panels/MetricsChoicePanel.h"

#include <algorithm>

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "editor/document/EditCommands.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kKeyRole = Qt::UserRole;
constexpr int kUnitWidth = 56;
constexpr int kIndent = 16;

/// Rows as tall as their name needs: one line, or more when the panel is narrow.
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
  /// For the letters of a name [px].
  int room(const QModelIndex& index) const {
    QStyleOptionViewItem row;
    initStyleOption(&row, index);
    row.widget = &tree_;
    row.text = QString(200, QLatin1Char('m'));  // as much as there is
    row.rect = QRect(0, 0, tree_.columnWidth(0) - 2 * kIndent, kListRowHeight);
    const QStyle& style = *tree_.style();
    const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &row, &tree_) + 1;
    return style.subElementRect(QStyle::SE_ItemViewItemText, &row, &tree_).width() - 2 * margin;
  }
  const QTreeWidget& tree_;
};

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
  tree.header()->resizeSection(1, kUnitWidth);
  QObject::connect(tree.header(), &QHeaderView::sectionResized, &tree, [&tree](int column) {
    if (column == 0) {
      tree.doItemsLayout();
    }
  });
}

}  // namespace

MetricsChoicePanel::MetricsChoicePanel(ScenarioDocument& document, MetricsFeed& feed,
                                       const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      feed_(feed),
      search_(new QLineEdit(this)),
      count_(secondaryLabel({}, this)),
      all_(linkButton(tr("All"), this)),
      none_(linkButton(tr("None"), this)),
      save_(linkButton(tr("Save"), this)),
      tree_(new QTreeWidget(this)) {
  search_->setPlaceholderText(tr("Find a metric"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Find a metric"));
  searchMark_ = search_->addAction(QIcon(), QLineEdit::LeadingPosition);
  styleChoices(*tree_);
  all_->setToolTip(tr("Measure all that the list shows"));
  none_->setToolTip(tr("Measure nothing of what the list shows"));
  save_->setToolTip(tr("Write the choice into the metrics file of the scenario"));
  auto* links = new QHBoxLayout;
  links->setContentsMargins(12, 0, 12, 0);
  links->setSpacing(12);
  links->addWidget(count_, 1);
  links->addWidget(all_);
  links->addWidget(none_);
  links->addWidget(save_);
  auto* field = new QHBoxLayout;
  field->setContentsMargins(12, 0, 12, 0);
  field->addWidget(search_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 4);
  layout->setSpacing(4);
  layout->addLayout(field);
  layout->addLayout(links);
  layout->addWidget(tree_, 1);
  build();
  connect(search_, &QLineEdit::textChanged, this, &MetricsChoicePanel::filter);
  connect(all_, &QToolButton::clicked, this, [this] { chooseAll(true); });
  connect(none_, &QToolButton::clicked, this, [this] { chooseAll(false); });
  connect(save_, &QToolButton::clicked, this, [this] { Q_EMIT saved(save()); });
  connect(tree_, &QTreeWidget::itemChanged, this, &MetricsChoicePanel::giveSelection);
  connect(&document_, &ScenarioDocument::pathChanged, this, [this] {
    feed_.setSelection(std::nullopt);  // that of the new file
    takeSelection();
  });
  setTheme(theme);
  takeSelection();
}

void MetricsChoicePanel::setTheme(const Theme& theme) {
  searchMark_->setIcon(tintedIcon(QStringLiteral("search"), theme.color(Role::TextSecondary)));
  const QSignalBlocker quiet(tree_);
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    tree_->topLevelItem(i)->setForeground(1, theme.color(Role::TextSecondary));
  }
  for (QTreeWidgetItem* row : rows()) {
    row->setForeground(1, theme.color(Role::TextSecondary));
  }
}

void MetricsChoicePanel::build() {
  const QSignalBlocker quiet(tree_);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  for (int i = 0; i < metrics::kCategories; ++i) {
    const auto category = static_cast<metrics::Category>(i);
    auto* group = new QTreeWidgetItem(tree_);
    group->setText(0, QString::fromLatin1(metrics::categoryName(category)));
    group->setFont(0, bold);
    group->setTextAlignment(1, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
    group->setExpanded(i < 2);
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      if (entry.info.category != category || !entry.info.partOf.empty()) {
        continue;
      }
      auto* row = new QTreeWidgetItem(group);
      row->setText(0, QString::fromStdString(entry.info.name));
      row->setText(1, QString::fromStdString(entry.info.unit));
      row->setTextAlignment(1, static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
      row->setData(0, kKeyRole, QString::fromStdString(entry.info.key));
      row->setToolTip(0, QStringLiteral("%1\n%2\n%3")
                             .arg(QString::fromStdString(entry.info.name),
                                  QString::fromStdString(entry.info.formula),
                                  QString::fromStdString(entry.info.source)));
      row->setCheckState(0, Qt::Unchecked);
    }
  }
}

std::vector<QTreeWidgetItem*> MetricsChoicePanel::rows() const {
  std::vector<QTreeWidgetItem*> result;
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = tree_->topLevelItem(i);
    for (int row = 0; row < group->childCount(); ++row) {
      result.push_back(group->child(row));
    }
  }
  return result;
}

void MetricsChoicePanel::takeSelection() {
  const QSignalBlocker quiet(tree_);
  const metrics::Selection selection = feed_.selection();
  for (QTreeWidgetItem* row : rows()) {
    const std::string key = row->data(0, kKeyRole).toString().toStdString();
    const metrics::MetricEntry* entry = metrics::standardRegistry().find(key);
    row->setCheckState(
        0, entry != nullptr && selection.selects(entry->info) ? Qt::Checked : Qt::Unchecked);
  }
  showCounts();
}

metrics::Selection MetricsChoicePanel::selection() const {
  metrics::Selection selection = feed_.selection();
  metrics::Selection::Keys keys;
  bool all = true;
  for (const QTreeWidgetItem* row : rows()) {
    const std::string key = row->data(0, kKeyRole).toString().toStdString();
    const bool on = row->checkState(0) == Qt::Checked;
    const bool theirs = metrics::standardRegistry().find(key)->info.hunav > 0;
    all = all && on;
    if (theirs && !on) {
      keys.off.insert(key);
    } else if (!theirs && on) {
      keys.on.insert(key);
    }
  }
  selection.keys = all ? std::nullopt : std::optional(keys);
  return selection;
}

void MetricsChoicePanel::giveSelection() {
  showCounts();
  feed_.setSelection(selection());
}

void MetricsChoicePanel::setChosen(const QString& key, bool chosen) {
  for (QTreeWidgetItem* row : rows()) {
    if (row->data(0, kKeyRole).toString() == key) {
      row->setCheckState(0, chosen ? Qt::Checked : Qt::Unchecked);
    }
  }
}

void MetricsChoicePanel::chooseAll(bool chosen) {
  const QSignalBlocker quiet(tree_);
  for (QTreeWidgetItem* row : rows()) {
    if (!row->isHidden()) {
      row->setCheckState(0, chosen ? Qt::Checked : Qt::Unchecked);
    }
  }
  giveSelection();
}

void MetricsChoicePanel::filter(const QString& text) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = tree_->topLevelItem(i);
    bool any = false;
    for (int row = 0; row < group->childCount(); ++row) {
      QTreeWidgetItem* item = group->child(row);
      const bool fits = item->text(0).contains(text, Qt::CaseInsensitive) ||
                        item->data(0, kKeyRole).toString().contains(text, Qt::CaseInsensitive);
      item->setHidden(!fits);
      any = any || fits;
    }
    group->setHidden(!any);
    group->setExpanded(text.isEmpty() ? i < 2 : any);
  }
}

void MetricsChoicePanel::showCounts() {
  const QSignalBlocker quiet(tree_);
  int chosen = 0;
  int total = 0;
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = tree_->topLevelItem(i);
    int here = 0;
    for (int row = 0; row < group->childCount(); ++row) {
      here += group->child(row)->checkState(0) == Qt::Checked ? 1 : 0;
    }
    group->setText(1, QStringLiteral("%1 / %2").arg(here).arg(group->childCount()));
    chosen += here;
    total += group->childCount();
  }
  count_->setText(tr("%1 of %2").arg(chosen).arg(total));
  count_->setToolTip(tr("%1 of %2 metrics are chosen").arg(chosen).arg(total));
}

base::Diagnostics MetricsChoicePanel::save() {
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
        document_, kSettingsId, tr("Name the metrics file"),
        [&](ScenarioSettings& settings) { settings.desktop.metrics.file = name.toStdString(); });
  }
  return problems;
}

void addMetricsChoicePanel(PanelRegistry& to) {
  to.add({20, QObject::tr("Measure"), Qt::LeftDockWidgetArea, false}, [](PanelContext& context) {
    auto* panel = new MetricsChoicePanel(context.document, context.feed, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &MetricsChoicePanel::setTheme);
    QObject::connect(panel, &MetricsChoicePanel::saved, &context, &PanelContext::problemsFound);
    return panel;
  });
}

}  // namespace editor
