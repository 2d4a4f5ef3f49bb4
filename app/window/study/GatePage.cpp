#include <cmath>

#include "app/run/ResultRow.h"
#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using report::GateOutput;

constexpr double kMarginsShown = 4.0;  // at both ends of a scale, as in the report
enum GateColumn { GateMetricColumn, GateBase, GateCandidate, GateChange, GateMargin, GateWord };

QString unitOfGate(const std::string& unit) {
  return unit == "points" ? OutputPage::tr("points")
         : unit == "-"    ? QString()
                          : QString::fromStdString(unit);
}

QString verdictWord(const GateOutput::Metric& metric) {
  if (!metric.isMeasured) {
    return OutputPage::tr("not measured");
  }
  switch (metric.verdict) {
    case GateVerdict::Pass:
      return OutputPage::tr("pass");
    case GateVerdict::Worse:
      return OutputPage::tr("worse");
    case GateVerdict::Undecided:
      break;
  }
  return OutputPage::tr("undecided");
}

editor::Role roleOf(const GateOutput::Metric& metric) {
  return !metric.isMeasured                     ? editor::Role::TextSecondary
         : metric.verdict == GateVerdict::Pass  ? editor::Role::Ok
         : metric.verdict == GateVerdict::Worse ? editor::Role::Error
                                                : editor::Role::Warning;
}

QString gateValue(const GateOutput::Metric& metric, double value) {
  return metric.unit == "share" && !std::isnan(value)
             ? OutputPage::tr("%1 %").arg(outputNumber(std::round(1000.0 * value) / 10.0))
             : outputNumber(value);
}

/// The margin lies on the side on which the candidate is worse.
double marginPlace(const GateOutput::Metric& metric) {
  const std::optional<ColumnInfo> info = columnInfo(metric.label.substr(0, metric.label.find('>')));
  return info && info->sense > 0 ? -metric.margin : metric.margin;
}

void fillGateRow(QTableWidget& table, int row, const GateOutput::Metric& metric,
                 const editor::Theme& theme) {
  const QString unit = unitOfGate(metric.differenceUnit);
  table.setItem(row, GateMetricColumn, metricCell(metric.label));
  table.item(row, GateMetricColumn)->setToolTip(QString::fromStdString(metric.label));
  table.setItem(row, GateBase, studyCell(gateValue(metric, metric.base), false));
  table.setItem(row, GateCandidate, studyCell(gateValue(metric, metric.candidate), false));
  table.setItem(row, GateChange,
                metric.isMeasured ? differenceCell(metric.difference, metric.interval,
                                                   kMarginsShown * metric.margin, unit, 1.0,
                                                   {marginPlace(metric)})
                                  : studyCell(OutputPage::tr("–"), false));
  const QString margin =
      QString::fromStdString(base::formatDecimals(std::round(1e6 * metric.margin) / 1e6, 0));
  table.setItem(row, GateMargin,
                studyCell(unit.isEmpty() ? margin : margin + QLatin1Char(' ') + unit, false));
  QTableWidgetItem* word = studyCell(verdictWord(metric), true);
  word->setForeground(theme.color(roleOf(metric)));
  table.setItem(row, GateWord, word);
  table.setItem(row, GateWord + 1, studyCell(QString::number(metric.pairs), false));
}

QTableWidget* gateMetricsTable(const GateOutput& output, const editor::Theme& theme) {
  auto* table = new QTableWidget;
  styleStudyTable(*table, OutputPage::tr("Metrics"));
  setStudyColumns(*table,
                  {OutputPage::tr("Metric"), OutputPage::tr("Base"), OutputPage::tr("Candidate"),
                   OutputPage::tr("Difference"), OutputPage::tr("Margin"),
                   OutputPage::tr("Verdict"), OutputPage::tr("Pairs")},
                  {GateMetricColumn, GateWord});
  table->setRowCount(static_cast<int>(output.metrics.size()));
  int row = 0;
  for (const GateOutput::Metric& metric : output.metrics) {
    fillGateRow(*table, row++, metric, theme);
  }
  widenColumns(*table);
  return table;
}

