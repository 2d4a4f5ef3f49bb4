
#include "bt/human/BehaviorBlocks.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/RowDelegate.h"
#include "editor/trees/TreeCanvas.h"
#include "editor/trees/TreeEdits.h"
#include "editor/trees/TreeViews.h"

namespace editor {

namespace {

constexpr int kXmlRole = Qt::UserRole;
constexpr int kHelpRole = Qt::UserRole + 1;
constexpr int kHelpHeight = 96;
constexpr int kPaletteWidth = 220;

QString qtText(const std::string& text) {
  return QString::fromStdString(text);
}

/// A list whose rows are dragged as XML.
class NodeList : public QTreeWidget {
 protected:
  QStringList mimeTypes() const override { return {QString::fromLatin1(TreeCanvas::kMime)}; }
  QMimeData* mimeData(const QList<QTreeWidgetItem*> rows) const override {
    const QString xml = rows.isEmpty() ? QString() : NodePalette::xmlOf(rows.front());
    if (xml.isEmpty()) {
      return nullptr;
    }
    auto* dragged = new QMimeData;
    dragged->setData(QString::fromLatin1(TreeCanvas::kMime), xml.toUtf8());
    dragged->setText(xml);
    return dragged;
  }
};

class PaletteDelegate : public RowDelegate {
 public:
  using RowDelegate::RowDelegate;

 protected:
  bool isHeading(const QModelIndex& index) const override { return !index.parent().isValid(); }
};

/// The ports of a node, one per line.
QString portsText(const bt::NodeManifest& manifest) {
  QStringList lines;
  for (const bt::PortSpec& port : manifest.ports) {
    QString line = QStringLiteral("%1 (%2").arg(
        qtText(port.key), QString::fromLatin1(bt::portTypeName(port.portType)));
    line += port.unit.empty() ? QString() : QStringLiteral(", ") + qtText(port.unit);
    line += port.fallbackText() == nullptr || port.fallbackText()->empty()
                ? QString()
                : QObject::tr(", default %1").arg(qtText(*port.fallbackText()));
    lines << line + QStringLiteral("): ") + qtText(port.help);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

NodePalette::NodePalette(const Theme& theme) : theme_(theme), list_(new NodeList) {
  search_->setToolTip(tr("Search by name or description"));
  styleList(*list_, tr("Nodes"));
  list_->header()->hide();
  list_->setIndentation(14);
  list_->setUniformRowHeights(true);
  list_->setItemDelegate(new PaletteDelegate(list_));
  list_->setDragEnabled(true);
  list_->setDragDropMode(QAbstractItemView::DragOnly);
  nothing_ = new NoMatchesPlaceholder(*search_, *list_, this);
  help_->setWordWrap(true);
  help_->setTextFormat(Qt::PlainText);
  help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  help_->setFixedHeight(kHelpHeight);
  help_->setContentsMargins(12, 6, 12, 6);
  help_->setForegroundRole(QPalette::PlaceholderText);
  auto* top = new QWidget(this);
  configuredLayout(new QVBoxLayout(top), {12, 8, 12, 6}, 0, {search_});
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {top, nothing_});
  layout->addWidget(list_, 1);
  layout->addWidget(dividerLine(this));
  layout->addWidget(help_);
  setMinimumWidth(kPaletteWidth - 60);
  addRows();
  connect(search_, &QLineEdit::textChanged, this, &NodePalette::filter);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (const QTreeWidgetItem* row = bestMatch()) {
      Q_EMIT addRequested(xmlOf(row));
    }
  });
  connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
    if (!xmlOf(row).isEmpty()) {
      Q_EMIT addRequested(xmlOf(row));
    }
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, &NodePalette::explain);
  setTheme(theme);
  explain();
}

void NodePalette::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  help_->setVisible(height() > 3 * kHelpHeight);
}

QString NodePalette::xmlOf(const QTreeWidgetItem* row) {
  return row->data(0, kXmlRole).toString();
}

QTreeWidgetItem* NodePalette::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(list_, {title});
  group->setFlags(Qt::ItemIsEnabled);
  return group;
}

void NodePalette::addNode(QTreeWidgetItem& group, const bt::NodeSpec& node, const QString& title,
                          const QString& help) {
  auto* row = new QTreeWidgetItem(&group, {title});
  row->setData(0, kXmlRole, qtText(nodeText(node)));
  row->setData(0, kHelpRole, help);
  row->setToolTip(0, help);
  row->setIcon(0, drawnIcon(16, [&](QPainter& painter) {
                 paintNodeSign(painter, node, {}, theme_.color(Role::TextSecondary));
               }));
  group.setData(0, kSideTextRole, QString::number(group.childCount()));
}

