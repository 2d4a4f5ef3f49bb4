#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "app/report/Markup.h"
#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/Form.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using report::SearchOutput;

enum SearchColumn {
  KindColumn,
  FoundIn,
  FailureSeed,
  PeopleColumn,
  EndedBy,
  EndTime,
  ChangesColumn,
  RepeatedColumn
};

/// A part of the name of a FailureKind.
QString kindPart(const QString& part) {
  static const std::map<QString, const char*> kParts = {
      {QStringLiteral("contact"), QT_TRANSLATE_NOOP("app::OutputPage", "Contact")},
      {QStringLiteral("standstill"), QT_TRANSLATE_NOOP("app::OutputPage", "Standstill")},
      {QStringLiteral("failure"), QT_TRANSLATE_NOOP("app::OutputPage", "Navigation failed")},
      {QStringLiteral("time"), QT_TRANSLATE_NOOP("app::OutputPage", "Time limit")},
      {QStringLiteral("error"), QT_TRANSLATE_NOOP("app::OutputPage", "Run aborted")},
      {QStringLiteral("front"), QT_TRANSLATE_NOOP("app::OutputPage", "person in front")},
      {QStringLiteral("left"), QT_TRANSLATE_NOOP("app::OutputPage", "person on the left")},
      {QStringLiteral("right"), QT_TRANSLATE_NOOP("app::OutputPage", "person on the right")},
      {QStringLiteral("behind"), QT_TRANSLATE_NOOP("app::OutputPage", "person behind")},
      {QStringLiteral("obstacle"), QT_TRANSLATE_NOOP("app::OutputPage", "obstacle")},
      {QStringLiteral("no-person"), QT_TRANSLATE_NOOP("app::OutputPage", "no person near")},
      {QStringLiteral("earlier"),
       QT_TRANSLATE_NOOP("app::OutputPage", "before the end of the run")},
      {QStringLiteral("moving"), QT_TRANSLATE_NOOP("app::OutputPage", "moving")},
      {QStringLiteral("standing"), QT_TRANSLATE_NOOP("app::OutputPage", "standing")}};
  const auto found = kParts.find(part);
  return found == kParts.end() ? part : OutputPage::tr(found->second);
}

/// "contact-left-moving": "Contact · person on the left · moving".
QString kindText(const std::string& name) {
  const QString all = QString::fromStdString(name);
  const int dash = all.indexOf(QLatin1Char('-'));
  if (dash < 0) {
    return kindPart(all);
  }
  const QString end = all.left(dash), rest = all.mid(dash + 1);
  QStringList parts = {kindPart(end)};
  if (rest == QLatin1String("no-person")) {
    parts.append(kindPart(rest));
  } else {
    for (const QString& part : rest.split(QLatin1Char('-'))) {
      parts.append(kindPart(part));
    }
  }
  return parts.join(QStringLiteral(" · "));
}

/// The lower end of a cell, as in the report.
QString cellTitle(const Descriptor& descriptor, int cell) {
  if (cell == Descriptor::kUndefinedCell) {
    return OutputPage::tr("none");
  }
  const double width = (descriptor.high - descriptor.low) / descriptor.cells;
  return QString::fromStdString(
      report::numberText(descriptor.low + width * cell, width < 0.995 ? 2 : 1));
}

QString worstText(const SearchOutput& output) {
  return QCoreApplication::translate("app::SearchPage", "Worst run: %1 = %2")
      .arg(outputMetricTitle(output.worstMetric), outputNumber(output.worstValue));
}

/// Failures that differ in kind, the worst run, and the archive of a search.
class SearchPage : public OutputPage {
  Q_DECLARE_TR_FUNCTIONS(app::SearchPage)
 public:
  SearchPage(const SearchOutput& output, const OutputPlace& place)
      : output_(output), place_(place) {
    if (output_.worst) {
      rows_.push_back(*output_.worst);
    }
    rows_.insert(rows_.end(), output_.failures.begin(), output_.failures.end());
    addPage(title(), rows_.empty()
                         ? static_cast<QWidget*>(editor::emptyState(tr("No run failed."), this))
                         : makeFailures());
    addPage(tr("Archive"), makeArchive());
  }

