#include "editor/look/TableExport.h"

#include <algorithm>
#include <memory>

#include "app/report/Markup.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

using report::Table;

/// The visible columns, from left to right.
std::vector<int> columnsOf(const QAbstractItemView& view) {
  const auto* const table = qobject_cast<const QTableView*>(&view);
  const auto* const tree = qobject_cast<const QTreeView*>(&view);
  const QHeaderView* const header = table != nullptr  ? table->horizontalHeader()
                                    : tree != nullptr ? tree->header()
                                                      : nullptr;
  std::vector<int> columns;
  for (int k = 0; k < view.model()->columnCount(); ++k) {
    const int column = header == nullptr ? k : header->logicalIndex(k);
    if (header == nullptr || !header->isSectionHidden(column)) {
      columns.push_back(column);
    }
  }
  return columns;
}

bool isRowHidden(const QAbstractItemView& view, int row, const QModelIndex& parent) {
  const auto* const table = qobject_cast<const QTableView*>(&view);
  const auto* const tree = qobject_cast<const QTreeView*>(&view);
  const auto* const list = qobject_cast<const QListView*>(&view);
  return table != nullptr  ? table->isRowHidden(row)
         : tree != nullptr ? tree->isRowHidden(row, parent)
                           : list != nullptr && list->isRowHidden(row);
}

/// "1.50", "+0.2", "−3 %", "∞" and dashes for undefined values.
bool looksLikeNumber(const QString& text) {
  static const QRegularExpression kNumber(
      QStringLiteral("^[+−-]?(\\d[\\d.,:]*|∞)([eE][+-]?\\d+)?( ?%)?$|^[–=]$"));
  return kNumber.match(text).hasMatch();
}

/// Collects the rows of a view.
class TableReader {
 public:
  TableReader(const QAbstractItemView& view, const QString& name)
      : view_(view), columns_(columnsOf(view)) {
    table_.name = name.toStdString();
    table_.caption = name.toStdString();
    const QAbstractItemModel& model = *view.model();
    hasGroups_ = false;
    for (int row = 0; row < model.rowCount(); ++row) {
      hasGroups_ = hasGroups_ || model.hasChildren(model.index(row, 0));
    }
    readRows({}, {});
    addColumns(model);
    dropEmptyColumns();
  }

  const Table& table() const { return table_; }

 private:
  void addColumns(const QAbstractItemModel& model) {
    if (hasGroups_) {
      table_.columns.push_back({QObject::tr("Group").toStdString(), {}, false});
    }
    for (const int column : columns_) {
      const QVariant title = model.headerData(column, Qt::Horizontal);
      const std::size_t cell = table_.columns.size();
      const auto isNumber = [cell](const std::vector<Table::Cell>& row) {
        const QString text = QString::fromStdString(row[cell].text);
        return text.isEmpty() || looksLikeNumber(text);
      };
      const auto isEmpty = [cell](const auto& row) { return row[cell].text.empty(); };
      table_.columns.push_back({title.toString().toStdString(),
                                {},
                                std::all_of(table_.rows.begin(), table_.rows.end(), isNumber) &&
                                    !std::all_of(table_.rows.begin(), table_.rows.end(), isEmpty)});
      table_.columns.push_back({QObject::tr("Key").toStdString(), {}, false});
    }
  }

  void readRows(const QModelIndex& parent, const QString& group) {
    const QAbstractItemModel& model = *view_.model();
    for (int row = 0; row < model.rowCount(parent); ++row) {
      const QModelIndex index = model.index(row, 0, parent);
      if (isRowHidden(view_, row, parent)) {
        continue;
      }
      const bool isGroup = !parent.isValid() && model.hasChildren(index);
      if (!isGroup) {
        readRow(index, group);
      }
      readRows(index, isGroup ? index.data().toString() : group);
    }
  }

  void readRow(const QModelIndex& index, const QString& group) {
    std::vector<Table::Cell> cells;
    if (hasGroups_) {
      cells.push_back({group.toStdString()});
    }
    for (const int column : columns_) {
      const QModelIndex at = index.siblingAtColumn(column);
      Table::Cell cell;
      cell.text = at.data().toString().toStdString();
      cell.csv = at.data(kExactValueRole).toString().toStdString();
      cells.push_back(std::move(cell));
      cells.push_back({at.data(kSavedKeyRole).toString().toStdString()});
    }
    table_.rows.push_back(std::move(cells));
  }

  /// A column of keys follows each column of the view.
  bool isKeyColumn(std::size_t column) const { return column % 2 == (hasGroups_ ? 0 : 1); }

  /// Columns without text contain pictures or buttons only, or no keys.
  void dropEmptyColumns() {
    for (std::size_t k = table_.columns.size(); k-- > 0;) {
      const bool isEmpty = std::all_of(table_.rows.begin(), table_.rows.end(),
                                       [k](const auto& row) { return row[k].text.empty(); });
      if (!isEmpty || (table_.rows.empty() && !isKeyColumn(k))) {
        continue;
      }
      const auto at = static_cast<std::ptrdiff_t>(k);
      table_.columns.erase(table_.columns.begin() + at);
      for (std::vector<Table::Cell>& row : table_.rows) {
        row.erase(row.begin() + at);
      }
    }
  }