/// Metrics of a gate, and pairs of runs in which the candidate is worse.
class GatePage : public OutputPage {
  Q_DECLARE_TR_FUNCTIONS(app::GatePage)
 public:
  GatePage(const GateOutput& output, const OutputPlace& place) : output_(output) {
    QStringList note = {
        tr("Base and candidate: means of the runs with a value. Difference candidate − base: mean "
           "over the pairs with its interval, which holds at all numbers of pairs; one pair counts "
           "at most 10 margins. The scale has 4 margins at both ends; the dotted line is the "
           "margin.")};
    for (const std::string& remark : output.remarks) {
      note.append(QString::fromStdString(remark));
    }
    addPage(tr("Metrics"),
            pageWithNote(gateMetricsTable(output, place.theme), note.join(QLatin1Char('\n'))));
    addPage(tr("Pairs"), output.findings.empty()
                             ? static_cast<QWidget*>(editor::emptyState(
                                   tr("There is no pair in which only the candidate failed, and "
                                      "all metrics passed."),
                                   this))
                             : makePairs());
  }

 private:
  QWidget* makePairs() {
    pairs_ = studyList(tr("Pairs in which the candidate is worse"),
                       {tr("Scenario"), tr("Seed"), tr("Candidate")}, {0, 2});
    pairs_->setRowCount(static_cast<int>(output_.findings.size()));
    int row = 0;
    for (const GateOutput::Finding& finding : output_.findings) {
      pairs_->setItem(row, 0, studyCell(QString::fromStdString(finding.scenario), true));
      pairs_->setItem(row, 1, studyCell(QString::number(finding.seed), false));
      QTableWidgetItem* what = studyCell(QString::fromStdString(finding.what), true);
      what->setToolTip(QString::fromStdString(finding.playCandidate));
      pairs_->setItem(row++, 2, what);
    }
    pairs_->horizontalHeader()->setStretchLastSection(true);
    widenColumns(*pairs_);
    setPlayable(*pairs_, tr("Double-click a pair to play the run of the candidate"),
                [this](int each) { play(each, true); });
    pairs_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(pairs_, &QWidget::customContextMenuRequested, this, &GatePage::showMenu);
    return pageWithNote(pairs_,
                        tr("Runs in which only the candidate fails, then the largest losses by "
                           "metrics that are not passed. Double-click or Enter plays the run of "
                           "the candidate, the context menu also that of the base."));
  }

  void play(int row, bool candidate) {
    const GateOutput::Finding& finding = output_.findings[static_cast<std::size_t>(row)];
    const QString place =
        tr("%1, seed %2").arg(QString::fromStdString(finding.scenario)).arg(finding.seed);
    Q_EMIT playRequested(
        {candidate ? finding.playCandidate : finding.playBase,
         candidate ? tr("the candidate in %1").arg(place) : tr("the base in %1").arg(place)});
  }

  void showMenu(const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QTableWidgetItem* item = pairs_->itemAt(at);
    const int row = item != nullptr ? item->row() : pairs_->currentRow();
    if (row >= 0) {
      menu->addAction(tr("Play the candidate"), this, [this, row] { play(row, true); });
      menu->addAction(tr("Play the base"), this, [this, row] { play(row, false); });
      menu->addSeparator();
    }
    editor::addTableActions(*menu, *pairs_, pairs_->accessibleName());
    menu->popup(pairs_->viewport()->mapToGlobal(at));
  }

  const GateOutput output_;
  QTableWidget* pairs_ = nullptr;  // none: no pairs are listed
};

QStringList worseTitles(const GateOutput& output) {
  QStringList titles;
  for (const GateOutput::Metric& metric : output.metrics) {
    if (metric.isMeasured && metric.verdict == GateVerdict::Worse) {
      titles.append(outputMetricTitle(metric.label, false));
    }
  }
  return titles;
}

}  // namespace

OutputPage* makeGatePage(const report::GateOutput& output, const OutputPlace& place) {
  return new GatePage(output, place);
}

QString gateHeadline(const report::GateOutput& output) {
  const QString base = QString::fromStdString(output.base);
  const QString candidate = QString::fromStdString(output.candidate);
  switch (output.verdict) {
    case GateVerdict::Pass:
      return OutputPage::tr("Pass: %1 is not worse than %2").arg(candidate, base);
    case GateVerdict::Worse:
      return OutputPage::tr("Worse: %1 is worse than %2 in %3")
          .arg(candidate, base, worseTitles(output).join(QStringLiteral(", ")));
    case GateVerdict::Undecided:
      break;
  }
  return OutputPage::tr("Undecided: %1 pairs do not show whether %2 is worse than %3")
      .arg(output.pairs)
      .arg(candidate, base);
}

}  // namespace app
