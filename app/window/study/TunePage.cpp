#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "app/report/TuneReport.h"
#include "app/run/ResultRow.h"
#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/Form.h"
#include "editor/panels/runs/ScatterPlot.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using report::TuneOutput;

constexpr double kLeastReach = 1e-9;  // of a scale

QString tunedUnit(const std::string& key) {
  const std::optional<ColumnInfo> info = columnInfo(key);
  return info && info->unit != "-" ? QString::fromStdString(info->unit) : QString();
}

/// The change of a candidate in the search, in the direction of the metric [%].
double changePercent(const TuneOutput& output, const TuneOutput::Candidate& candidate,
                     std::size_t objective) {
  const std::optional<ColumnInfo> info = columnInfo(output.objectives[objective]);
  const double sign = info && info->sense > 0 ? -1.0 : 1.0;
  return 100.0 * sign * (candidate.ratios[objective] - 1.0);
}

QString percentChange(double percent) {
  return std::isnan(percent)
             ? OutputPage::tr("–")
             : QString::fromStdString(report::signedNumberText(percent, 1)) + QStringLiteral(" %");
}

/// "time to reach the goal −12.1 % [−15.0, −9.3], success 95 % before, 97 % after"
QString evaluatedChanges(const TuneOutput& output) {
  if (output.evaluations.empty()) {
    return {};
  }
  const TuneOutput::Evaluation& all = output.evaluations.front();
  QStringList parts;
  for (std::size_t k = 0; k < output.objectives.size(); ++k) {
    parts.append(outputMetricTitle(output.objectives[k], false) + QLatin1Char(' ') +
                 QString::fromStdString(report::relativeText(all.objectives[k])));
  }
  const auto percent = [](double share) {
    return QString::fromStdString(report::percentText(share));
  };
  parts.append(OutputPage::tr("success %1 before, %2 after")
                   .arg(percent(all.success.before), percent(all.success.after)));
  return parts.join(QStringLiteral(", "));
}

/// The values of a candidate that differ from those before.
QString changedValues(const TuneOutput& output, const TuneOutput::Candidate& candidate) {
  QStringList changes;
  for (std::size_t k = 0; k < candidate.values.size(); ++k) {
    if (candidate.values[k] != output.parameters[k].before) {
      changes.append(QString::fromStdString(output.parameters[k].name + " " + candidate.values[k]));
    }
  }
  return changes.isEmpty() ? OutputPage::tr("none (before)") : changes.join(QStringLiteral(", "));
}

/// The end of the scale that a metric has in all rows. `differenceOf`: the difference of a row.
template <typename Rows, typename DifferenceOf>
double commonReach(const Rows& rows, const DifferenceOf& differenceOf) {
  double reach = kLeastReach;
  for (const auto& row : rows) {
    const TuneDifference& of = differenceOf(row);
    reach = reachOf(of.difference, of.interval, reach);
  }
  return reach;
}

/// The same for an objective of evaluations or effects.
template <typename Rows>
double objectiveReach(const Rows& rows, std::size_t objective) {
  return commonReach(rows, [objective](const auto& row) -> const TuneDifference& {
    return row.objectives[objective];
  });
}

/// Colours the lines of a unified diff.
class DiffColors : public QSyntaxHighlighter {
 public:
  DiffColors(QTextDocument* document, const editor::Theme& theme)
      : QSyntaxHighlighter(document), theme_(theme) {}

 protected:
  void highlightBlock(const QString& line) override {
    const bool isHead = line.startsWith(QLatin1String("---")) ||
                        line.startsWith(QLatin1String("+++")) ||
                        line.startsWith(QLatin1String("@@"));
    const editor::Role role = isHead                              ? editor::Role::TextSecondary
                              : line.startsWith(QLatin1Char('+')) ? editor::Role::Ok
                              : line.startsWith(QLatin1Char('-')) ? editor::Role::Error
                                                                  : editor::Role::Text;
    setFormat(0, line.size(), theme_.color(role));
  }

 private:
  const editor::Theme theme_;
};

