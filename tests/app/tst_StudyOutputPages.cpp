#include <QDesktopServices>
#include <QJsonArray>
#include <QSignalSpy>

#include "app/window/Docks.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyPanel.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/runs/ScatterPlot.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"
#include "tests/app/StudyOutputs.h"

Q_DECLARE_METATYPE(app::OutputRun)

using app::StudyPanel;
using editor::Role;
using editor::Theme;
using namespace outside;

namespace {

constexpr int kLong = 60000;  // [ms]

QString cell(const QTableWidget& table, int row, int column) {
  const QTableWidgetItem* item = table.item(row, column);
  return item == nullptr ? text("no cell") : item->text();
}

std::vector<double> numbersOf(const QTableWidget& table, int row, int column, int role) {
  std::vector<double> numbers;
  for (const QVariant& each : table.item(row, column)->data(role).toList()) {
    numbers.push_back(each.toDouble());
  }
  return numbers;
}

void doubleClick(const QTableWidget& table, int row, int column) {
  const QPoint at = table.visualItemRect(table.item(row, column)).center();
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, at);
}

}  // namespace

/// The results of tune, gate, sensitivity and search in the study panel.
class StudyOutputPagesTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  StudyPanel& panel() { return window_->docks().panel<StudyPanel>(); }
  /// As File > Open run… and a drop do it.
  void open(const char* name, const char* file, const QByteArray& json) {
    window_->docks().show({text("study")});
    QVERIFY(window_->files().openFile(writeOutput(at(name), file, json)));
    QVERIFY(panel().outputPage() != nullptr);
  }
  QTableWidget& table(const char* name) {
    return quiet::part<QTableWidget>(*panel().outputPage(), name);
  }
  void showTab(int tab) { panel().outputPage()->tabs().setCurrentIndex(tab); }

 private Q_SLOTS:
  void initTestCase() {
    qRegisterMetaType<app::OutputRun>("app::OutputRun");
    editor::applyTheme(Theme::light());
  }
  void init() {
    begin();
    QVERIFY(window_->open(copyOfDemo()));
    panel().process().setProgram(text(HUNAVSIM_PROGRAM));
  }
  void cleanup() { end(); }

  /// The verdict in words; the margin is on the side on which the candidate is worse.
  void gate_showsVerdictAndMargins() {
    open("gate", "gate.json", kGateOutput);
    QCOMPARE(panel().message(), text("Worse: dwa is worse than pursuit in Time to reach the goal"));
    const QTableWidget& metrics = table("Metrics");
    QCOMPARE(metrics.rowCount(), 3);
    QCOMPARE(cell(metrics, 1, 0), text("Time to reach the goal [s]"));
    QCOMPARE(numbersOf(metrics, 0, 3, app::kIntervalRole),  // higher is better
             (std::vector<double>{-2.0, 12.5, 27.0, -20.0, 20.0, 0.0, -5.0}));
    QCOMPARE(numbersOf(metrics, 1, 3, app::kIntervalRole),  // lower is better
             (std::vector<double>{10.0, 20.0, 30.0, -20.0, 20.0, 0.0, 5.0}));
    QVERIFY2(cell(metrics, 1, 3).startsWith(text("+20 [10, 30] %")),
             qPrintable(cell(metrics, 1, 3)));
    QCOMPARE(cell(metrics, 0, 1), text("87.5 %"));
    QCOMPARE(cell(metrics, 0, 4), text("5 points"));
    QCOMPARE(cell(metrics, 0, 5), text("pass"));
    QCOMPARE(cell(metrics, 1, 5), text("worse"));
    QCOMPARE(cell(metrics, 2, 5), text("not measured"));
    QVERIFY(isSaid(text("a remark")) ||
            widgets::findIf<QLabel>(*panel().outputPage(), [](const QLabel* label) {
              return label->text().endsWith(text("\na remark"));
            }) != nullptr);
    quiet::shoot(*window_, "output-gate");
  }

  /// The run of the candidate; its scenario is beside the folder of the results.
  void gatePair_doubleClicked_isPlayed() {
    writeText(at("yard.yaml"), kYardText);
    open("gate", "gate.json", kGateOutput);
    showTab(1);
    const QTableWidget& pairs = table("Pairs in which the candidate is worse");
    QCOMPARE(cell(pairs, 1, 2), text("Time to reach the goal [s]: 16.0 to 24.0"));
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    doubleClick(pairs, 0, 2);
    QVERIFY2(panel().message().contains(text("yard, seed 7")), qPrintable(panel().message()));
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
    const QString folder = played.front().front().toString();
    QVERIFY(played.front().at(1).toBool());  // temporary
    const QJsonObject manifest = readJson(folder + text("/manifest.json"));
    QCOMPARE(manifest.value(text("seed")).toInt(), 7);
    QVERIFY(window_->workspace().runner().isRecorded());
    QVERIFY(panel().message().startsWith(text("Worse: ")));  // the verdict again
  }

  /// Enter plays the current row; the menu also plays the base.
  void gatePair_byKeyboard_isPlayed() {
    writeText(at("yard.yaml"), kYardText);
    open("gate", "gate.json", kGateOutput);
    showTab(1);
    QTableWidget& pairs = table("Pairs in which the candidate is worse");
    QSignalSpy wanted(panel().outputPage(), &app::OutputPage::playRequested);
    pairs.setFocus();
    QTest::keyClick(&pairs, Qt::Key_Down);
    QTest::keyClick(&pairs, Qt::Key_Return);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().value<app::OutputRun>().command,
             std::string("hunavsim yard.yaml --seed 9 --duration 2 --planner dwa"));
    Q_EMIT pairs.customContextMenuRequested(pairs.visualItemRect(pairs.item(0, 0)).center());
    QAction* base = widgets::withText<QAction>(*panel().outputPage(), text("Play the base"));
    QVERIFY(base != nullptr);
    base->trigger();
    QCOMPARE(wanted.back().front().value<app::OutputRun>().command,
             std::string("hunavsim yard.yaml --seed 7 --duration 1 --planner pursuit"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().runner().isRecorded(), kLong);
  }

  void tune_showsEvaluationParametersAndFront() {
    const QString folder = writeOutput(at("tune"), "tune.json", kTuneOutput);
    writeText(folder + text("/changes.diff"), "--- a\n+++ b\n-x: 1\n+x: 2\n");
    open("tune", "tune.json", kTuneOutput);
    QVERIFY2(panel().message().startsWith(text("No improvement found")),
             qPrintable(panel().message()));
    const QTableWidget& evaluation = table("Evaluation");
    QCOMPARE(evaluation.rowCount(), 6);  // success and two metrics, of all and of the scenario
    QCOMPARE(cell(evaluation, 0, 2), text("50 %"));
    // One scale for the metric in all scenarios: the largest end of an interval is 8.
    QCOMPARE(numbersOf(evaluation, 1, 4, app::kIntervalRole),
             (std::vector<double>{-4.0, -2.0, 1.0, -8.0, 8.0, 0.0}));
    for (int row = 3; row < evaluation.rowCount(); ++row) {
      QCOMPARE(cell(evaluation, row, 0), text("hall"));
      QCOMPARE(evaluation.item(row, 0)->toolTip(), text("/somewhere/hall.yaml"));
    }
    const QTableWidget& parameters = table("Parameters");
    QCOMPARE(parameters.rowCount(), 3);
    QCOMPARE(cell(parameters, 0, 3), text("0.9"));  // tried, and not in the file
    QCOMPARE(cell(parameters, 0, 4), text("no"));
    QCOMPARE(cell(parameters, 1, 4), text("yes"));
    QVERIFY(parameters.item(1, 3)->font().bold());
    QCOMPARE(cell(parameters, 2, 4), text("unchanged"));
    auto& diff = quiet::part<QPlainTextEdit>(*panel().outputPage(), "Changes");
    QCOMPARE(diff.toPlainText(), text("--- a\n+++ b\n-x: 1\n+x: 2\n"));
    quiet::shoot(*window_, "output-tune");
  }

  void tune_withoutCandidates_saysWhy() {
    QJsonObject tune = QJsonDocument::fromJson(kTuneOutput).object();
    tune[text("verdict")] = text("no candidate");
    tune[text("evaluation")] = QJsonValue();
    tune[text("candidates")] = QJsonArray{tune[text("candidates")].toArray().first()};
    open("tune", "tune.json", QJsonDocument(tune).toJson());
    QCOMPARE(panel().message(), text("Nothing tried: the limit of runs (--runs) is too small"));
  }

  /// Points and rows select each other. Changes: +25 and -50 %, -25 and -12.5 %.
  void tuneFront_pointClicked_selectsItsRow() {
    open("tune", "tune.json", kTuneOutput);
    showTab(2);
    QTableWidget& front = table("Candidates on the front");
    QCOMPARE(front.rowCount(), 2);
    QCOMPARE(cell(front, 0, 2), text("stop_distance 0.3"));
    auto& plane = quiet::part<editor::ScatterPlot>(*panel().outputPage(), "Pareto front");
    const std::vector<editor::PlottedPoint>& points = plane.shown().points;
    QCOMPARE(points.size(), std::size_t{3});
    QCOMPARE(points[1].x, 25.0);
    QCOMPARE(points[1].y, -50.0);
    QCOMPARE(points[0].name, text("before"));
    QCOMPARE(points[2].name, text("chosen"));
    QCOMPARE(plane.shown().line, (std::vector<QPointF>{{-25.0, -12.5}, {25.0, -50.0}}));
    QTRY_VERIFY(plane.isVisible() && plane.width() > 200);
    auto* canvas = plane.childAt(plane.placeOf(2));
    QVERIFY(canvas != nullptr);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->mapFrom(&plane, plane.placeOf(2)));
    QCOMPARE(front.currentRow(), 1);
    QCOMPARE(plane.current(), 2);
    front.setCurrentCell(0, 0);
    QCOMPARE(plane.current(), 1);
    showTab(3);
    QVERIFY(isSaid(text("The file is unchanged.")));
    quiet::shoot(*window_, "output-front");
  }

  void sensitivity_showsBarsPlaneAndDoubts() {
    open("morris", "sensitivity.json", kMorrisOutput);
    QCOMPARE(panel().message(),
             text("Morris screening: 4 trajectories, 2 values, 2 seeds, 24 runs"));
    QTableWidget& bars = table("Importance");
    QCOMPARE(cell(bars, 0, 0), text("max_vel"));
    QCOMPARE(numbersOf(bars, 0, 2, app::kBarRole), (std::vector<double>{2.5, 1.5, 4.0, 4.0, 0.0}));
    QCOMPARE(numbersOf(bars, 1, 2, app::kBarRole)[3], 4.0);  // one scale
    auto& plane = quiet::part<editor::ScatterPlot>(*panel().outputPage(), "μ*–σ plot");
    QCOMPARE(plane.shown().points[1].x, 0.5);
    QCOMPARE(plane.shown().points[1].y, 0.125);
    bars.setCurrentCell(1, 0);
    QCOMPARE(plane.current(), 1);
    quiet::shoot(*window_, "output-morris");
    quiet::part<QComboBox>(*panel().outputPage(), "Metric").setCurrentIndex(1);
    QCOMPARE(cell(bars, 0, 0), text("radius"));
    const QTableWidget& doubts = table("Uncertain results");
    QCOMPARE(doubts.rowCount(), 5);  // interval, points, order, seeds, points without a value
    QVERIFY2(cell(doubts, 1, 2).contains(text("12")), qPrintable(cell(doubts, 1, 2)));
  }

  void sobol_hasNoPlane() {
    open("sobol", "sensitivity.json", kSobolOutput);
    const QTableWidget& bars = table("Importance");
    QCOMPARE(numbersOf(bars, 0, 2, app::kBarRole),
             (std::vector<double>{0.75, 0.5, 1.0, 1.0, 0.25}));
    auto& plane = quiet::part<editor::ScatterPlot>(*panel().outputPage(), "μ*–σ plot");
    QVERIFY(!plane.isVisible());
    showTab(1);
    QVERIFY(isSaid(text("All results are certain: points and seeds suffice.")));
  }

  void search_showsFailuresAndArchive() {
    open("search", "archive.json", kSearchOutput);
    const QTableWidget& failures = table("Failures");
    QCOMPARE(cell(failures, 0, 0), text("Contact · person on the left · moving"));
    QCOMPARE(cell(failures, 1, 0), text("Standstill · no person near"));
    QCOMPARE(cell(failures, 0, 3), text("1 of 5"));
    QCOMPARE(cell(failures, 0, 6), text("robot1.max_vel=0.9, variation.preset=none"));
    QCOMPARE(cell(failures, 1, 6), text("none"));
    QCOMPARE(cell(failures, 1, 7), text("no"));
    QVERIFY(panel().message().startsWith(text("31 runs, 2 kinds of failures")));
    quiet::shoot(*window_, "output-search");
    showTab(1);
    const QTableWidget& archive = table("Archive");
    QCOMPARE(archive.rowCount(), 3);
    QCOMPARE(archive.columnCount(), 3);
    QCOMPARE(cell(archive, 0, 2), text("●"));  // the last cell of both
    QCOMPARE(cell(archive, 1, 0), QString());  // undefined, first
    QVERIFY(archive.item(1, 0) != nullptr && archive.item(2, 0) == nullptr);
    QCOMPARE(archive.verticalHeaderItem(0)->text(), text("2.0"));
    // The best run is the darkest.
    QCOMPARE(archive.item(0, 2)->data(app::kHeatRole).toDouble(), 1.0);
    QCOMPARE(archive.item(1, 0)->data(app::kHeatRole).toDouble(), 0.0);
    quiet::shoot(*window_, "output-archive");
  }

  /// A failure of the list, and of its kind in the archive.
  void failure_doubleClicked_isPlayed() {
    QVERIFY(QDir().mkpath(at("search/failures")));
    writeText(at("search/failures/contact-left-moving.yaml"),
              QByteArray(kYardText) + "    duration: 1.0\n");
    open("search", "archive.json", kSearchOutput);
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    doubleClick(table("Failures"), 0, 0);
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
    QVERIFY(window_->workspace().runner().isRecorded());
    QVERIFY(panel().outputPage() != nullptr);  // the list stays
    showTab(1);
    doubleClick(table("Archive"), 0, 2);
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 2, kLong);
    // The scenario of the other failure is missing.
    showTab(0);
    QTableWidget& failures = table("Failures");
    failures.setFocus();
    failures.setCurrentCell(1, 0);
    QTest::keyClick(&failures, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(panel().message().contains(text("standstill-no-person.yaml")) &&
                                 !panel().message().contains(text("Replaying")),
                             kLong);
    QCOMPARE(played.count(), 2);
  }

  void coverage_showsTreesAndPlaysRuns() {
    writeText(at("yard.yaml"), kYardText);
    open("cover", "archive.json", kCoverOutput);
    QCOMPARE(panel().message(), text("6 of 8 nodes of behaviour trees were reached in 12 runs. "
                                     "Nodes that cannot be reached: 1"));
    const QTableWidget& trees = table("Trees");
    QCOMPARE(numbersOf(trees, 0, 4, app::kBarRole)[0], 3.0);
    QCOMPARE(numbersOf(trees, 0, 4, app::kBarRole)[3], 5.0);
    QCOMPARE(cell(trees, 1, 4), text("3 of 3"));
    QCOMPARE(cell(table("Never reached"), 0, 2), text("Main/Fallback/Run"));
    quiet::shoot(*window_, "output-cover");
    showTab(2);
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    doubleClick(table("Runs"), 0, 1);
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
  }

  void worstRun_isTheFirstRow() {
    open("worst", "archive.json", kWorstOutput);
    const QTableWidget& worst = table("Worst run");
    QCOMPARE(worst.rowCount(), 1);
    QVERIFY2(cell(worst, 0, 0).contains(text("0.25")), qPrintable(cell(worst, 0, 0)));
    QVERIFY2(panel().message().contains(text("0.25")), qPrintable(panel().message()));
    showTab(1);
    QVERIFY(isSaid(text("The archive is empty: no run was simulated.")));
  }

  /// External programs of a failure are not started without permission.
  void failure_withExternalProgram_asksFirst() {
    QVERIFY(QDir().mkpath(at("search/failures")));
    QByteArray yard = QByteArray(kYardText) + "    duration: 1.0\n";
    yard.replace("    robot1:\n",
                 "    robot1:\n      planner: external\n      command: \"true\"\n");
    writeText(at("search/failures/contact-left-moving.yaml"), yard);
    open("search", "archive.json", kSearchOutput);
    std::size_t asked = 0;
    const QObject receiver;  // connected while this test runs
    connect(&panel(), &StudyPanel::codePermissionNeeded, &receiver,
            [&asked](const std::vector<app::ExternalCode>& code) { asked = code.size(); });
    doubleClick(table("Failures"), 0, 0);
    QCOMPARE(asked, std::size_t{1});
    QVERIFY2(panel().message().contains(text("external programs")), qPrintable(panel().message()));
    QVERIFY(!told("study-code").text.isEmpty());
  }

  /// Colours follow the theme, the tab stays.
  void theme_changed_keepsTheTab() {
    open("gate", "gate.json", kGateOutput);
    QCOMPARE(table("Metrics").item(1, 5)->foreground().color(), Theme::light().color(Role::Error));
    showTab(1);
    window_->setTheme(Theme::dark());
    QCOMPARE(panel().outputPage()->tabs().currentIndex(), 1);
    QCOMPARE(table("Metrics").item(1, 5)->foreground().color(), Theme::dark().color(Role::Error));
    quiet::shoot(*window_, "output-dark");
    window_->setTheme(Theme::light());
  }

  /// "New" returns to experiments; results cannot be started.
  void newStudy_afterResults_showsTheForm() {
    open("gate", "gate.json", kGateOutput);
    QVERIFY(!panel().form().isVisible());
    auto& start = *widgets::withText<QPushButton>(panel(), text("Start"));
    QTest::qWait(500);  // the form is checked after 300 ms
    QVERIFY(!start.isEnabled());
    QCOMPARE(panel().shownName(), text("gate"));
    QTest::mouseClick(widgets::withText<QAbstractButton>(panel(), text("New")), Qt::LeftButton);
    QVERIFY(panel().outputPage() == nullptr);
    QVERIFY(panel().form().isVisible());
    QTRY_VERIFY(start.isEnabled());
  }

  /// The page of the folder, without another process.
  void report_opensThePageOfTheFolder() {
    open("gate", "gate.json", kGateOutput);
    opened_.clear();
    QDesktopServices::setUrlHandler(text("file"), this, "take");
    QTest::mouseClick(widgets::withText<QPushButton>(panel(), text("Report")), Qt::LeftButton);
    QDesktopServices::unsetUrlHandler(text("file"));
    QCOMPARE(opened_, QStringList(at("gate/gate.html")));
  }

  /// Dropped on the form, which otherwise takes scenarios.
  void droppedOnTheForm_isShown() {
    window_->docks().show({text("study")});
    const QString folder = writeOutput(at("gate"), "gate.json", kGateOutput);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(folder)});
    const QStringList before = panel().form().scenarios();
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&panel().form(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&panel().form(), &drop);
    QTRY_VERIFY(panel().outputPage() != nullptr);
    QCOMPARE(panel().form().scenarios(), before);
  }

  /// The document is not replaced, so unsaved changes are no obstacle.
  void droppedOnTheWindow_keepsTheDocument() {
    const QString open = document().path();
    const QString folder = writeOutput(at("gate"), "gate.json", kGateOutput);
    QVERIFY(window_->files().dropFile(folder, {}));
    QTRY_VERIFY(panel().isVisible());
    QCOMPARE(document().path(), open);
    QVERIFY(panel().outputPage() != nullptr);
  }

  /// On the start page a new scenario is opened, because panels need one.
  void openedOnTheStartPage_leavesIt() {
    window_->files().close();
    QVERIFY(!panel().isVisible());
    QVERIFY(window_->open(writeOutput(at("gate"), "gate.json", kGateOutput)));
    QTRY_VERIFY(panel().isVisible());
    QVERIFY(panel().outputPage() != nullptr);
  }

  /// Damaged results are a problem of their file, and what was shown stays.
  void damaged_isReported() {
    open("gate", "gate.json", kGateOutput);
    QVERIFY(!window_->files().openFile(writeOutput(at("bad"), "tune.json", "{}")));
    QCOMPARE(std::string(window_->files().problems().front().code),
             std::string("study.bad-output"));
    QCOMPARE(panel().shownName(), text("gate"));
    QVERIFY(!panel().openFile(at("bad")));
    QVERIFY2(panel().message().contains(text("damaged")), qPrintable(panel().message()));
  }

 public Q_SLOTS:
  void take(const QUrl& url) { opened_.append(url.toLocalFile()); }

 private:
  QStringList opened_;
};

QTEST_MAIN(StudyOutputPagesTest)
#include "tst_StudyOutputPages.moc"
