#include "app/window/WindowCommand.h"
#include "editor/document/EditCommands.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/RunFiles.h"

using editor::SimulationRunner;
using namespace outside;

/// A scenario with a program in it is run in the window.
class CodeQuestionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();
  void play_program_asksFirst();
  void play_notAllowed_startsNothing();
  void play_allowed_isRemembered();
  void play_otherCommand_asksAgain();
  void step_allowed_makesOneStep();
  void play_optionGiven_doesNotAsk();
  void play_optionForAnotherFile_asks();
  void stop_programHangs_endsIt();
  void screenshot_notAllowed_isRefused();
  void open_otherFile_forgetsTheQuestion();

 private:
  QString path(const char* name) const { return folder_->filePath(text(name)); }
  app::Workspace& space() { return window_->workspace(); }
  SimulationRunner& runner() { return space().runner(); }
  bool isAsked() { return window_->notices().has(app::codeNoticeId()); }
  void answer(int choice) { window_->notices().choose(app::codeNoticeId(), choice); }
  /// A scenario whose robot is driven by a program, which notes its number in the file `child`.
  QString written(const char* name, const QByteArray& planner, const QByteArray& child) const;
  void open(const QByteArray& planner, bool isAllowed = false);

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<app::MainWindow> window_;
};

namespace {

const char* const kDrives =
    "read -r line; echo '{\"ready\":true}'\n"
    "while read -r line; do echo '{\"linear\":0.5,\"angular\":0}'; done\n";
const char* const kHangs =
    "read -r line; echo '{\"ready\":true}'\nread -r line; touch asked; sleep 600\n";

}  // namespace

QString CodeQuestionTest::written(const char* name, const QByteArray& planner,
                                  const QByteArray& child) const {
  const QString script = path(name) + text(".sh");
  writeText(script, "cd '" + folder_->path().toUtf8() + "'\necho $$ > " + child + "\n" + planner);
  QString scenario = path(name) + text(".yaml");
  writeText(scenario,
            "hunav_loader:\n  ros__parameters:\n    yaml_base_name: yard\n    map: yard\n"
            "    global_goals:\n      1:\n        x: 1.0\n        y: 4.0\n"
            "    agents:\n      - anna\n    anna:\n      id: 1\n"
            "      init_pose:\n        x: 1.0\n        y: 5.0\n        h: 0.0\n"
            "      behavior:\n        type: Regular\n      goals:\n        - 1\n"
            "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
            "    robots:\n      - robot1\n    robot1:\n      planner: external\n"
            "      command: \"/bin/sh '" +
                script.toUtf8() +
                "'\"\n"
                "      planner_parameters:\n        timeout: 600.0\n"
                "      start:\n        x: 0.0\n        y: 0.0\n        h: 0.0\n"
                "      goal:\n        x: 50.0\n        y: 0.0\n");
  return scenario;
}

void CodeQuestionTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
}

void CodeQuestionTest::cleanup() {
  if (window_ != nullptr) {
    quiet::leave(window_);
  }
}

void CodeQuestionTest::open(const QByteArray& planner, bool isAllowed) {
  app::WindowSetup setup = quiet::setup();
  setup.options.allowCode = isAllowed;
  window_ = quiet::shownWindow(setup);
  QVERIFY(window_->open(written("yard", planner, "child")));
  QVERIFY(!isAsked());
}

void CodeQuestionTest::play_program_asksFirst() {
  open(kDrives);
  runner().play();
  QVERIFY(isAsked());
  const app::Notice& notice = window_->notices().notices().back();
  QVERIFY(notice.text.contains(text("yard.yaml")));  // which file
  QVERIFY(notice.text.contains(text("/bin/sh '%1'").arg(path("yard.sh"))));
  QVERIFY(notice.text.contains(text("robot1")));
  QCOMPARE(notice.choices.size(), std::size_t{2});
  QCOMPARE(runner().state(), SimulationRunner::State::Editing);
  space().document().checkNow();  // nor does the list of issues start it
  bool isInIssues = false;
  for (const base::Diagnostic& issue : space().document().issues()) {
    isInIssues |= issue.code == "code.not-allowed" && issue.severity == base::Severity::Warning;
  }
  QVERIFY(isInIssues);
  QTest::qWait(200);
  QVERIFY(!QFile::exists(path("child")));
}