 private:
  QString title() const { return output_.worst ? tr("Worst run") : tr("Failures"); }

  QWidget* makeFailures() {
    QTableWidget* table =
        studyList(title(),
                  {tr("Kind"), tr("Found in"), tr("Seed"), tr("People"), tr("Ended"), tr("End [s]"),
                   tr("Remaining changes"), tr("Repeated")},
                  {KindColumn, FoundIn, EndedBy, ChangesColumn, RepeatedColumn});
    table->setRowCount(static_cast<int>(rows_.size()));
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      fillFailure(*table, static_cast<int>(k), rows_[k], output_.worst && k == 0);
    }
    widenColumns(*table);
    setPlayable(*table, tr("Double-click a failure to play it"), [this](int row) { play(row); });
    return pageWithNote(
        table,
        output_.worst
            ? tr("The run with the worst value of the metric. Double-click or Enter plays it.")
            : tr("One failure of each kind, with the fewest people and changes that still "
                 "fail in the same way. Double-click or Enter plays it; its scenario is in "
                 "the folder failures."));
  }

  void fillFailure(QTableWidget& table, int row, const SearchOutput::Failure& failure,
                   bool isWorst) {
    const QString kind = isWorst ? worstText(output_) : kindText(failure.kind);
    const auto add = [&table, row](int column, const QString& text, bool isText) {
      table.setItem(row, column, studyCell(text, isText));
      return table.item(row, column);
    };
    add(KindColumn, kind, true)
        ->setToolTip(kind + QLatin1Char('\n') + QString::fromStdString(failure.file));
    add(FoundIn, QString::fromStdString(failure.scenario), true);
    add(FailureSeed, QString::number(failure.seed), false);
    add(PeopleColumn,
        isWorst ? tr("–") : tr("%1 of %2").arg(failure.people).arg(failure.peopleBefore), false);
    add(EndedBy, QString::fromStdString(failure.reason), true);
    add(EndTime, outputNumber(failure.end), false);
    const QString changes = QString::fromStdString(base::join(failure.changes, ", "));
    add(ChangesColumn, changes.isEmpty() ? tr("none") : changes, true)->setToolTip(changes);
    QTableWidgetItem* repeated =
        add(RepeatedColumn, failure.isRepeated ? tr("yes") : tr("no"), true);
    repeated->setToolTip(failure.isRepeated
                             ? tr("The scenario has the same end and metrics, bit for bit")
                             : tr("The scenario does not reproduce the run"));
    if (!failure.isRepeated) {
      repeated->setForeground(place_.theme.color(editor::Role::Error));
    }
    if (!failure.isMinimal) {
      table.item(row, PeopleColumn)
          ->setToolTip(tr("The limit of runs was reached before the scenario was minimal"));
    }
  }

  void play(int row) {
    const SearchOutput::Failure& failure = rows_[static_cast<std::size_t>(row)];
    const std::string file = QDir(QString::fromStdString(place_.folder))
                                 .absoluteFilePath(QString::fromStdString(failure.file))
                                 .toStdString();
    Q_EMIT playRequested({"hunavsim " + base::shellWord(file), scenarioTitle(file)});
  }

  /// Rows from the top: the last cell of the second descriptor first.
  QWidget* makeArchive() {
    if (output_.cells.empty()) {
      return editor::emptyState(tr("The archive is empty: no run was simulated."), this);
    }
    const Descriptor& across = output_.descriptors[0];
    const Descriptor& up = output_.descriptors[1];
    auto* table = new QTableWidget(up.cells + 1, across.cells + 1);
    styleStudyTable(*table, tr("Archive"));
    table->setSelectionBehavior(QAbstractItemView::SelectItems);
    table->setShowGrid(true);
    styleArchiveHead(*table->verticalHeader());
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignCenter);
    QStringList columns, rows;
    for (int cell = Descriptor::kUndefinedCell; cell < across.cells; ++cell) {
      columns.append(cellTitle(across, cell));
    }
    for (int cell = up.cells - 1; cell >= Descriptor::kUndefinedCell; --cell) {
      rows.append(cellTitle(up, cell));
    }
    table->setHorizontalHeaderLabels(columns);
    table->setVerticalHeaderLabels(rows);
    fillArchive(*table);
    connect(table, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
      playKind(item->data(Qt::UserRole).toString());
    });
    return pageWithNote(
        table,
        tr("The best run in each cell. To the right: %1, upwards: %2; titles are the lower ends of "
           "the cells. Darker cells have a better run for the search; a dot marks a failure, and a "
           "double-click plays the failure of its kind.")
            .arg(outputMetricTitle(across.key), outputMetricTitle(up.key)));
  }

  /// All rows are visible, as far as they fit.
  static void styleArchiveHead(QHeaderView& head) {
    head.show();
    head.setMinimumSectionSize(kLeastArchiveRow);
    head.setSectionResizeMode(QHeaderView::Stretch);
    head.setFixedWidth(kArchiveTitles);
    head.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head.setTextElideMode(Qt::ElideNone);
  }

  void fillArchive(QTableWidget& table) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SearchOutput::Cell& cell : output_.cells) {
      if (!std::isnan(cell.fitness)) {
        low = std::min(low, cell.fitness);
        high = std::max(high, cell.fitness);
      }
    }
    const int rows = output_.descriptors[1].cells;
    for (const SearchOutput::Cell& cell : output_.cells) {
      const double share =
          high > low && !std::isnan(cell.fitness) ? (cell.fitness - low) / (high - low) : 1.0;
      const bool isFailure = !cell.kind.empty();
      auto* item = new QTableWidgetItem(isFailure ? QStringLiteral("●") : QString());
      item->setTextAlignment(Qt::AlignCenter);
      item->setData(kHeatRole, share);
      item->setData(Qt::UserRole, QString::fromStdString(cell.kind));
      const QString place = tr("%1, seed %2: %3")
                                .arg(QString::fromStdString(cell.scenario))
                                .arg(cell.seed)
                                .arg(QString::fromStdString(cell.reason));
      item->setToolTip(isFailure ? kindText(cell.kind) + QLatin1Char('\n') + place : place);
      table.setItem(rows - 1 - cell.at[1], cell.at[0] + 1, item);
    }
  }

  void playKind(const QString& kind) {
    for (std::size_t k = 0; k < rows_.size() && !kind.isEmpty(); ++k) {
      if (QString::fromStdString(rows_[k].kind) == kind) {
        play(static_cast<int>(k));
        return;
      }
    }
  }

  static constexpr int kLeastArchiveRow = 16;  // [px]
  static constexpr int kArchiveTitles = 64;    // [px]
  const SearchOutput output_;
  const OutputPlace place_;
  std::vector<SearchOutput::Failure> rows_;  // the worst run first
};

}  // namespace

OutputPage* makeSearchPage(const report::SearchOutput& output, const OutputPlace& place) {
  return new SearchPage(output, place);
}

QString searchHeadline(const report::SearchOutput& output) {
  const QString runs = editor::counted(output.runs, OutputPage::tr("run"), OutputPage::tr("runs"));
  QStringList parts = {output.worst ? runs + QStringLiteral(". ") + worstText(output)
                                    : runs + QStringLiteral(", ") +
                                          editor::counted(output.failures.size(),
                                                          OutputPage::tr("kind of failure"),
                                                          OutputPage::tr("kinds of failures"))};
  if (output.unavoidable > 0) {
    parts.append(OutputPage::tr("Contacts that the robot could not have avoided since first sight "
                                "do not count: %1")
                     .arg(output.unavoidable));
  }
  if (output.notSimulated > 0) {
    parts.append(OutputPage::tr("Runs that could not start: %1").arg(output.notSimulated));
  }
  return parts.join(QStringLiteral(". "));
}

}  // namespace app
