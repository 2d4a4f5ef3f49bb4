#include <QSignalSpy>

#include "app/window/Docks.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyPanel.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"

using app::StudyPanel;
using app::StudyProcess;
using namespace outside;

namespace {

constexpr int kLong = 50000;  // [ms]

}  // namespace

/// The panel of studies where results lie already, or code of others is wanted: nothing is lost,
/// nothing is started unasked.
class StudyEarlierTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  std::unique_ptr<StudyFolder> study_;

  StudyPanel& panel() { return window_->docks().panel<StudyPanel>(); }
  std::size_t rows() { return panel().results().runs().rows().size(); }
  QPushButton& button(const char* words) {
    return *widgets::withText<QPushButton>(panel(), text(words));
  }
  bool hasButton(const char* words) {
    return widgets::withText<QPushButton>(panel(), text(words)) != nullptr;
  }
  bool isAnewOffered() {
    return widgets::findIf<QAbstractButton>(panel(), [](const QAbstractButton* each) {
             return each->text() == text("Restart") && !each->isHidden();
           }) != nullptr;
  }
  QLineEdit& seeds() { return quiet::part<QLineEdit>(panel(), "Seeds"); }
  QString result(const char* name) { return panel().resultsFolder() + text("/") + text(name); }
  void waitForEnd() { QTRY_VERIFY_WITH_TIMEOUT(!panel().isRunning(), kLong); }

  /// A study of four short runs, as `batch` leaves it beside its file.
  QString finished() const {
    QString file = study_->writeStudy(
        "done.yaml",
        "# mine\nseeds: 2\nduration: 2.0\nvalues:\n  robot1.planner: [pursuit, dwa]\n");
    const QString out = study_->path(text("done_results"));
    return runProgram(StudyFolder::words(file, out)).exitCode == 0 ? file : QString();
  }
  /// Its robot is driven by a program, which makes the file `started`.
  QString withCode() const {
    writeText(study_->path(text("drive.sh")),
              "touch '" + study_->path(text("started")).toUtf8() +
                  "'\nread -r line; echo '{\"ready\":true}'\n"
                  "while read -r line; do echo '{\"linear\":0.5,\"angular\":0}'; done\n");
    return study_->writeStudy("code.yaml",
                              "seeds: 1\nduration: 1.0\nvalues:\n  robot1.command: [\"/bin/sh " +
                                  study_->path(text("drive.sh")).toUtf8() +
                                  "\"]\n  robot1.planner: [pursuit, external]\n");
  }
  bool isAsked() { return window_->notices().has(app::studyCodeNoticeId()); }
  void answer(int choice) { window_->notices().choose(app::studyCodeNoticeId(), choice); }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(copyOfDemo()));
    study_ = std::make_unique<StudyFolder>();
    panel().process().setProgram(text(HUNAVSIM_PROGRAM));
  }
  void cleanup() { end(); }

  void open_finishedStudy_showsItsResults() {
    QVERIFY(!button("Report").isEnabled());
    QVERIFY(panel().openFile(finished()));
    QCOMPARE(rows(), std::size_t{4});
    QVERIFY(button("Report").isEnabled());
    QTRY_VERIFY2(panel().message().endsWith(text("= 4 runs. 4 of 4 finished")),
                 qPrintable(panel().message()));
    const auto table = readCsv(result("results.csv"));
    for (std::size_t k = 0; k < table.size(); ++k) {
      const app::StudyRow& row = panel().results().runs().rows()[k];
      QCOMPARE(row.run, static_cast<int>(k));
      QCOMPARE(row.values.at(text("robot1.planner")), table[k].at(text("robot1.planner")));
      QCOMPARE(row.metrics.at(text("path_length")), table[k].at(text("path_length")).toDouble());
      QCOMPARE(row.metrics.at(text("success")), 0.0);  // False
    }
    const QTableWidget& shown = panel().results().comparison();
    QCOMPARE(shown.rowCount(), 2);
    QCOMPARE(shown.item(1, 0)->text(), text("dwa"));
    window_->docks().show({text("study")});
    quiet::shoot(*window_, "study-opened");
    QVERIFY(panel().openFile(study_->endless()));  // one without results
    QCOMPARE(rows(), std::size_t{0});
    QVERIFY(!button("Report").isEnabled());
  }

  void open_folderOfABatch_showsItsResults() {
    const QString file = finished(), folder = study_->path(text("elsewhere"));
    QVERIFY(QDir().rename(study_->path(text("done_results")), folder));
    QVERIFY(window_->files().openFile(folder));
    QCOMPARE(panel().file(), file);
    QCOMPARE(panel().resultsFolder(), folder);
    QCOMPARE(rows(), std::size_t{4});
    QVERIFY(button("Report").isEnabled());
    QVERIFY(QFile::remove(folder + text("/results.sqlite")));  // manifest.json names it, too
    QVERIFY(window_->files().openFile(folder));
    QCOMPARE(rows(), std::size_t{4});
    QVERIFY(QFile::remove(file));
    QVERIFY(!window_->files().openFile(folder));
    QVERIFY(window_->files().problems().front().code == "batch.no-experiment");
  }

  void open_batchFromStandardInput_isRefusedWithTheReason() {
    const QString out = study_->path(text("piped"));
    QProcess program;
    program.setWorkingDirectory(study_->path({}));
    program.setStandardInputFile(finished());
    program.start(text(HUNAVSIM_PROGRAM), {text("batch"), text("-"), text("-o"), out});
    QVERIFY(program.waitForFinished(kLong));
    QCOMPARE(program.exitCode(), 0);
    writeText(study_->path(text("-")), "hunavsim_experiment: 1\n");  // not the experiment
    for (const bool hasDatabase : {true, false}) {
      QVERIFY(hasDatabase || QFile::remove(out + text("/results.sqlite")));
      QVERIFY(!window_->files().openFile(out));
      QVERIFY(window_->files().problems().front().code == "batch.piped-experiment");
    }
  }

  void open_whileAStudyRuns_isRefusedBeforeAnythingChanges() {
    const QString other = finished(), file = study_->endless(1);
    QVERIFY(panel().openFile(file));
    panel().start();
    QVERIFY(panel().isRunning());
    QSignalSpy recent(&window_->files(), &app::FileCommands::recentChanged);
    for (const QString& path : {other, study_->path(text("done_results"))}) {
      QVERIFY(!window_->files().openFile(path));
      QVERIFY(window_->files().problems().front().code == "study.running");
    }
    QCOMPARE(recent.size(), 0);
    QCOMPARE(panel().file(), file);
    panel().stop();
    waitForEnd();
    QVERIFY(window_->files().openFile(other));
    QCOMPARE(panel().file(), other);
  }

  void open_killedStudy_showsWhatIsFinished() {
    const QString file = study_->study();
    const QString out = study_->path(text("study_results"));
    {
      Running batch(StudyFolder::words(file, out, {text("--jobs"), text("1")}));
      QTRY_VERIFY_WITH_TIMEOUT(StudyFolder::runFolders(out).size() >= 5, kLong);
      QVERIFY(panel().openFile(file));  // while it runs
      QTRY_VERIFY2(panel().message().contains(text("process %1").arg(batch.pid())),
                   qPrintable(panel().message()));
      ::kill(batch.pid(), SIGKILL);
      batch.wait();
    }
    QVERIFY(!QFile::exists(out + text("/results.csv")));
    QVERIFY(panel().openFile(file));
    QVERIFY(rows() >= 3 && rows() < 24);
    QVERIFY(!button("Report").isEnabled());
    QVERIFY(hasButton("Resume"));
    panel().start();
    waitForEnd();
    QCOMPARE(rows(), std::size_t{24});
    QVERIFY(button("Report").isEnabled());
  }

  /// The batch refuses to go on; what it has found stays in sight.
  void open_inputChanged_stillShowsRows() {
    const QString file = finished();
    writeText(study_->path(text("yard.yaml")),
              QByteArray(kYardText).replace("max_vel: 1.2", "max_vel: 1.1"));
    QVERIFY(panel().openFile(file));
    QCOMPARE(rows(), std::size_t{4});
    QTRY_VERIFY2(panel().message().endsWith(text("yard.yaml has changed since the study ran")),
                 qPrintable(panel().message()));
    panel().start();
    waitForEnd();
    QVERIFY2(panel().message().contains(text("has changed since the batch started")),
             qPrintable(panel().message()));
    QCOMPARE(rows(), std::size_t{4});
    QVERIFY(button("Report").isEnabled());
  }

  /// The batch was started in another folder than this program, with relative paths.
  void open_inputOfARelativePathChanged_isTold() {
    const QString file = study_->writeStudy("near.yaml", "seeds: 1\nduration: 1.0\n");
    const QString folder = QFileInfo(file).absolutePath();
    QCOMPARE(
        runProgram({text("batch"), QFileInfo(file).fileName(), text("-o"), text("near_results")},
                   folder)
            .exitCode,
        0);
    QVERIFY(panel().openFile(file));
    QTRY_VERIFY2(panel().message().endsWith(text("1 of 1 finished")),
                 qPrintable(panel().message()));
    writeText(study_->path(text("yard.yaml")),
              QByteArray(kYardText).replace("max_vel: 1.2", "max_vel: 1.1"));
    QVERIFY(panel().openFile(file));
    QTRY_VERIFY2(panel().message().endsWith(text("yard.yaml has changed since the study ran")),
                 qPrintable(panel().message()));
  }

  void inputs_ofRelativePaths_areThoseOfTheStudysFolder() {
    QTemporaryDir folder;
    const QString root = folder.path();
    QVERIFY(QDir(root).mkpath(text("elsewhere/studies")));
    writeText(root + text("/elsewhere/map.pgm"), "new");
    const std::vector<app::InputHash> inputs = {{"map.pgm", app::sha256Of("old")},
                                                {"gone.yaml", app::sha256Of("old")}};
    const auto changed = [&](const char* named, const char* file) {
      return app::changedInputOf(named, inputs, root + text(file));
    };
    QCOMPARE(changed("studies/s.yaml", "/elsewhere/studies/s.yaml"), text("map.pgm"));
    QCOMPARE(changed("./studies/s.yaml", "/elsewhere/studies/s.yaml"), text("map.pgm"));
    QCOMPARE(changed("s.yaml", "/elsewhere/studies/s.yaml"), QString());     // another folder
    QCOMPARE(changed("../s.yaml", "/elsewhere/studies/s.yaml"), QString());  // an unknown one
    QCOMPARE(
        app::changedInputOf(
            "s.yaml", {{(root + text("/elsewhere/map.pgm")).toStdString(), app::sha256Of("old")}},
            root + text("/s.yaml")),
        text("map.pgm"));
  }

  void open_tableAlone_isShownAndNotReplaced() {
    const QString file = finished();
    QVERIFY(QFile::remove(study_->path(text("done_results/results.sqlite"))));
    QVERIFY(panel().openFile(file));
    QCOMPARE(rows(), std::size_t{4});
    QCOMPARE(panel().results().comparison().rowCount(), 2);
    QVERIFY(button("Report").isEnabled());
    const QByteArray before = bytesOf(result("results.csv"));
    panel().start();
    QVERIFY(!panel().isRunning());
    QVERIFY2(panel().message().contains(text("have no results.sqlite")),
             qPrintable(panel().message()));
    QCOMPARE(bytesOf(result("results.csv")), before);
    writeText(result("results.csv"), "run,scenario\n1,2\n");
    QVERIFY(panel().openFile(file));
    QCOMPARE(rows(), std::size_t{0});
    QTRY_VERIFY2(panel().message().contains(text("results.csv: the first line must be")),
                 qPrintable(panel().message()));
  }

  void open_damagedDatabase_isToldAndKept() {
    const QString file = finished();
    const QString store = study_->path(text("done_results/results.sqlite"));
    const QByteArray whole = bytesOf(store);
    for (const QByteArray& bytes : {whole.left(5000), QByteArray("no database at all, no no no")}) {
      writeText(store, bytes);
      QVERIFY(panel().openFile(file));
      QTRY_VERIFY2(panel().message().contains(text("results.sqlite: the results cannot be read")),
                   qPrintable(panel().message()));
      QCOMPARE(rows(), std::size_t{4});  // of the table
      seeds().setText(text("3"));
      const QByteArray mine = bytesOf(file);
      panel().start();
      QVERIFY(!panel().isRunning());
      QVERIFY(panel().message().contains(text("cannot be read")));
      QCOMPARE(bytesOf(file), mine);
      QCOMPARE(bytesOf(store), bytes);
    }
    QVERIFY(QFile::remove(study_->path(text("done_results/results.csv"))));
    QVERIFY(panel().openFile(file));
    QCOMPARE(rows(), std::size_t{0});
  }

  /// The file stays that of the results; who takes the change back goes on with it.
  void start_changedStudy_doesNotWriteTheFile() {
    const QString file = finished();
    const QByteArray mine = bytesOf(file), store = bytesOf(study_->path(text("done_results/"
                                                                             "results.sqlite")));
    QVERIFY(panel().openFile(file));
    seeds().setText(text("3"));
    panel().start();
    QVERIFY(!panel().isRunning());
    QCOMPARE(panel().message(), text("The results in done_results belong to another experiment: "
                                     "restart (deletes them), or save as another file"));
    QTest::qWait(400);  // longer than the fields are checked after
    QVERIFY(panel().message().contains(text("another experiment")));
    QCOMPARE(bytesOf(file), mine);
    QCOMPARE(bytesOf(result("results.sqlite")), store);
    QCOMPARE(rows(), std::size_t{4});
    QVERIFY(isAnewOffered());
    seeds().setText(text("2"));
    QTRY_VERIFY(!isAnewOffered());
    panel().start();
    waitForEnd();
    QCOMPARE(panel().message(), text("4 of 4 runs"));
    QCOMPARE(bytesOf(file), mine);
    seeds().setText(text("3"));
    panel().start(StudyProcess::Begin::Restart);
    waitForEnd();
    QCOMPARE(panel().message(), text("6 of 6 runs"));
    QVERIFY(bytesOf(file) != mine);
  }

  /// By another process: not even who begins anew takes the file from it.
  void start_whileABatchRunsThere_doesNotWriteTheFile() {
    const QString file = study_->endless();
    const QByteArray mine = bytesOf(file);
    Running batch(StudyFolder::words(file, study_->path(text("endless_results")),
                                     {text("--jobs"), text("1")}));
    QTRY_VERIFY_WITH_TIMEOUT(!batch.workers().empty(), kLong);
    QVERIFY(panel().openFile(file));
    seeds().setText(text("1"));
    for (const auto begin : {StudyProcess::Begin::Resume, StudyProcess::Begin::Restart}) {
      panel().start(begin);
      QVERIFY(!panel().isRunning());
      QVERIFY2(panel().message().contains(text("process %1").arg(batch.pid())),
               qPrintable(panel().message()));
      QCOMPARE(bytesOf(file), mine);
    }
  }

  void code_isAskedForAndAllowed() {
    const QString file = withCode();
    QVERIFY(panel().openFile(file));
    panel().start();
    QVERIFY(isAsked());
    QVERIFY(!panel().isRunning());
    const app::Notice notice = told("study-code");
    QVERIFY2(notice.text.contains(text("code.yaml runs external code (/bin/sh %1 (robot1))")
                                      .arg(study_->path(text("drive.sh")))),
             qPrintable(notice.text));
    window_->docks().show({text("study")});
    quiet::shoot(*window_, "study-asks");
    answer(1);  // no
    QVERIFY(!isAsked() && !panel().isRunning());
    QVERIFY(button("Start").isEnabled());
    QVERIFY(!QFile::exists(study_->path(text("started"))));
    QVERIFY(!QFile::exists(panel().resultsFolder()));
    panel().start();
    answer(0);
    QVERIFY(panel().isRunning());
    waitForEnd();
    QCOMPARE(panel().message(), text("2 of 2 runs"));
    QVERIFY(QFile::exists(study_->path(text("started"))));
    // A run that is made once more starts it too: the answer holds for the file.
    QVERIFY(QFile::remove(study_->path(text("started"))));
    QDir(panel().resultsFolder() + text("/runs")).removeRecursively();
    QSignalSpy played(&panel(), &StudyPanel::openRunRequested);
    panel().play(1);
    QVERIFY(!isAsked());
    QTRY_COMPARE_WITH_TIMEOUT(played.count(), 1, kLong);
    QVERIFY(QFile::exists(study_->path(text("started"))));
    // Opened again it is asked anew, also for one run.
    QVERIFY(panel().openFile(file));
    panel().play(1);
    QVERIFY(isAsked());
    QVERIFY(panel().openFile(study_->study()));
    QVERIFY(!isAsked());
  }
};

QTEST_MAIN(StudyEarlierTest)
#include "tst_RestoredStudy.moc"