void CodeQuestionTest::play_notAllowed_startsNothing() {
  open(kDrives);
  runner().play();
  answer(1);
  QVERIFY(!isAsked());
  QCOMPARE(runner().state(), SimulationRunner::State::Editing);
  QTest::qWait(200);
  QVERIFY(!QFile::exists(path("child")));
  runner().play();
  QVERIFY(isAsked());  // a no is no answer for good
}

void CodeQuestionTest::play_allowed_isRemembered() {
  open(kDrives);
  const QByteArray before = bytesOf(path("yard.yaml"));
  runner().play();
  answer(0);
  QVERIFY(!isAsked());
  QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr && runner().newestFrame()->step > 3,
                           30000);
  QVERIFY(runner().newestFrame()->robots.x.front() > 0.0);
  runner().reset();
  runner().play();
  QVERIFY(!isAsked());
  QCOMPARE(runner().state(), SimulationRunner::State::Running);
  runner().reset();
  QCOMPARE(bytesOf(path("yard.yaml")), before);
  QVERIFY(!space().document().isDirty());
}

void CodeQuestionTest::play_otherCommand_asksAgain() {
  open(kDrives);
  runner().play();
  answer(0);
  QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr, 30000);
  runner().reset();
  editor::Draft draft(space().document());
  sim2d::Robot robot = space().document().scenario().robots.front();
  robot.command = "touch '" + path("was-here").toStdString() + "'";
  draft.set(robot);
  draft.push(text("Change the command"));
  runner().play();
  QVERIFY(isAsked());
  QVERIFY(!QFile::exists(path("was-here")));
}

void CodeQuestionTest::step_allowed_makesOneStep() {
  open(kDrives);
  runner().stepOnce();
  QVERIFY(isAsked());
  QCOMPARE(runner().state(), SimulationRunner::State::Editing);
  answer(0);
  QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr && runner().newestFrame()->step == 1,
                           30000);
  QCOMPARE(runner().state(), SimulationRunner::State::Paused);
}

void CodeQuestionTest::play_optionGiven_doesNotAsk() {
  open(kDrives, true);
  runner().play();
  QVERIFY(!isAsked());
  QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr && runner().newestFrame()->step > 3,
                           30000);
}

/// Like the other options, it is for the file that was named beside it.
void CodeQuestionTest::play_optionForAnotherFile_asks() {
  app::WindowSetup setup = quiet::setup();
  setup.options.allowCode = true;
  setup.options.scenario = written("yard", kDrives, "child").toStdString();
  window_ = quiet::shownWindow(setup);
  QVERIFY(window_->open(path("yard.yaml")));
  QVERIFY(space().unapprovedCode().empty());
  QVERIFY(window_->open(written("other", kDrives, "child")));
  runner().play();
  QVERIFY(isAsked());
}

/// The program may take longer for its answer than any test waits.
void CodeQuestionTest::stop_programHangs_endsIt() {
  open(kHangs, true);
  runner().play();
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("asked")), 30000);
  QVERIFY(!isGone(bytesOf(path("child"))));
  runner().reset();
  QCOMPARE(runner().state(), SimulationRunner::State::Editing);
  QTRY_VERIFY_WITH_TIMEOUT(isGone(bytesOf(path("child"))), 30000);
  QFile::remove(path("asked"));
  runner().play();
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("asked")), 30000);
  quiet::leave(window_);  // the window is closed
  QVERIFY(isGone(bytesOf(path("child"))));
}

void CodeQuestionTest::screenshot_notAllowed_isRefused() {
  open(kDrives);
  app::WindowOptions options;
  options.screenshot = path("picture.png").toStdString();
  options.at = 0.5;
  const base::Diagnostics problems = app::takeScreenshot(*window_, options);
  QVERIFY(base::hasErrors(problems));
  QCOMPARE(std::string(problems.front().code), std::string("code.not-allowed"));
  QVERIFY(!QFile::exists(path("child")));
}

void CodeQuestionTest::open_otherFile_forgetsTheQuestion() {
  open(kDrives);
  runner().play();
  QVERIFY(isAsked());
  QVERIFY(window_->open(written("other", kDrives, "child2")));
  QVERIFY(!isAsked());
  runner().play();
  QVERIFY(isAsked());
}

QTEST_MAIN(CodeQuestionTest)
#include "tst_ExternalCodePrompt.moc"
