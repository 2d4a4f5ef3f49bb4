#include <cmath>
#include <map>

#include "app/report/Markup.h"
#include "app/report/Sensitivity.h"
#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/runs/ScatterPlot.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using report::SensitivityOutput;

QString percentOf(double share) {
  return QString::fromStdString(report::percentText(share));
}

/// The last part of each path if it is unique among the factors, otherwise the path.
std::map<std::string, QString> shortNames(const SensitivityOutput::Result& result) {
  std::map<std::string, int> counts;
  const auto lastPart = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
  for (const SensitivityOutput::Factor& factor : result.factors) {
    ++counts[lastPart(factor.path)];
  }
  std::map<std::string, QString> names;
  for (const SensitivityOutput::Factor& factor : result.factors) {
    const std::string last = lastPart(factor.path);
    names[factor.path] = QString::fromStdString(counts[last] > 1 ? factor.path : last);
  }
  return names;
}

/// Why a result is not certain.
QStringList uncertainties(const SensitivityOutput& output,
                          const SensitivityOutput::Result& result) {
  std::map<std::string, QString> names = shortNames(result);
  QStringList reasons;
  for (const std::string& path : result.wide) {
    reasons.append(
        OutputPage::tr("the confidence interval of %1 is wider than its index").arg(names[path]));
  }
  if (!std::isnan(result.required)) {
    reasons.append(OutputPage::tr("about %1 points would be needed instead of %2")
                       .arg(result.required)
                       .arg(output.points));
  }
  for (const auto& [first, second] : result.unordered) {
    reasons.append(
        OutputPage::tr("the order of %1 and %2 is not certain").arg(names[first], names[second]));
  }
  if (result.varies && result.seedShare > report::kLargeSeedShare) {
    reasons.append(OutputPage::tr("%1 of the variance between points is due to the choice of seeds")
                       .arg(percentOf(result.seedShare)));
  }
  if (result.undefinedPoints > 0) {
    reasons.append(OutputPage::tr("points without a value, which are excluded: %1")
                       .arg(result.undefinedPoints));
  }
  return reasons;
}

/// A value with its confidence interval as the tooltip.
QTableWidgetItem* estimateCell(double value, const statistics::Interval& interval) {
  QTableWidgetItem* cell = studyCell(outputNumber(value, interval), false);
  if (interval.isDefined()) {
    cell->setToolTip(
        OutputPage::tr("Confidence interval: %1 to %2")
            .arg(outputNumber(interval.low, interval), outputNumber(interval.high, interval)));
  }
  return cell;
}

QTableWidgetItem* barCell(double value, const statistics::Interval& interval, double scale,
                          double dark) {
  if (std::isnan(value)) {
    return studyCell(OutputPage::tr("–"), false);
  }
  QTableWidgetItem* cell = estimateCell(value, interval);
  cell->setData(kBarRole, QVariantList{value, interval.low, interval.high, scale, dark});
  return cell;
}

/// Ranked values of each metric and case, with the plane of mu* and sigma of Morris' method.
class SensitivityPage : public OutputPage {
  Q_DECLARE_TR_FUNCTIONS(app::SensitivityPage)
 public:
  SensitivityPage(const SensitivityOutput& output, const OutputPlace& place) : output_(output) {
    addPage(tr("Importance"), output.results.empty()
                                  ? static_cast<QWidget*>(editor::emptyState(
                                        tr("No metric varies in this study."), this))
                                  : makeImportance(place.theme));
    addPage(tr("Uncertain results"), makeUncertain());
  }

 private:
  QWidget* makeImportance(const editor::Theme& theme) {
    metrics_ = new editor::ChoiceField(this);
    cases_ = new editor::ChoiceField(this);
    table_ = new QTableWidget(this);
    plane_ = new editor::ScatterPlot(theme, tr("μ*–σ plot"), this);
    fillChoices();
    auto* content = new QWidget(this);
    auto* rows = editor::configuredLayout(new QVBoxLayout(content), {}, 0);
    rows->addLayout(makeChoices());
    rows->addWidget(makeHalves(), 1);
    connect(metrics_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            [this] { showResult(); });
    connect(cases_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            [this] { showResult(); });
    connectPlane();
    showResult();
    return pageWithNote(content, note());
  }

