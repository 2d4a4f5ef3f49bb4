#include "app/window/study/OutputPage.h"

#include <algorithm>
#include <cmath>

#include "app/report/Comparison.h"
#include "app/report/Markup.h"
#include "app/run/ResultRow.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/CoreText.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"

namespace app {

namespace {

/// The page of each kind of results.
struct PageMaker {
  const OutputPlace& place;
  OutputPage* operator()(const report::TuneOutput& of) const { return makeTunePage(of, place); }
  OutputPage* operator()(const report::GateOutput& of) const { return makeGatePage(of, place); }
  OutputPage* operator()(const report::SensitivityOutput& of) const {
    return makeSensitivityPage(of, place);
  }
  OutputPage* operator()(const report::SearchOutput& of) const { return makeSearchPage(of, place); }
  OutputPage* operator()(const report::CoverOutput& of) const { return makeCoverPage(of, place); }
};

struct HeadlineMaker {
  QString operator()(const report::TuneOutput& of) const { return tuneHeadline(of); }
  QString operator()(const report::GateOutput& of) const { return gateHeadline(of); }
  QString operator()(const report::SensitivityOutput& of) const { return sensitivityHeadline(of); }
  QString operator()(const report::SearchOutput& of) const { return searchHeadline(of); }
  QString operator()(const report::CoverOutput& of) const { return coverHeadline(of); }
};

}  // namespace

OutputPage::OutputPage(QWidget* parent) : QWidget(parent) {
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  auto* strip = new QWidget(this);
  strip->setAutoFillBackground(true);
  strip->setBackgroundRole(QPalette::Window);
  editor::configuredLayout(new QHBoxLayout(strip), {}, 0, {tabs_})->addStretch();
  editor::configuredLayout(new QVBoxLayout(this), {}, 0, {strip})->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, pages_, &QStackedWidget::setCurrentIndex);
}

void OutputPage::addPage(const QString& title, QWidget* page) {
  pages_->addWidget(page);
  tabs_->addTab(title);
}

OutputPage* makeOutputPage(const report::StudyOutput& output, const OutputPlace& place) {
  return std::visit(PageMaker{place}, output);
}

QString outputHeadline(const report::StudyOutput& output) {
  return std::visit(HeadlineMaker(), output);
}

QString outputMetricTitle(const std::string& label, bool withUnit) {
  const std::size_t above = label.find('>');
  const std::string key = label.substr(0, above);
  const std::optional<ColumnInfo> info = columnInfo(key);
  QString title = info ? editor::coreText(info->name) : QString::fromStdString(key);
  if (above != std::string::npos && label.substr(above + 1) != "0") {
    title = OutputPage::tr("%1 (more than %2)")
                .arg(title, QString::fromStdString(label.substr(above + 1)));
  }
  const bool hasUnit = withUnit && info && !info->unit.empty() && info->unit != "-";
  return hasUnit ? QStringLiteral("%1 [%2]").arg(title, QString::fromStdString(info->unit)) : title;
}

QTableWidgetItem* metricCell(const std::string& label, bool withUnit) {
  QTableWidgetItem* cell = studyCell(outputMetricTitle(label, withUnit), true);
  cell->setData(editor::kSavedKeyRole, QString::fromStdString(label));
  return cell;
}

QString outputNumber(double value, const statistics::Interval& interval) {
  const int decimals = std::isnan(value) ? 0 : report::decimalsFor(value, interval);
  return QString::fromStdString(report::numberText(value, decimals));
}

QTableWidgetItem* differenceCell(double difference, const statistics::Interval& interval,
                                 double reach, const QString& unit, double factor,
                                 const std::vector<double>& marks) {
  if (std::isnan(difference)) {
    return studyCell(OutputPage::tr("–"), false);
  }
  const statistics::Interval scaled{factor * interval.low, factor * interval.high};
  const int decimals = report::decimalsFor(factor * difference, scaled);
  const std::string words = report::intervalText(interval, decimals, factor);
  QString text = QString::fromStdString(report::signedNumberText(factor * difference, decimals) +
                                        (words.empty() ? "" : " " + words));
  text += unit.isEmpty() ? QString() : QLatin1Char(' ') + unit;
  std::vector<double> all = {0.0};
  all.insert(all.end(), marks.begin(), marks.end());
  return intervalCell(text, difference, interval, -reach, reach, all);
}

double reachOf(double difference, const statistics::Interval& interval, double least) {
  double reach = least;
  for (const double end : {difference, interval.low, interval.high}) {
    reach = std::isnan(end) ? reach : std::max(reach, std::fabs(end));
  }
  return reach;
}

QString scenarioTitle(const std::string& path) {
  return QFileInfo(QString::fromStdString(path)).completeBaseName();
}

QWidget* pageWithNote(QWidget* content, const QString& note) {
  auto* page = new QWidget;
  auto* words = editor::secondaryLabel(note, page);
  words->setTextFormat(Qt::PlainText);
  words->setWordWrap(true);
  words->setContentsMargins(12, 4, 12, 6);
  words->setVisible(!note.isEmpty());
  auto* rows = editor::configuredLayout(new QVBoxLayout(page), {}, 0);
  rows->addWidget(content, 1);
  rows->addWidget(words);
  return page;
}

void setPlayable(QTableWidget& table, const QString& tip,
                 const std::function<void(int row)>& play) {
  table.setToolTip(tip);
  QObject::connect(&table, &QTableWidget::itemActivated, &table,
                   [play](const QTableWidgetItem* item) { play(item->row()); });
  if (table.rowCount() > 0) {
    table.selectRow(0);  // Enter plays it
  }
}

}  // namespace app
