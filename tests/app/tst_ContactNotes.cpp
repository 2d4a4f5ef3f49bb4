#include <QtTest>

#include "ContactScene.h"
#include "QuietWindow.h"
#include "RunFiles.h"
#include "editor/panels/runs/Playback.h"

using namespace outside;

/// Last avoidable actions on the timeline of a recorded run.
class ContactNotesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QFile file(folder_.filePath(text("fast.yaml")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(kFastRobot);
    file.close();
    run_ = folder_.filePath(text("out"));
    const Finished run = runProgram("run % -o % -q", {file.fileName(), run_});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
  }

  void analysedRun_hasNotesOnTheTimeline() {
    const Finished told = runProgram("contacts % -o % --quick -q", {run_, run_});
    QVERIFY2(told.exitCode == 0, qPrintable(told.err));
    auto window = quiet::shownWindow();
    QVERIFY(window->open(run_));
    const editor::RunEvents& events = window->workspace().events();
    QVERIFY(!events.notes().empty());
    double contact = -1.0;
    for (const editor::RunEvent& event : events.events()) {
      if (event.event.kind == sim2d::EventKind::Contact && contact < 0.0) {
        contact = event.time;
      }
    }
    const editor::RunNote& note = events.notes().front();
    QVERIFY2(note.text.startsWith(text("Until here robot1 could avoid the contact with")),
             qPrintable(note.text));
    QVERIFY(note.time > 0.0 && note.time < contact);
    // Its mark is painted in the accent colour.
    auto* const timeline = window->findChild<editor::TimelineBar*>();
    const QImage picture = timeline->grab().toImage();
    const double scale = static_cast<double>(picture.width()) / timeline->width();
    const QColor mark =
        picture.pixelColor(qRound(timeline->xOf(note.time) * scale), qRound(12.0 * scale));
    const QColor accent = window->workspace().theme().color(editor::Role::Accent);
    QVERIFY2(std::abs(mark.hue() - accent.hue()) < 20, qPrintable(mark.name()));
    quiet::shoot(*window, "contact_notes");
    QVERIFY(window->open(quiet::demoPath()));
    QVERIFY(events.notes().empty());
  }

  /// The folder has another run now: its contacts are not those of the file.
  void notesOfAnEarlierRun_areNotShown() {
    const QByteArray analysed = bytesOf(run_ + text("/contacts.json"));
    QVERIFY(!analysed.isEmpty());
    const QString other = folder_.filePath(text("slow"));
    const Finished run = runProgram("run % -o % -q --set robot1.max_vel=0.4",
                                    {folder_.filePath(text("fast.yaml")), other});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QFile file(other + text("/contacts.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(analysed);
    file.close();
    auto window = quiet::shownWindow();
    QVERIFY(window->open(other));
    QVERIFY(window->workspace().events().notes().empty());
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("[{\"run\": 1");
    file.close();
    QVERIFY(window->open(other));
    QVERIFY(window->workspace().events().notes().empty());
  }

 private:
  const QTemporaryDir folder_;
  QString run_;
};

QTEST_MAIN(ContactNotesTest)
#include "tst_ContactNotes.moc"