  void fillChoices() {
    for (const SensitivityOutput::Result& result : output_.results) {
      const QString key = QString::fromStdString(result.metric);
      if (metrics_->findData(key) < 0) {
        metrics_->addItem(outputMetricTitle(result.metric), key);
      }
      const QString name = QString::fromStdString(result.of);
      if (cases_->findData(name) < 0) {
        cases_->addItem(name, name);
      }
    }
    for (QComboBox* choice : {metrics_, cases_}) {
      choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
      choice->setCurrentIndex(0);
    }
  }

  QLayout* makeChoices() {
    metrics_->setAccessibleName(tr("Metric"));
    cases_->setAccessibleName(tr("Case"));
    cases_->setToolTip(tr("Scenario and listed values"));
    auto* row = editor::configuredLayout(new QHBoxLayout, {12, 6, 12, 6}, 8);
    row->addWidget(new QLabel(tr("Metric"), this));
    row->addWidget(metrics_);
    row->addWidget(new QLabel(tr("Case"), this));
    row->addWidget(cases_);
    row->addStretch();
    return row;
  }

  QWidget* makeHalves() {
    styleStudyTable(*table_, tr("Importance"));
    table_->verticalHeader()->setDefaultSectionSize(editor::kListRowHeight);
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->setChildrenCollapsible(false);
    halves->addWidget(table_);
    halves->addWidget(plane_);
    halves->setStretchFactor(0, 2);
    halves->setStretchFactor(1, 1);
    plane_->setMinimumWidth(kLeastPlane);
    plane_->setVisible(output_.isMorris);
    return halves;
  }

  /// Rows and points have the same order.
  void connectPlane() {
    connect(table_, &QTableWidget::currentCellChanged, plane_,
            [this](int row) { plane_->setCurrent(row); });
    connect(plane_, &editor::ScatterPlot::pointClicked, table_,
            [this](int point) { table_->setCurrentCell(point, 0); });
  }

  QString note() const {
    QString text =
        output_.isMorris
            ? tr("μ*: mean size of the change of the metric if the value goes from one end of its "
                 "range to the other. σ: standard deviation of these changes; on the dashed lines "
                 "it is 0.1, 0.5 and 1 times μ*. Lines on the bars: bootstrap confidence intervals "
                 "(%1).")
            : tr("Total: share of the variance of the metric that is due to the value and its "
                 "interactions; first order (dark): due to the value alone. Lines on the bars: "
                 "bootstrap confidence intervals (%1).");
    text = text.arg(percentOf(output_.level));
    QStringList constant;
    for (const std::string& key : output_.constantMetrics) {
      constant.append(outputMetricTitle(key, false));
    }
    return constant.isEmpty()
               ? text
               : text + QLatin1Char('\n') +
                     tr("Metrics that do not vary: %1").arg(constant.join(QStringLiteral(", ")));
  }

  const SensitivityOutput::Result* chosenResult() const {
    const std::string metric = metrics_->currentData().toString().toStdString();
    const std::string name = cases_->currentData().toString().toStdString();
    for (const SensitivityOutput::Result& result : output_.results) {
      if (result.metric == metric && result.of == name) {
        return &result;
      }
    }
    return nullptr;
  }

  void showResult() {
    const SensitivityOutput::Result* result = chosenResult();
    const bool hasValues = result != nullptr && result->varies;
    table_->clear();
    table_->setRowCount(0);
    resetColumns(*table_);
    QStringList titles = {tr("Value"), tr("Range")};
    titles += output_.isMorris ? QStringList{tr("μ*"), tr("μ"), tr("σ"), tr("Effects"), tr("Order")}
                               : QStringList{tr("Total"), tr("First order"), tr("Order")};
    setStudyColumns(*table_, titles, {0, 1});
    table_->horizontalHeaderItem(titles.size() - 1)
        ->setToolTip(tr("Share of the bootstrap resamples in which the value is before the next "
                        "one"));
    if (!hasValues) {
      table_->setRowCount(1);
      table_->setItem(0, 0, studyCell(tr("does not vary"), true));
      plane_->show({});
      widenColumns(*table_);
      return;
    }
    double scale = 0.0;
    for (const SensitivityOutput::Factor& factor : result->factors) {
      scale = reachOf(factor.importance, factor.importanceInterval, scale);
    }
    std::map<std::string, QString> names = shortNames(*result);
    for (const SensitivityOutput::Factor& factor : result->factors) {
      addFactor(factor, names[factor.path], scale);
    }
    widenColumns(*table_);
    showPlane(*result, names);
  }

