#include <QSignalSpy>

#include "app/window/Docks.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyPanel.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"

using app::StudyPanel;
using app::StudyRow;
using namespace outside;

namespace {

constexpr int kLong = 50000;  // [ms]

/// A row whose metric "path_length" has this value.
StudyRow rowOf(int run, double length, bool isOk = true) {
  StudyRow row;
  row.run = run;
  row.isOk = isOk;
  row.metrics = {{text("path_length"), length}, {text("success"), length < 13.0 ? 1.0 : 0.0}};
  return row;
}

QString estimateOf(const char* key, const std::vector<StudyRow>& rows) {
  std::vector<const StudyRow*> all;
  all.reserve(rows.size());
  for (const StudyRow& row : rows) {
    all.push_back(&row);
  }
  for (const app::StudyMetric& metric : app::studyMetrics()) {
    if (metric.key == text(key)) {
      return app::estimateText(metric, app::estimateOf(metric, all));
    }
  }
  return text("no such metric");
}

}  // namespace

/// Studies in the window: edited, run by the real program, watched, stopped, gone on with, played.
class StudyPanelTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  std::unique_ptr<StudyFolder> study_;

  StudyPanel& panel() { return window_->docks().panel<StudyPanel>(); }
  app::StudyForm& form() { return panel().form(); }
  template <class Part>
  Part& field(const char* name) {
    return quiet::part<Part>(panel(), name);
  }
  static QByteArray bytes(const QString& path) { return bytesOf(path); }
  QStringList recentFiles() {
    QMenu menu;
    window_->files().fillRecentMenu(menu);
    QStringList all;
    for (const QAction* each : menu.actions()) {
      all.append(each->toolTip());
    }
    return all;
  }
  void waitForEnd() { QTRY_VERIFY_WITH_TIMEOUT(!panel().isRunning(), kLong); }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(copyOfDemo()));
    study_ = std::make_unique<StudyFolder>();
    panel().process().setProgram(text(HUNAVSIM_PROGRAM));
  }
  void cleanup() { end(); }

  /// The program has ten panels, the last of them on Alt+0.
  void panels_eachHasAKeyOfItsOwn() {
    QStringList keys;
    for (const QDockWidget* dock : window_->docks().all()) {
      keys.append(window_->docks().toggleOf(*dock)->shortcut().toString());
    }
    QVERIFY(!keys.contains(QString()));
    keys.sort();
    QCOMPARE(keys.removeDuplicates(), 0);
  }

  /// In one column or in two: the list has no scroll bar.
  void planners_areAllInSightAtEveryWidth() {
    window_->docks().show({text("study")});
    const auto& planners = field<QListWidget>("Planners");
    QVERIFY(planners.count() > 4);
    for (const int width : {200, 320, 200}) {
      form().setFixedWidth(width);
      const QListWidgetItem* last = planners.item(planners.count() - 1);
      QTRY_VERIFY(planners.viewport()->rect().contains(planners.visualItemRect(last)));
      QTRY_COMPARE(planners.visualItemRect(planners.item(1)).left() > 100, width == 320);
    }
  }

  /// With two scenarios, in a window of the usual size.
  void form_isWholeInSight() {
    form().addScenario(document().path());
    form().addScenario(study_->path(text("yard.yaml")));
    window_->docks().show({text("study")});
    QCOMPARE(window_->size(), QSize(1280, 800));
    const QWidget& room = *form().parentWidget();
    const auto isInSight = [&room](const QWidget& part) {
      return room.rect().contains(QRect(part.mapTo(&room, {}), part.size()));
    };
    QTest::qWait(300);  // until all is in its place
    QVERIFY(isInSight(field<QComboBox>("Keep recordings")));
    QVERIFY(isInSight(field<QLineEdit>("Duration")));
    QVERIFY(isInSight(field<QPlainTextEdit>("Other parameters")));
    // Nor are names cut short.
    const auto& planners = field<QListWidget>("Planners");
    constexpr int kBox = 36;  // before a name, and behind it
    for (int row = 0; row < planners.count(); ++row) {
      const QListWidgetItem& item = *planners.item(row);
      QVERIFY2(planners.fontMetrics().horizontalAdvance(item.text()) + kBox <=
                   planners.visualItemRect(&item).width(),
               qPrintable(item.text()));
    }
    quiet::shoot(*window_, "study-form");
  }

  /// By hand: of the 27 resamples of 10, 12, 14 one has the mean 10 and one 14, 3.7 % each, more
  /// than the 2.5 % beyond an end; they lie evenly, so neither bias nor acceleration shifts them.
  void estimates_areThoseByHand() {
    const std::vector<StudyRow> rows = {rowOf(0, 10.0), rowOf(1, 12.0), rowOf(2, 14.0),
                                        rowOf(3, 900.0, false)};
    QCOMPARE(estimateOf("path_length", rows), text("12.0 [10.0, 14.0]"));
    // 2 of 4, Wilson: (0.5 + 1.9207 / 4 ± 1.95996 √(0.0625 + 3.8415 / 64)) / 1.9604 = 0.15, 0.85
    QCOMPARE(estimateOf("success", rows), text("50 % [15, 85]"));
    QCOMPARE(estimateOf("path_length", {rowOf(0, 10.0)}), text("10.0"));
    QCOMPARE(estimateOf("path_length", {rowOf(0, 10.0), rowOf(1, 10.0)}), text("10.0"));
    QCOMPARE(estimateOf("path_length", {}), QString());
  }

  /// Who scrolls the form over it changes nothing.
  void keep_wheelOverIt_isLeftAlone() {
    auto& keep = field<QComboBox>("Keep recordings");
    const int before = keep.currentIndex();
    const QPoint at = keep.rect().center();
    QWheelEvent down(at, keep.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&keep, &down);
    QCOMPARE(keep.currentIndex(), before);
    QVERIFY(before + 1 < keep.count());  // it could have
  }

  /// As in the report: a robot without a goal neither succeeds nor fails, a failed run fails.
  void success_undefined_countsForNothing() {
    const StudyRow without = [] {
      StudyRow row = rowOf(2, 10.0);
      row.metrics.erase(text("success"));
      return row;
    }();
    QCOMPARE(estimateOf("success", {without, without}), QString());
    StudyRow failed = without;
    failed.isOk = false;
    // 1 of 2, Wilson: (0.5 + 3.8415 / 4 ± 1.95996 √(0.125 + 3.8415 / 16)) / 2.9207 = 0.09, 0.91
    QCOMPARE(estimateOf("success", {without, rowOf(0, 10.0), failed}), text("50 % [9, 91]"));
    app::StudyResults results(nullptr);
    results.begin({}, {});
    results.add({without});
    QCOMPARE(results.comparison().item(0, 2)->text(), text("–"));
    QVERIFY(results.comparison().item(0, results.comparison().columnCount() - 1)->text() ==
            text("10.0"));
  }

  void time_ofOneRunOfThree_isShownWithItsCount() {
    StudyRow late = rowOf(1, 10.0);
    StudyRow without = rowOf(2, 11.0);
    late.metrics[text("time_to_reach_goal")] = 116.0;
    without.metrics.erase(text("time_to_reach_goal"));
    StudyRow another = without;
    another.run = 3;
    app::StudyResults results(nullptr);
    results.begin({}, {});
    const QTableWidget& table = results.comparison();
    QVERIFY(table.horizontalHeaderItem(2)->toolTip().contains(text("no contact with a person")));
    std::vector<int> widths;
    for (int column = 2; column < table.columnCount(); ++column) {
      widths.push_back(table.columnWidth(column));
    }
    results.add({late});
    QCOMPARE(table.item(0, 3)->text(), text("116"));
    results.add({without, another});
    results.compare();
    QCOMPARE(table.item(0, 3)->text(), text("116 (n = 1)"));
    QVERIFY(!table.item(0, table.columnCount() - 1)->text().contains(text("n =")));
    for (int column = 2; column < table.columnCount(); ++column) {  // not moved by the rows
      QCOMPARE(table.columnWidth(column), widths[static_cast<std::size_t>(column) - 2]);
    }
  }

  void lines_thatAreNoRows_arePassedOver() {
    QVERIFY(!app::studyRowOf("no json"));
    QVERIFY(!app::studyRowOf("{\"other\": 1}"));
    QVERIFY(!app::studyHeaderOf("{\"run\": 1}"));
    const auto begin = app::studyHeaderOf("{\"runs\":24,\"finished\":3}");
    QVERIFY(begin && begin->runs == 24 && begin->finished == 3);
    const auto row = app::studyRowOf(
        "{\"run\": 3, \"scenario\": \"a.yaml\", \"seed\": 7, \"values\": {\"r.planner\": \"dwa\"}, "
        "\"status\": \"failed\", \"reason\": \"why\", \"metrics\": {\"a\": 1.5, \"b\": true, "
        "\"c\": null}}");
    QVERIFY(row && row->run == 3 && row->seed == 7 && !row->isOk && row->reason == text("why"));
    QCOMPARE(row->values.at(text("r.planner")), text("dwa"));
    QCOMPARE(row->metrics, (std::map<QString, double>{{text("a"), 1.5}, {text("b"), 1.0}}));
  }

  void file_shownAndWrittenAgain_saysTheSame() {
    const QString path = study_->study();
    QVERIFY(panel().openFile(path));
    const auto before = app::readExperiment(path.toStdString());
    const auto after = app::parseExperiment(
        form().yamlFor(QFileInfo(path).absolutePath()).toStdString(), path.toStdString());
    QVERIFY(before && after);
    QCOMPARE(after->scenarioPaths, before->scenarioPaths);
    QCOMPARE(after->seeds, before->seeds);
    QCOMPARE(app::commandLineOf(after->common), app::commandLineOf(before->common));
    QCOMPARE(after->record, before->record);
    QCOMPARE(after->runCount(), before->runCount());
    for (std::size_t run = 0; run < before->runCount(); ++run) {
      QCOMPARE(after->run(run).values, before->run(run).values);
    }
  }

  /// The form does not offer them, and does not lose them.
  void file_plannersThatAreNotOffered_areKept() {
    const QString path = study_->writeStudy(
        "own.yaml", "seeds: 2\nvalues:\n  robot1.planner: [external, pursuit]\n");
    QVERIFY(panel().openFile(path));
    const auto after = app::parseExperiment(
        form().yamlFor(QFileInfo(path).absolutePath()).toStdString(), path.toStdString());
    QVERIFY(after);
    QCOMPARE(after->values.front().texts, (std::vector<std::string>{"external", "pursuit"}));
  }

  /// Chosen by mouse: the scenario that is open, planners, a number of seeds.
  void form_chosen_isAnExperiment() {
    widgets::withText<QAbstractButton>(form(), text("Add current"))->click();
    auto& planners = field<QListWidget>("Planners");
    for (const char* name : {"pursuit", "dwa"}) {
      planners.findItems(text(name), Qt::MatchExactly).front()->setCheckState(Qt::Checked);
    }
    field<QPlainTextEdit>("Other parameters")
        .setPlainText(text("\"*.max_vel\": {uniform: [0.8, 1.2]}"));
    QTRY_COMPARE(panel().message(), text("1 scenario × 2 planners × 30 seeds = 60 runs"));
    field<QPlainTextEdit>("Other parameters").setPlainText(text("nobody.max_vel: [1.0]"));
    QTRY_VERIFY(panel().message().contains(text("nobody")));
  }

  void plannersInMaps_areCompared() {
    const auto study = app::parseExperiment(
        "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 3\nvalues:\n"
        "  anna.max_vel: [1.0, 1.2]\n  robot1: [{planner: dwa}, {planner: orca}]\n",
        study_->path(text("maps.yaml")).toStdString());
    QVERIFY(study);
    QCOMPARE(app::comparedPath(*study), text("robot1"));
    QCOMPARE(app::sizeText(*study),
             text("1 scenario × 2 anna.max_vel × 2 planners × 3 seeds = 12 runs"));
  }

  void study_isRunAndCompared() {
    const QString path = study_->study();
    QVERIFY(panel().openFile(path));
    panel().start();
    QVERIFY(panel().isRunning());
    waitForEnd();
    QCOMPARE(panel().message(), text("24 of 24 runs"));
    const auto rows = readCsv(panel().resultsFolder() + text("/results.csv"));
    QCOMPARE(rows.size(), std::size_t{24});
    QCOMPARE(panel().results().runs().rows().size(), rows.size());
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const StudyRow& shown = panel().results().runs().rows()[k];
      QCOMPARE(shown.run, static_cast<int>(k));
      QCOMPARE(shown.reason, rows[k].at(text("reason")));
      QCOMPARE(shown.metrics.at(text("path_length")), rows[k].at(text("path_length")).toDouble());
      if (rows[k].at(text("robot1.planner")) == text("dwa")) {
        sum += rows[k].at(text("path_length")).toDouble();
        ++count;
      }
    }
    const QTableWidget& table = panel().results().comparison();
    QCOMPARE(table.rowCount(), 2);
    QCOMPARE(table.item(1, 0)->text(), text("dwa"));
    QCOMPARE(table.item(1, 1)->text().toInt(), count);
    const QString last = table.item(1, table.columnCount() - 1)->text();  // way
    QVERIFY2(std::abs(last.section(QLatin1Char(' '), 0, 0).toDouble() - sum / count) < 0.006,
             qPrintable(last));
    window_->docks().dock(text("study"))->raise();
    quiet::shoot(*window_, "study-finished");
    // A row is played.
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    const QByteArray before = bytes(panel().resultsFolder() + text("/results.csv"));
    panel().play(5);
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
    QVERIFY(window_->workspace().runner().isRecorded());
    QCOMPARE(bytes(panel().resultsFolder() + text("/results.csv")), before);
  }

  /// A run of which nothing was kept is made once more, with the same values.
  void run_thatWasNotKept_isMadeAgain() {
    QVERIFY(panel().openFile(study_->writeStudy(
        "short.yaml", "seeds: 2\nduration: 2.0\nvalues:\n  robot1.planner: [pursuit, dwa]\n")));
    panel().start();
    waitForEnd();
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    panel().play(3);
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
    const QString folder = played.front().front().toString();
    QVERIFY(played.front().at(1).toBool());  // a temporary folder
    QVERIFY(!recentFiles().contains(folder));
    const double length = valueOf(metricsOf(folder), text("path_length"));
    QCOMPARE(length, panel().results().runs().rows()[3].metrics.at(text("path_length")));
  }

  void study_stopped_goesOn() {
    QVERIFY(panel().openFile(study_->endless(1)));
    panel().start();
    QTRY_VERIFY(panel().isRunning());
    panel().stop();
    waitForEnd();
    QVERIFY2(panel().message().contains(text("stopped")), qPrintable(panel().message()));
    // Of a study that is finished in part, the rows of before are there again.
    const QString path = study_->study();
    QVERIFY(panel().openFile(path));
    panel().start();
    QTRY_VERIFY_WITH_TIMEOUT(panel().results().runs().rows().size() >= 3, kLong);
    panel().stop();
    waitForEnd();
    panel().start();
    waitForEnd();
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{24});
    QCOMPARE(panel().message(), text("24 of 24 runs"));
  }

  /// Who only runs a file keeps its comments; what is edited is saved before it runs.
  void file_thatIsNotEdited_staysAsItIs() {
    const QString path = study_->writeStudy("mine.yaml", "# why\nseeds: 1\nduration: 0.5\n");
    const QByteArray mine = bytes(path);
    QVERIFY(panel().openFile(path));
    panel().start();
    QVERIFY(!panel().openFile(study_->study()));  // not now
    waitForEnd();
    QCOMPARE(bytes(path), mine);
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{1});
    field<QLineEdit>("Seeds").setText(text("2"));
    panel().start(app::StudyProcess::Begin::Restart);
    waitForEnd();
    QVERIFY(bytes(path) != mine);
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{2});
  }

  /// The study reads files: what is changed in the window alone is told.
  void scenario_notSaved_isTold() {
    form().addScenario(document().path());
    QTRY_VERIFY(panel().message().contains(text("1 scenario")));
    QVERIFY(!panel().message().contains(text("unsaved")));
    document().setSelection({document().entities(base::EntityKind::Robot).front()});
    editor::pushChange<sim2d::Robot>(document(), document().selection().front(), text("Planner"),
                                     [](sim2d::Robot& robot) { robot.planner = "dwa"; });
    QTRY_VERIFY2(panel().message().contains(text("unsaved")), qPrintable(panel().message()));
  }

  /// Start does not run the saved file in silence: it offers to save, or to run the file as it is.
  void start_withUnsavedScenario_offersToSave() {
    window_->docks().show({text("study")});
    panel().setFile(at("asked.yaml"));
    form().addScenario(document().path());
    field<QLineEdit>("Seeds").setText(text("1"));
    field<QLineEdit>("Duration").setText(text("0.5"));
    document().setSelection({document().entities(base::EntityKind::Robot).front()});
    editor::pushChange<sim2d::Robot>(document(), document().selection().front(), text("Planner"),
                                     [](sim2d::Robot& robot) { robot.planner = "dwa"; });
    auto& start = *widgets::withText<QPushButton>(panel(), text("Start"));
    auto& saveFirst = *widgets::withText<QAbstractButton>(panel(), text("Save and start"));
    auto& asSaved = *widgets::withText<QAbstractButton>(panel(), text("Start without them"));
    QVERIFY(!saveFirst.isVisible() && !asSaved.isVisible());
    QTRY_VERIFY(start.isEnabled());
    QTest::mouseClick(&start, Qt::LeftButton);
    QVERIFY(!panel().isRunning());
    QVERIFY(saveFirst.isVisible() && asSaved.isVisible());
    QVERIFY2(panel().message().contains(text("unsaved changes")), qPrintable(panel().message()));
    quiet::shoot(*window_, "study-unsaved");
    QTest::mouseClick(&asSaved, Qt::LeftButton);
    waitForEnd();
    QVERIFY(document().isDirty());
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{1});
    QVERIFY(!asSaved.isVisible());
    field<QLineEdit>("Seeds").setText(text("2"));
    panel().setFile(at("saved.yaml"));
    QTest::mouseClick(&start, Qt::LeftButton);
    QVERIFY(!panel().isRunning());  // asked again
    QTest::mouseClick(&saveFirst, Qt::LeftButton);
    QVERIFY(!document().isDirty());
    waitForEnd();
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{2});
    QVERIFY(bytesOf(document().path()).contains("planner: dwa"));
  }

  /// The message keeps its first lines in sight, whatever its length; nothing is above its top.
  void message_long_beginsInSight() {
    window_->docks().show({text("study")});
    const auto* label = widgets::findIf<QLabel>(
        panel(), [this](const QLabel* each) { return each->text() == panel().message(); });
    QVERIFY(label != nullptr);
    QVERIFY(label->alignment().testFlag(Qt::AlignTop));
    form().addScenario(document().path());
    QTRY_VERIFY(panel().message().contains(text("1 scenario")));
    QVERIFY2(label->heightForWidth(label->width()) <= label->height(),
             qPrintable(panel().message()));
    QCOMPARE(label->toolTip(), panel().message());
  }

  /// "New" leaves the results of the old study where they are.
  void newStudy_isAboutTheOpenScenario() {
    const QString path = study_->writeStudy("first.yaml", "seeds: 3\nduration: 0.5\n");
    QVERIFY(panel().openFile(path));
    window_->docks().show({text("study")});
    QTest::mouseClick(widgets::withText<QAbstractButton>(panel(), text("New")), Qt::LeftButton);
    QCOMPARE(panel().file(), QString());
    QCOMPARE(form().scenarios(), QStringList(document().path()));
    QCOMPARE(field<QLineEdit>("Seeds").text(), text("30"));
    QCOMPARE(field<QLineEdit>("Duration").text(), QString());
    QVERIFY(QFile::exists(path));
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{0});
  }

  /// Another study does not go on with results: it is said, and begun anew only when asked for.
  void changedStudy_isRefusedThenBegunAnew() {
    QVERIFY(panel().openFile(study_->writeStudy("changed.yaml", "seeds: 1\nduration: 0.5\n")));
    panel().start();
    waitForEnd();
    const QByteArray before = bytes(panel().resultsFolder() + text("/results.csv"));
    field<QLineEdit>("Seeds").setText(text("2"));
    QTRY_VERIFY(panel().message().contains(text("2 runs")));
    panel().start();
    waitForEnd();
    QVERIFY2(panel().message().contains(text("belong to another experiment")),
             qPrintable(panel().message()));
    QCOMPARE(bytes(panel().resultsFolder() + text("/results.csv")), before);
    panel().start(app::StudyProcess::Begin::Restart);
    waitForEnd();
    QCOMPARE(panel().results().runs().rows().size(), std::size_t{2});
  }

  /// The window goes while a study runs: no process is left.
  void closedWindow_endsTheStudy() {
    QVERIFY(panel().openFile(study_->endless()));
    panel().start();
    const auto batches = [] { return childrenOf(QCoreApplication::applicationPid()); };
    QTRY_VERIFY(!batches().empty());
    end();
    QTRY_VERIFY(batches().empty());
    begin();
  }
};

QTEST_MAIN(StudyPanelTest)
#include "tst_StudyPanel.moc"