/// Evaluation, parameters, Pareto front and changed lines of a tuning.
class TunePage : public OutputPage {
  Q_DECLARE_TR_FUNCTIONS(app::TunePage)
 public:
  TunePage(const TuneOutput& output, const OutputPlace& place) : output_(output), place_(place) {
    addPage(tr("Evaluation"), makeEvaluation());
    addPage(tr("Parameters"), makeParameters());
    addPage(tr("Pareto front"), makeFront());
    addPage(tr("Changes"), makeChanges());
  }

 private:
  QWidget* makeEvaluation() {
    if (output_.evaluations.empty()) {
      return editor::emptyState(
          tr("No candidate was better in the search, so none was evaluated on new runs."), this);
    }
    auto* table = new QTableWidget;
    styleStudyTable(*table, tr("Evaluation"));
    setStudyColumns(*table,
                    {tr("Scenario"), tr("Metric"), tr("Before"), tr("After"), tr("Difference"),
                     tr("Relative"), tr("Pairs")},
                    {0, 1});
    for (const TuneOutput::Evaluation& each : output_.evaluations) {
      addEvaluation(*table, each);
    }
    widenColumns(*table);
    QStringList note = {
        tr("After − before with 95 % intervals, on runs that the search has not "
           "seen, paired by scenario and seed. Pairs in which a run failed are "
           "excluded from the objectives.")};
    for (const std::string& scenario : output_.withoutSeedEffect) {
      note.append(tr("%1: all seeds have the same results, so its runs are not independent.")
                      .arg(scenarioTitle(scenario)));
    }
    return pageWithNote(table, note.join(QLatin1Char('\n')));
  }

  void addEvaluation(QTableWidget& table, const TuneOutput::Evaluation& of) {
    const QString scenario = of.scenario.empty() ? tr("All") : scenarioTitle(of.scenario);
    const int first = table.rowCount();
    const double successReach = commonReach(
        output_.evaluations,
        [](const TuneOutput::Evaluation& each) -> const TuneDifference& { return each.success; });
    addDifference(table, scenario, metricCell("success", false), of.success, true, successReach);
    for (std::size_t k = 0; k < output_.objectives.size(); ++k) {
      addDifference(table, scenario, metricCell(output_.objectives[k]), of.objectives[k], false,
                    objectiveReach(output_.evaluations, k));
    }
    for (int row = first; row < table.rowCount(); ++row) {
      table.item(row, 0)->setToolTip(QString::fromStdString(of.scenario));
    }
  }

  static void addDifference(QTableWidget& table, const QString& scenario, QTableWidgetItem* metric,
                            const TuneDifference& of, bool isRate, double reach) {
    const int row = table.rowCount();
    table.insertRow(row);
    table.setItem(row, 0, studyCell(scenario, true));
    table.setItem(row, 1, metric);
    const auto value = [&](double number) {
      return isRate && !std::isnan(number) ? QString::fromStdString(report::percentText(number))
                                           : outputNumber(number, of.interval);
    };
    table.setItem(row, 2, studyCell(value(of.before), false));
    table.setItem(row, 3, studyCell(value(of.after), false));
    table.setItem(row, 4,
                  differenceCell(of.difference, of.interval, reach,
                                 isRate ? tr("points") : QString(), isRate ? 100.0 : 1.0));
    table.setItem(
        row, 5,
        studyCell(isRate ? QString() : QString::fromStdString(report::relativeText(of)), false));
    table.setItem(row, 6, studyCell(QString::number(of.pairs), false));
  }

  QWidget* makeParameters() {
    auto* table = new QTableWidget;
    styleStudyTable(*table, tr("Parameters"));
    QStringList titles = {tr("Parameter"), tr("Range"),       tr("Before"),
                          tr("After"),     tr("In the file"), tr("Effect on the score")};
    for (const std::string& key : output_.objectives) {
      titles.append(tr("Effect on %1").arg(outputMetricTitle(key, false)));
    }
    setStudyColumns(*table, titles, {0, 1, 4});
    for (const TuneOutput::Parameter& parameter : output_.parameters) {
      addParameter(*table, parameter);
    }
    widenColumns(*table);
    return pageWithNote(
        table,
        tr("Effect on the score: what is lost without the change. Effects on metrics: with the "
           "change − without it, with 95 % intervals, on runs of the search. Changes that lose "
           "nothing when they are reverted together are not in the tuned file."));
  }