  const QAbstractItemView& view_;
  std::vector<int> columns_;
  bool hasGroups_ = false;
  Table table_;
};

/// Tabs instead of commas: spreadsheets and word processors make cells of them.
QString tabbedText(const Table& table) {
  QStringList lines;
  QStringList fields;
  for (const Table::Column& column : table.columns) {
    fields << QString::fromStdString(column.title);
  }
  lines << fields.join(QLatin1Char('\t'));
  for (const std::vector<Table::Cell>& row : table.rows) {
    fields.clear();
    for (const Table::Cell& cell : row) {
      fields << QString::fromStdString(cell.text).simplified();
    }
    lines << fields.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString textAs(const Table& table, TableFormat format) {
  return QString::fromStdString(format == TableFormat::Csv     ? report::tableCsv(table)
                                : format == TableFormat::Latex ? report::tableLatex(table)
                                                               : report::tableMarkdown(table));
}

void saveTable(QAbstractItemView& view, const QString& name) {
  const QPointer<QAbstractItemView> alive(&view);
  const QString file =
      askFileToSave(view, QObject::tr("Save table"), name,
                    {QObject::tr("Comma-separated values (*.csv)"), QObject::tr("LaTeX (*.tex)"),
                     QObject::tr("Markdown (*.md)")});
  if (file.isEmpty() || alive == nullptr) {
    return;
  }
  const QString ending = QFileInfo(file).suffix().toLower();
  const TableFormat format = ending == QLatin1String("tex")  ? TableFormat::Latex
                             : ending == QLatin1String("md") ? TableFormat::Markdown
                                                             : TableFormat::Csv;
  const base::Diagnostics problems =
      base::writeFileAtomically(file.toStdString(), tableText(view, name, format).toStdString());
  if (base::hasErrors(problems)) {
    QMessageBox::warning(&view, QObject::tr("Save table"),
                         QString::fromStdString(problems.front().text()));
  }
}

QString folderFor(const QWidget& widget) {
  for (const QWidget* each = &widget; each != nullptr; each = each->parentWidget()) {
    QString folder = each->property(kFolderProperty).toString();
    if (!folder.isEmpty()) {
      return folder;
    }
  }
  return QDir::homePath();
}

/// "csv" for "Comma-separated values (*.csv)"
QString endingOf(const QString& filter) {
  return filter.section(QStringLiteral("*."), 1).section(QLatin1Char(')'), 0, 0);
}

}  // namespace

QString tableText(const QAbstractItemView& view, const QString& name, TableFormat format) {
  return textAs(TableReader(view, name).table(), format);
}

void addTableActions(QMenu& menu, QAbstractItemView& view, const QString& name) {
  QAction* const copy = menu.addAction(QObject::tr("Copy table"), &view, [&view, name] {
    QGuiApplication::clipboard()->setText(tabbedText(TableReader(view, name).table()));
  });
  describe(*copy, QObject::tr("Copy the rows as text that spreadsheets understand"));
  QAction* const save = menu.addAction(QObject::tr("Save table…"), &view,
                                       [&view, name] {  // after the menu has closed
                                         later(view, [&view, name] { saveTable(view, name); });
                                       });
  describe(*save, QObject::tr("Save the rows as CSV, LaTeX or Markdown"));
  for (QAction* action : {copy, save}) {
    action->setEnabled(view.model()->rowCount() > 0);
  }
}

void makeTableSavable(QAbstractItemView& view, const QString& name) {
  view.setContextMenuPolicy(Qt::CustomContextMenu);
  QObject::connect(&view, &QWidget::customContextMenuRequested, &view,
                   [&view, name, menu = std::make_shared<PanelMenu>()](const QPoint& at) {
                     QMenu& offered = menu->begin(view);
                     addTableActions(offered, view, name);
                     offered.popup(view.viewport()->mapToGlobal(at));
                   });
}

QString askFileToSave(QWidget& parent, const QString& title, const QString& name,
                      const QStringList& filters) {
  QFileDialog dialog(parent.window(), title, folderFor(parent));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix(endingOf(filters.front()));
  QString proposed = name.toLower().simplified().replace(QLatin1Char(' '), QLatin1Char('-'));
  proposed.remove(QRegularExpression(QStringLiteral("[^\\w.-]")));
  dialog.selectFile(proposed + QLatin1Char('.') + endingOf(filters.front()));
  // The proposed name follows the chosen format.
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
    dialog.setDefaultSuffix(endingOf(filter));
    const QString typed = QFileInfo(dialog.selectedFiles().value(0)).completeBaseName();
    dialog.selectFile(typed + QLatin1Char('.') + endingOf(filter));
  });
  return chosenFiles(dialog, true).value(0);
}

}  // namespace editor
