#include <csignal>
#include <cstdio>

#include <QtTest>

#include "app/window/MainWindow.h"
#include "app/window/TerminationSignals.h"
#include "app/window/files/FileCommands.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/AppStyle.h"
#include "sim2d/base/Text.h"

using app::MainWindow;
using app::WindowSetup;

namespace {

constexpr const char* kEditForEver = "--edit-for-ever";
constexpr qint64 kMostLostMs = 10000;

WindowSetup setupWith(const QString& recoveryFolder) {
  WindowSetup setup;
  setup.followsSystem = false;
  setup.storesSettings = false;
  setup.recoveryFolder = recoveryFolder;
  return setup;
}

/// The other process: a window whose user never pauses. Every edit puts its number and its time
/// into the seed and tells them.
int editForEver(int argc, char** argv) {
  QApplication application(argc, argv);
  editor::applyTheme(editor::Theme::light());
  MainWindow window(setupWith(QString::fromLocal8Bit(argv[2])));
  if (!window.open(QString::fromLocal8Bit(argv[3]))) {
    return 1;
  }
  QTimer edits;
  const app::TerminationSignals termination;
  QObject::connect(&termination, &app::TerminationSignals::received, &edits, &QTimer::stop);
  QObject::connect(&termination, &app::TerminationSignals::received, &window,
                   &MainWindow::endSession);
  QElapsedTimer clock;
  clock.start();
  QObject::connect(&edits, &QTimer::timeout, &edits, [&] {
    editor::ScenarioDocument& document = window.workspace().document();
    const qint64 now = clock.elapsed();
    editor::pushChange<editor::ScenarioSettings>(
        document, editor::kSettingsId, QStringLiteral("Seed"),
        [now](editor::ScenarioSettings& settings) { settings.desktop.seed = now; });
    std::printf("%lld\n", static_cast<long long>(now));
    std::fflush(stdout);
  });
  edits.start(50);
  return QApplication::exec();
}

}  // namespace

class CrashRecoveryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void kill_inTheMiddleOfEditing_losesAtMostTenSeconds() {
    const QString scenario = folder_->filePath(QStringLiteral("work.yaml"));
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    QVERIFY(QFile::copy(QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"),
                        scenario));
    const QByteArray before = bytesOf(scenario);
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(),
                  {QString::fromLatin1(kEditForEver), recovery, scenario});
    QVERIFY(program.waitForStarted(20000));
    // long enough that a copy which is written only once would be too old
    const qint64 last = readUntil(program, kMostLostMs + 3000);
    QVERIFY(last > kMostLostMs);
    QVERIFY(editor::Autosave::orphanedFolders(recovery).isEmpty());  // it lives
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), SIGKILL), 0);
    QVERIFY(program.waitForFinished(20000));
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);
    QVERIFY(bytesOf(scenario) == before);

    MainWindow window(setupWith(recovery));
    window.show();
    QCOMPARE(window.notices().notices().size(), std::size_t(1));
    const app::Notice offer = window.notices().notices().front();
    QVERIFY(offer.text.contains(QStringLiteral("work.yaml")));
    window.notices().choose(offer.id, 0);
    QVERIFY(!window.isOnStartPage());
    editor::ScenarioDocument& document = window.workspace().document();
    QCOMPARE(document.path(), scenario);
    QVERIFY(document.isDirty());
    const qint64 kept = document.scenario().desktop.seed.value_or(0);
    QVERIFY2(last - kept <= kMostLostMs, qPrintable(QString::number(last - kept)));
    QVERIFY(kept > 0);
    // saved, the offer is gone for good
    QVERIFY(window.files().saveTo(scenario));
    QVERIFY(bytesOf(scenario) != before);
    MainWindow next(setupWith(recovery));
    QVERIFY(next.notices().notices().empty());
  }

  /// Logout, a closed terminal, Ctrl-C: the program ends in order and keeps the last edit.
  void terminated_endsInOrderAndKeepsTheLastEdit_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("logout") << SIGTERM;
    QTest::newRow("closed terminal") << SIGHUP;
    QTest::newRow("Ctrl-C") << SIGINT;
  }
  void terminated_endsInOrderAndKeepsTheLastEdit() {
    QFETCH(int, signal);
    const QString demo = QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    const QString scenario = folder_->filePath(QStringLiteral("work.yaml"));
    const QString other = folder_->filePath(QStringLiteral("other.yaml"));
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    QVERIFY(QFile::copy(demo, scenario) && QFile::copy(demo, other));
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(),
                  {QString::fromLatin1(kEditForEver), recovery, scenario});
    QVERIFY(program.waitForStarted(20000));
    QVERIFY(readUntil(program, 100) >= 100);
    QCOMPARE(::kill(static_cast<pid_t>(program.processId()), signal), 0);
    QVERIFY(program.waitForFinished(20000));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 0);
    qint64 last = 0;
    while (program.canReadLine()) {
      last = program.readLine().trimmed().toLongLong();
    }

    MainWindow window(setupWith(recovery));
    window.show();
    QCOMPARE(window.notices().notices().size(), std::size_t(1));
    const QString id = window.notices().notices().front().id;
    QVERIFY2(window.notices().notices().front().text.contains(
                 QStringLiteral("work.yaml were kept when the last session ended")),
             qPrintable(window.notices().notices().front().text));
    QVERIFY(window.open(other));  // which has nothing to do with it
    QVERIFY(!window.notices().has(id));
    QVERIFY(window.open(scenario));
    QVERIFY(window.notices().has(id));
    window.actions().close->trigger();
    QVERIFY(window.isOnStartPage());
    QVERIFY(window.notices().has(id));
    QVERIFY(window.open(scenario));
    window.notices().choose(id, 0);
    QVERIFY(!window.notices().has(id));
    QVERIFY(window.workspace().document().scenario().desktop.seed.value_or(0) >= last);
    window.workspace().document().undoStack().setClean();
  }

  void restore_thenKilledAgain_isStillThere() {
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    const QString dead = leaveACopy(recovery);
    MainWindow window(setupWith(recovery));
    window.notices().choose(dead, 0);
    QVERIFY(!QFile::exists(dead));
    QVERIFY(QFile::exists(window.guard().autosave()->folder() + QStringLiteral("/recovery.json")));
    window.workspace().document().undoStack().setClean();
  }

  void discard_offerIsGone() {
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    const QString dead = leaveACopy(recovery);
    MainWindow window(setupWith(recovery));
    QVERIFY(window.notices().has(dead));
    window.notices().choose(dead, 1);
    QVERIFY(!QFile::exists(dead));
    QVERIFY(window.isOnStartPage());
  }

  void copy_thatIsDamaged_isToldAndKept() {
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    const QString dead = leaveACopy(recovery);
    QVERIFY(QFile::remove(dead + QStringLiteral("/map.pgm")));
    MainWindow window(setupWith(recovery));
    QVERIFY(window.notices().has(dead));
    QVERIFY(window.notices().notices().front().isWarning);
    QVERIFY(QFile::exists(dead));
  }

  void leave_inOrder_leavesNothingBehind() {
    const QString recovery = folder_->filePath(QStringLiteral("recovery"));
    {
      MainWindow window(setupWith(recovery));
      window.files().newOnMap(editor::emptyRoom(4.0, 3.0));
      window.guard().autosave()->writeNow();
      QVERIFY(QFile::exists(window.guard().autosave()->folder() + QStringLiteral("/map.yaml")));
    }
    QVERIFY(editor::Autosave::orphanedFolders(recovery).isEmpty());
    QVERIFY(QDir(recovery).isEmpty());
  }

 private:
  static QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  /// As a crash leaves it: no process holds the lock.
  static QString leaveACopy(const QString& recovery) {
    editor::ScenarioDocument document;
    document.load(sim2d::Scenario());
    document.setMap(editor::emptyRoom(4.0, 3.0));
    const QString folder = recovery + QStringLiteral("/abcdef01");
    const base::Diagnostics problems =
        base::writeFilesAtomically(editor::snapshotFiles(document.snapshot(), folder));
    return problems.empty() ? folder : QString();
  }

  /// The last number the program has told when it told one above `until`; -1: it never did.
  static qint64 readUntil(QProcess& program, qint64 until) {
    qint64 last = -1;
    QElapsedTimer clock;
    clock.start();
    while (last < until && clock.elapsed() < 50000) {
      program.waitForReadyRead(200);
      while (program.canReadLine()) {
        last = program.readLine().trimmed().toLongLong();
      }
    }
    return last;
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

int main(int argc, char** argv) {
  if (argc == 4 && QByteArray(argv[1]) == kEditForEver) {
    return editForEver(argc, argv);
  }
  QApplication application(argc, argv);
  CrashRecoveryTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_CrashRecovery.moc"