  void addParameter(QTableWidget& table, const TuneOutput::Parameter& parameter) {
    const auto effect = std::find_if(
        output_.effects.begin(), output_.effects.end(),
        [&](const TuneOutput::Effect& each) { return each.parameter == parameter.name; });
    const bool isTried = effect != output_.effects.end();
    const int row = table.rowCount();
    table.insertRow(row);
    table.setItem(row, 0, studyCell(QString::fromStdString(parameter.name), true));
    const QString range = tr("%1 to %2")
                              .arg(QString::fromStdString(base::formatDouble(parameter.low)),
                                   QString::fromStdString(base::formatDouble(parameter.high)));
    table.setItem(
        row, 1,
        studyCell(parameter.isLogarithmic ? tr("%1, logarithmic").arg(range) : range, true));
    table.setItem(row, 2, studyCell(QString::fromStdString(parameter.before), false));
    const std::string after = isTried ? effect->value : parameter.chosen.value_or(parameter.before);
    QTableWidgetItem* value = studyCell(QString::fromStdString(after), false);
    QFont font = table.font();
    font.setBold(after != parameter.before);
    value->setFont(font);
    table.setItem(row, 3, value);
    table.setItem(row, 4,
                  studyCell(!isTried         ? tr("unchanged")
                            : effect->isKept ? tr("yes")
                                             : tr("no"),
                            true));
    table.setItem(row, 5,
                  studyCell(isTried ? percentChange(100.0 * effect->score) : tr("–"), false));
    for (std::size_t k = 0; k < output_.objectives.size(); ++k) {
      table.setItem(
          row, 6 + static_cast<int>(k),
          isTried
              ? differenceCell(effect->objectives[k].difference, effect->objectives[k].interval,
                               objectiveReach(output_.effects, k), tunedUnit(output_.objectives[k]))
              : studyCell(tr("–"), false));
    }
  }

  QWidget* makeFront() {
    QStringList titles;
    for (const std::string& key : output_.objectives) {
      titles.append(tr("%1 [%]").arg(outputMetricTitle(key, false)));
    }
    titles.append(tr("Changed values"));
    QTableWidget* table = studyList(tr("Candidates on the front"), titles, {titles.size() - 1});
    for (std::size_t k = 0; k < output_.candidates.size(); ++k) {
      if (output_.candidates[k].isOnFront) {
        addCandidate(*table, k);
      }
    }
    widenColumns(*table);
    table->horizontalHeader()->setStretchLastSection(true);
    QWidget* content = table;
    if (output_.objectives.size() == 2) {
      auto* halves = new QSplitter(Qt::Horizontal);
      halves->setChildrenCollapsible(false);
      halves->addWidget(makePlane(*table));
      halves->addWidget(table);
      halves->setStretchFactor(0, 1);
      halves->setStretchFactor(1, 1);
      content = halves;
    }
    return pageWithNote(
        content,
        tr("Pareto-optimal candidates in the runs of the search, relative to the current values. "
           "The best of many candidates is selected, so these values are optimistic on average."));
  }

  void addCandidate(QTableWidget& table, std::size_t number) {
    const TuneOutput::Candidate& candidate = output_.candidates[number];
    const int row = table.rowCount();
    table.insertRow(row);
    for (std::size_t k = 0; k < output_.objectives.size(); ++k) {
      table.setItem(row, static_cast<int>(k),
                    studyCell(percentChange(changePercent(output_, candidate, k)), false));
    }
    QTableWidgetItem* values = studyCell(changedValues(output_, candidate), true);
    values->setToolTip(values->text());
    table.setItem(row, table.columnCount() - 1, values);
    table.item(row, 0)->setData(Qt::UserRole, static_cast<int>(number));
  }