void NodePalette::addRows() {
  const std::pair<bt::NodeKind, QString> kinds[] = {{bt::NodeKind::Control, tr("Control")},
                                                    {bt::NodeKind::Decorator, tr("Decorators")},
                                                    {bt::NodeKind::Condition, tr("Conditions")},
                                                    {bt::NodeKind::Action, tr("Actions")}};
  for (const auto& [kind, title] : kinds) {
    QTreeWidgetItem* group = addGroup(title);
    for (const bt::NodeManifest& manifest : treeCatalogue().all()) {
      if (manifest.kind == kind) {
        const QString ports = portsText(manifest);
        addNode(*group, defaultNode(manifest.id), qtText(manifest.id),
                qtText(manifest.description) +
                    (ports.isEmpty() ? QString() : QLatin1Char('\n') + ports));
      }
    }
    group->sortChildren(0, Qt::AscendingOrder);
    group->setExpanded(true);
  }
  trees_ = addGroup(tr("Subtrees"));
  QTreeWidgetItem* templates = addGroup(tr("Templates"));
  for (const bt::BlockType& kind : bt::blockTypes()) {
    bt::Block block;
    block.id = kind.id;
    addNode(*templates, bt::blockToNode(block), qtText(kind.title), qtText(kind.description));
  }
}

void NodePalette::showTrees(const QStringList& ids) {
  qDeleteAll(trees_->takeChildren());
  for (const QString& id : ids) {
    bt::NodeSpec node;
    node.id = "SubTree";
    node.subTree = id.toStdString();
    node.autoRemap = true;
    addNode(*trees_, node, id, tr("Runs the tree %1 with all entries of this tree.").arg(id));
  }
  trees_->setHidden(ids.isEmpty());
  filter();
}

void NodePalette::setTheme(const Theme& theme) {
  theme_ = theme;
  search_->setTheme(theme);
  for (QTreeWidgetItemIterator row(list_); *row != nullptr; ++row) {
    bt::TreeFile alone;
    const QString xml = xmlOf(*row);
    const base::Result<bt::NodeSpec> node = xml.isEmpty()
                                                ? base::Result<bt::NodeSpec>(bt::NodeSpec())
                                                : nodeFromText(xml.toStdString(), alone);
    if (!xml.isEmpty() && node) {
      (*row)->setIcon(0, drawnIcon(16, [&](QPainter& painter) {
                        paintNodeSign(painter, *node, {}, theme_.color(Role::TextSecondary));
                      }));
    }
  }
}

/// Among the visible rows: one whose name starts with the text, else one that contains it, else the
/// first.
const QTreeWidgetItem* NodePalette::bestMatch() const {
  const QString text = search_->text().trimmed();
  const QTreeWidgetItem* best = nullptr;
  int bestRank = 3;
  for (QTreeWidgetItemIterator row(list_); *row != nullptr; ++row) {
    if ((*row)->isHidden() || xmlOf(*row).isEmpty()) {
      continue;
    }
    const int place = (*row)->text(0).indexOf(text, 0, Qt::CaseInsensitive);
    const int rank = place == 0 ? 0 : place > 0 ? 1 : 2;
    if (rank < bestRank) {
      best = *row;
      bestRank = rank;
    }
  }
  return best;
}

void NodePalette::filter() {
  const QString text = search_->text().trimmed();
  bool found = false;
  for (int k = 0; k < list_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* group = list_->topLevelItem(k);
    int count = 0;
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* row = group->child(i);
      const bool fits = row->text(0).contains(text, Qt::CaseInsensitive) ||
                        row->data(0, kHelpRole).toString().contains(text, Qt::CaseInsensitive);
      row->setHidden(!fits);
      count += fits ? 1 : 0;
    }
    group->setHidden(count == 0);
    group->setData(0, kSideTextRole, QString::number(count));
    if (!text.isEmpty()) {
      group->setExpanded(true);
    }
    found = found || count > 0;
  }
  nothing_->setMatchFound(found);
}

void NodePalette::explain() {
  const QTreeWidgetItem* row = list_->currentItem();
  const QString help = row == nullptr ? QString() : row->data(0, kHelpRole).toString();
  help_->setText(help.isEmpty() ? tr("Drag a node into the tree, or double-click it to add it to "
                                     "the selected node.")
                                : help.section(QLatin1Char('\n'), 0, 0));
  help_->setToolTip(help);
}

}  // namespace editor
