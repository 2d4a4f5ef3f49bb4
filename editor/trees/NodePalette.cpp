#include <algorithm>
#include <iterator>

#include "bt/human/BehaviorBlocks.h"
#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/RowDelegate.h"
#include "editor/trees/TreeCanvas.h"
#include "editor/trees/TreeEdits.h"
#include "editor/trees/TreeViews.h"

namespace editor {

namespace {

constexpr int kXmlRole = Qt::UserRole;
constexpr int kHelpRole = Qt::UserRole + 1;
constexpr int kRankRole = Qt::UserRole + 2;   // Quality of the match; 0 = best.
constexpr int kOrderRole = Qt::UserRole + 3;  // Order without a search.
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

/// Sorted by quality of the match, then in the usual order.
class PaletteRow : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int rank = data(0, kRankRole).toInt(), otherRank = other.data(0, kRankRole).toInt();
    return rank != otherRank ? rank < otherRank
                             : data(0, kOrderRole).toInt() < other.data(0, kOrderRole).toInt();
  }
};

enum Match { NameStart, WordStart, InName, InHelp, NoMatch };

/// How well a node type fits a search text: names are matched before descriptions, and their
/// beginning before the rest. "robotvis" fits IsRobotVisible, and so does "robot vis".
Match matchOf(const QString& name, const QString& help, const QString& text) {
  const QString words = QString(text).remove(QLatin1Char(' '));
  const int at = name.indexOf(words, 0, Qt::CaseInsensitive);
  if (at == 0) {
    return NameStart;
  }
  for (int k = at; k > 0; k = name.indexOf(words, k + 1, Qt::CaseInsensitive)) {
    if (name[k].isUpper() || !name[k - 1].isLetter()) {
      return WordStart;
    }
  }
  return at > 0 ? InName : help.contains(text, Qt::CaseInsensitive) ? InHelp : NoMatch;
}

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
    lines << line + QStringLiteral("): ") + coreText(port.help);
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
  search_->installEventFilter(this);
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
  auto* group = new PaletteRow(list_, QStringList(title));
  group->setData(0, kOrderRole, list_->topLevelItemCount());
  group->setFlags(Qt::ItemIsEnabled);
  return group;
}

void NodePalette::addNode(QTreeWidgetItem& group, const bt::NodeSpec& node, const QString& title,
                          const QString& help) {
  auto* row = new PaletteRow(&group, QStringList(title));
  row->setData(0, kXmlRole, qtText(nodeText(node)));
  row->setData(0, kHelpRole, help);
  row->setData(0, kOrderRole, group.childCount());
  row->setToolTip(0, help);
  row->setIcon(0, drawnIcon(16, [&](QPainter& painter) {
                 paintNodeSign(painter, node, {}, theme_.color(Role::TextSecondary));
               }));
  group.setData(0, kSideTextRole, QString::number(group.childCount()));
}

/// Sorts the rows by name; this is their order without a search.
void NodePalette::numberByName(QTreeWidgetItem& group) {
  QList<QTreeWidgetItem*> rows = group.takeChildren();
  std::sort(rows.begin(), rows.end(), [](const QTreeWidgetItem* a, const QTreeWidgetItem* b) {
    return a->text(0).localeAwareCompare(b->text(0)) < 0;
  });
  for (int k = 0; k < rows.size(); ++k) {
    rows[k]->setData(0, kOrderRole, k);
  }
  group.addChildren(rows);
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
                coreText(manifest.description) +
                    (ports.isEmpty() ? QString() : QLatin1Char('\n') + ports));
      }
    }
    numberByName(*group);
    group->setExpanded(true);
  }
  trees_ = addGroup(tr("Subtrees"));
  QTreeWidgetItem* templates = addGroup(tr("Templates"));
  for (const bt::BlockType& kind : bt::blockTypes()) {
    bt::Block block;
    block.id = kind.id;
    addNode(*templates, bt::blockToNode(block), coreText(kind.title), coreText(kind.description));
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

/// Hides all other rows; the best match comes first and is highlighted, so that Enter adds it.
void NodePalette::filter() {
  const QString text = search_->text().trimmed();
  for (int k = 0; k < list_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* group = list_->topLevelItem(k);
    int count = 0, best = NoMatch;
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* row = group->child(i);
      const int match =
          text.isEmpty() ? 0 : matchOf(row->text(0), row->data(0, kHelpRole).toString(), text);
      row->setHidden(match == NoMatch);
      row->setData(0, kRankRole, match);
      best = std::min(best, match);
      count += match == NoMatch ? 0 : 1;
    }
    group->setHidden(count == 0);
    group->setData(0, kRankRole, best);
    group->setData(0, kSideTextRole, QString::number(count));
    if (!text.isEmpty()) {
      group->setExpanded(true);
    }
  }
  list_->sortItems(0, Qt::AscendingOrder);
  QTreeWidgetItem* first = firstMatch();
  nothing_->setMatchFound(first != nullptr);
  list_->setCurrentItem(text.isEmpty() ? nullptr : first);
  first != nullptr && !text.isEmpty() ? list_->scrollToItem(first->parent()) : list_->scrollToTop();
}

void NodePalette::startSearch() {
  search_->setFocus();
  search_->selectAll();
}

QTreeWidgetItem* NodePalette::firstMatch() const {
  for (QTreeWidgetItemIterator row(list_, QTreeWidgetItemIterator::NotHidden); *row != nullptr;
       ++row) {
    if (!xmlOf(*row).isEmpty()) {
      return *row;
    }
  }
  return nullptr;
}

/// In the search field, the arrow keys choose a match, Enter adds it and Escape leaves the palette.
bool NodePalette::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = watched == search_ && (event->type() == QEvent::KeyPress ||
                                            event->type() == QEvent::ShortcutOverride);
  if (!isKey) {
    return QWidget::eventFilter(watched, event);
  }
  const int key = static_cast<const QKeyEvent&>(*event).key();
  const int keys[] = {Qt::Key_Up, Qt::Key_Down, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape};
  if (std::find(std::begin(keys), std::end(keys), key) == std::end(keys)) {
    return QWidget::eventFilter(watched, event);
  }
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
  } else if (key == Qt::Key_Escape) {
    Q_EMIT escaped();
  } else if (key == Qt::Key_Up || key == Qt::Key_Down) {
    moveCurrent(key == Qt::Key_Down);
  } else {
    addCurrent();
  }
  return true;
}

/// Adds the highlighted match; the next typed text replaces the search.
void NodePalette::addCurrent() {
  const QTreeWidgetItem* row = list_->currentItem();
  const QString xml = row == nullptr || row->isHidden() ? QString() : xmlOf(row);
  if (!xml.isEmpty()) {
    search_->selectAll();
    Q_EMIT addRequested(xml);
  }
}

/// To the next or previous visible node, across headings.
void NodePalette::moveCurrent(bool down) {
  QTreeWidgetItem* row =
      list_->currentItem() == nullptr ? list_->topLevelItem(0) : list_->currentItem();
  do {
    row = down ? list_->itemBelow(row) : list_->itemAbove(row);
  } while (row != nullptr && xmlOf(row).isEmpty());
  if (row != nullptr) {
    list_->setCurrentItem(row);
  }
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
