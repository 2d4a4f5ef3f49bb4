#include <QtTest>

#include "app/window/study/StudyPanel.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"

using outside::text;

/// Packed studies in the window.
class CapsuleWindowTest : public QObject {
  Q_OBJECT

 private:
  outside::StudyFolder folder_;
  std::unique_ptr<app::MainWindow> window_;

  QString path(const char* name) const { return folder_.path(text(name)); }

 private Q_SLOTS:
  void initTestCase() {
    outside::writeText(path("study.yaml"),
                       "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 3\nduration: 1.0\n");
    QCOMPARE(outside::failureOf("batch % -o % -q", {path("study.yaml"), path("results")}),
             QString());
    QCOMPARE(outside::failureOf("run % --duration 2 -o % -q", {path("yard.yaml"), path("run")}),
             QString());
    for (const char* study : {"run", "results"}) {
      QCOMPARE(outside::failureOf("pack % -o % -q", {path(study), path(study) + text(".hnv")}),
               QString());
    }
    for (const char* original : {"run", "results", "study.yaml", "yard.yaml"}) {
      QDir(path(original)).removeRecursively();
      QFile::remove(path(original));
    }
  }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { quiet::leave(window_); }

  void run_packed_isPlayedWithItsScenario() {
    QVERIFY(window_->open(path("run.hnv")));
    QVERIFY(window_->workspace().isRecordedRun());
    const editor::RecordingPtr recording = window_->workspace().runner().recording();
    QCOMPARE(recording->stepOf(recording->size() - 1), std::int64_t{40});
    const sim2d::Scenario& scenario = window_->workspace().document().scenario();
    QCOMPARE(scenario.humans.size(), std::size_t{2});
    QVERIFY(!window_->workspace().document().path().startsWith(path("")));
    QVERIFY(QFileInfo::exists(window_->workspace().document().path()));
  }

  void batch_packed_showsItsResults() {
    QVERIFY(window_->open(path("results.hnv")));
    const auto& panel = window_->docks().panel<app::StudyPanel>();
    QCOMPARE(QFileInfo(panel.file()).fileName(), text("study.yaml"));
    QVERIFY(panel.isVisible());
    QVERIFY(QFileInfo::exists(panel.resultsFolder() + text("/results.csv")));
    QTRY_COMPARE(panel.results().runs().rowCount(), 3);
    QCOMPARE(window_->workspace().document().scenario().humans.size(), std::size_t{2});
  }

  void temporaryFolder_isRemovedWithTheWindow() {
    QVERIFY(window_->open(path("run.hnv")));
    const QString scenario = window_->workspace().document().path();
    QVERIFY(QFileInfo::exists(scenario));
    quiet::leave(window_);
    QVERIFY(!QFileInfo::exists(scenario));
    window_ = quiet::shownWindow();
  }

  void file_thatIsNone_isReported() {
    outside::writeText(path("none.hnv"), "no archive");
    QVERIFY(!window_->open(path("none.hnv")));
    QVERIFY(!window_->files().problems().empty());
    QCOMPARE(window_->files().problems().front().code, std::string_view("capsule.no-archive"));
  }
};

QTEST_MAIN(CapsuleWindowTest)
#include "tst_CapsuleWindow.moc"