  /// The points are the candidates with both values; a click selects the row and the other way
  /// round.
  QWidget* makePlane(QTableWidget& table) {
    editor::PlottedPoints shown;
    shown.xTitle = tr("%1 [%]").arg(outputMetricTitle(output_.objectives[0], false));
    shown.yTitle = tr("%1 [%]").arg(outputMetricTitle(output_.objectives[1], false));
    std::vector<int> candidates;
    for (std::size_t k = 0; k < output_.candidates.size(); ++k) {
      const TuneOutput::Candidate& each = output_.candidates[k];
      const double x = changePercent(output_, each, 0), y = changePercent(output_, each, 1);
      if (std::isnan(x) || std::isnan(y)) {
        continue;
      }
      const QString name = each.isBefore ? tr("before") : each.isChosen ? tr("chosen") : QString();
      shown.points.push_back(
          {x, y, name, changedValues(output_, each), each.isOnFront, !name.isEmpty()});
      candidates.push_back(static_cast<int>(k));
      if (each.isOnFront) {
        shown.line.emplace_back(x, y);
      }
    }
    std::sort(shown.line.begin(), shown.line.end(),
              [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
    auto* plane = new editor::ScatterPlot(place_.theme, tr("Pareto front"));
    plane->setMinimumWidth(kLeastPlane);
    plane->show(std::move(shown));
    connect(&table, &QTableWidget::currentCellChanged, plane, [plane, &table, candidates](int row) {
      const int number = row < 0 ? -1 : table.item(row, 0)->data(Qt::UserRole).toInt();
      const auto at = std::find(candidates.begin(), candidates.end(), number);
      plane->setCurrent(at == candidates.end() ? -1 : static_cast<int>(at - candidates.begin()));
    });
    connect(plane, &editor::ScatterPlot::pointClicked, &table, [&table, candidates](int point) {
      for (int row = 0; row < table.rowCount(); ++row) {
        if (table.item(row, 0)->data(Qt::UserRole).toInt() ==
            candidates[static_cast<std::size_t>(point)]) {
          table.setCurrentCell(row, 0);
        }
      }
    });
    return plane;
  }

  QWidget* makeChanges() {
    if (output_.diff.empty()) {
      return editor::emptyState(tr("The file is unchanged."), this);
    }
    auto* text = new QPlainTextEdit(QString::fromStdString(output_.diff), this);
    text->setReadOnly(true);
    text->setFrameShape(QFrame::NoFrame);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setTabChangesFocus(true);
    text->setAccessibleName(tr("Changes"));
    new DiffColors(text->document(), place_.theme);
    return output_.verdict == TuneVerdict::Improved
               ? pageWithNote(text, tr("From the current file to the tuned one."))
               : pageWithNote(text, tr("From the current file to the best candidate, which is not "
                                       "used: the tuned file is unchanged."));
  }

  static constexpr int kLeastPlane = 320;  // [px]
  const TuneOutput output_;
  const OutputPlace place_;
};

}  // namespace

OutputPage* makeTunePage(const report::TuneOutput& output, const OutputPlace& place) {
  return new TunePage(output, place);
}

QString tuneHeadline(const report::TuneOutput& output) {
  switch (output.verdict) {
    case TuneVerdict::Improved:
      return OutputPage::tr("Improved: %1").arg(evaluatedChanges(output));
    case TuneVerdict::NotConfirmed:
      return OutputPage::tr(
                 "No improvement found: on new runs the best candidate is not clearly "
                 "better: %1")
          .arg(evaluatedChanges(output));
    case TuneVerdict::NoCandidate:
      break;
  }
  if (output.tried == 0) {
    return OutputPage::tr("Nothing tried: the limit of runs (--runs) is too small");
  }
  return OutputPage::tr(
             "No improvement found: none of %1 candidates was better than the current values")
      .arg(output.tried);
}

}  // namespace app
