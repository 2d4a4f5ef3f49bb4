#pragma once

#include <functional>

#include <QtWidgets>

#include "app/report/StudyOutput.h"
#include "editor/look/Theme.h"

namespace app {

/// A run of a study that is to be played.
struct OutputRun {
  /// The command line that opens it: "hunavsim FILE --seed 3 …". Relative paths start at the
  /// working directory, the folder of the results or a folder that contains it.
  std::string command;
  QString title;  // for messages
};

/// The results of `tune`, `gate`, `sensitivity` or `search`, on tabs. The page copies them. GUI
/// thread.
class OutputPage : public QWidget {
  Q_OBJECT
 public:
  explicit OutputPage(QWidget* parent = nullptr);

  QTabBar& tabs() const { return *tabs_; }

 Q_SIGNALS:
  void playRequested(const app::OutputRun& run);

 protected:
  /// Adds a tab. This page owns `page`.
  void addPage(const QString& title, QWidget* page);

 private:
  QTabBar* tabs_ = new QTabBar(this);
  QStackedWidget* pages_ = new QStackedWidget(this);
};

/// What a page needs beside the results.
struct OutputPlace {
  std::string folder;  // of the results
  editor::Theme theme;
};

/// The pages of the kinds of results, without a parent. Their colours are fixed: the pages are
/// recreated when the theme changes.
OutputPage* makeOutputPage(const report::StudyOutput& output, const OutputPlace& place);
OutputPage* makeTunePage(const report::TuneOutput& output, const OutputPlace& place);
OutputPage* makeGatePage(const report::GateOutput& output, const OutputPlace& place);
OutputPage* makeSensitivityPage(const report::SensitivityOutput& output, const OutputPlace& place);
OutputPage* makeSearchPage(const report::SearchOutput& output, const OutputPlace& place);
OutputPage* makeCoverPage(const report::CoverOutput& output, const OutputPlace& place);

/// The verdict or size of the results as a sentence.
QString outputHeadline(const report::StudyOutput& output);
QString tuneHeadline(const report::TuneOutput& output);
QString gateHeadline(const report::GateOutput& output);
QString sensitivityHeadline(const report::SensitivityOutput& output);
QString searchHeadline(const report::SearchOutput& output);
QString coverHeadline(const report::CoverOutput& output);

// Parts of pages.

/// The title of a metric, "Path length [m]"; of "KEY>NUMBER": "… (more than NUMBER)". `withUnit`
/// false: without the unit.
QString outputMetricTitle(const std::string& label, bool withUnit = true);
/// A cell with this title, and the label as its key in saved tables.
QTableWidgetItem* metricCell(const std::string& label, bool withUnit = true);
/// A number with the decimals that its interval requires.
QString outputNumber(double value, const statistics::Interval& interval = {});
/// A difference with its interval, "−0.5 [−0.8, −0.2] m", drawn around 0 up to `reach` at both
/// ends. The numbers of the text are multiplied by `factor` (100: shares in per cent). `marks`:
/// places of further vertical lines, such as a margin. NaN: a dash.
QTableWidgetItem* differenceCell(double difference, const statistics::Interval& interval,
                                 double reach, const QString& unit, double factor = 1.0,
                                 const std::vector<double>& marks = {});
/// The largest size of a difference or an end of its interval; at least `least`. NaN counts as
/// absent.
double reachOf(double difference, const statistics::Interval& interval, double least);
/// The name of a scenario file without folder and suffix.
QString scenarioTitle(const std::string& path);
/// A page with a note below the content.
QWidget* pageWithNote(QWidget* content, const QString& note);
/// Calls `play` with the row that is double-clicked or, with Enter, the current one; selects the
/// first row. `tip`: tooltip of the table.
void setPlayable(QTableWidget& table, const QString& tip, const std::function<void(int row)>& play);

}  // namespace app