  void addFactor(const SensitivityOutput::Factor& factor, const QString& name, double scale) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, 0, studyCell(name, true));
    table_->item(row, 0)->setToolTip(QString::fromStdString(factor.path));
    table_->setItem(row, 1,
                    studyCell(tr("%1 to %2")
                                  .arg(QString::fromStdString(base::formatDouble(factor.from)),
                                       QString::fromStdString(base::formatDouble(factor.to))),
                              true));
    int column = 2;
    const auto add = [&](QTableWidgetItem* item) { table_->setItem(row, column++, item); };
    add(barCell(factor.importance, factor.importanceInterval, scale,
                output_.isMorris ? 0.0 : factor.first));
    if (output_.isMorris) {
      add(studyCell(outputNumber(factor.mean), false));
      add(studyCell(outputNumber(factor.deviation), false));
      add(studyCell(QString::number(factor.effects), false));
    } else {
      add(estimateCell(factor.first, factor.firstInterval));
    }
    add(studyCell(std::isnan(factor.orderShare) ? QString() : percentOf(factor.orderShare), false));
  }

  void showPlane(const SensitivityOutput::Result& result, std::map<std::string, QString>& names) {
    if (!output_.isMorris) {
      return;
    }
    editor::PlottedPoints shown;
    shown.xTitle = tr("μ*");
    shown.yTitle = tr("σ");
    shown.slopes = {0.1, 0.5, 1.0};
    shown.isFromZero = true;
    for (const SensitivityOutput::Factor& factor : result.factors) {
      const double size = std::isnan(factor.importance) ? 0.0 : factor.importance;
      const double deviation = std::isnan(factor.deviation) ? 0.0 : factor.deviation;
      const QString name = names[factor.path];
      shown.points.push_back(
          {size, deviation, name,
           tr("%1: μ* %2, σ %3")
               .arg(name, outputNumber(size, factor.importanceInterval), outputNumber(deviation)),
           !std::isnan(factor.importance)});
    }
    plane_->show(std::move(shown));
  }

  QWidget* makeUncertain() {
    QTableWidget* table =
        studyList(tr("Uncertain results"), {tr("Metric"), tr("Case"), tr("Reason")}, {0, 1, 2});
    for (const SensitivityOutput::Result& result : output_.results) {
      for (const QString& reason : uncertainties(output_, result)) {
        const int row = table->rowCount();
        table->insertRow(row);
        table->setItem(row, 0, metricCell(result.metric, false));
        table->setItem(row, 1, studyCell(QString::fromStdString(result.of), true));
        table->setItem(row, 2, studyCell(editor::capitalized(reason), true));
        table->item(row, 2)->setToolTip(editor::capitalized(reason));
      }
    }
    if (table->rowCount() == 0) {
      delete table;
      return editor::emptyState(tr("All results are certain: points and seeds suffice."), this);
    }
    widenColumns(*table);
    table->horizontalHeader()->setStretchLastSection(true);
    return pageWithNote(table, tr("More points or seeds make these results certain."));
  }

  static constexpr int kLeastPlane = 260;  // [px]
  const SensitivityOutput output_;
  QComboBox* metrics_ = nullptr;
  QComboBox* cases_ = nullptr;
  QTableWidget* table_ = nullptr;
  editor::ScatterPlot* plane_ = nullptr;
};

}  // namespace

OutputPage* makeSensitivityPage(const report::SensitivityOutput& output, const OutputPlace& place) {
  return new SensitivityPage(output, place);
}

QString sensitivityHeadline(const report::SensitivityOutput& output) {
  const std::size_t values = output.results.empty() ? 0 : output.results.front().factors.size();
  const QString size =
      QStringList{editor::counted(values, OutputPage::tr("value"), OutputPage::tr("values")),
                  editor::counted(output.seeds, OutputPage::tr("seed"), OutputPage::tr("seeds")),
                  editor::counted(output.runs, OutputPage::tr("run"), OutputPage::tr("runs"))}
          .join(QStringLiteral(", "));
  return output.isMorris
             ? OutputPage::tr("Morris screening: %1 trajectories, %2").arg(output.points).arg(size)
             : OutputPage::tr("Sobol indices: %1 base points, %2").arg(output.points).arg(size);
}

}  // namespace app
