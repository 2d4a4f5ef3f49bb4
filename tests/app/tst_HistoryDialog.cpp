#include "QuietWindow.h"
#include "app/window/RunCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/DeferredActions.h"

using app::HistoryDialog;

namespace {

constexpr std::size_t kMega = std::size_t{1} << 20;

QString wordsOf(const QWidget& dialog) {
  QString words;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    words += label->text() + QLatin1Char('\n');
  }
  return words;
}

}  // namespace

/// The memory that runs take to be looked back at.
class HistoryDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void memory_typed_isInBytes() {
    HistoryDialog dialog(256 * kMega, nullptr, editor::Theme::light());
    auto* field = dialog.findChild<QSpinBox*>();
    QCOMPARE(field->text(), QStringLiteral("256 MB"));
    QCOMPARE(dialog.memory(), 256 * kMega);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("1024"));
    QCOMPARE(dialog.memory(), 1024 * kMega);
    QVERIFY(!wordsOf(dialog).contains(QStringLiteral("displayed run")));
  }

  void words_aRunWhoseOldestStatesAreGone_tellFromWhen() {
    auto recording = std::make_shared<sim2d::Recording>(1, 0, "/dev/null/none");
    sim2d::Frame frame;
    for (; frame.step < 200; ++frame.step) {
      frame.time = 0.1 * static_cast<double>(frame.step);
      recording->addState(frame);
    }
    QCOMPARE(recording->first(), std::size_t{199});  // a chunk of one state is kept
    const HistoryDialog dialog(256 * kMega, recording, editor::Theme::light());
    QVERIFY2(wordsOf(dialog).contains(QStringLiteral("starts at 0:19.9")),
             qPrintable(wordsOf(dialog)));
  }

  void action_accepted_countsForTheNextRuns() {
    auto window = quiet::shownWindow();
    editor::SimulationRunner& runner = window->workspace().runner();
    QCOMPARE(runner.historyMemory(), 256 * kMega);
    const auto answer = [&](bool accept) {
      editor::later(*window, [accept] {
        auto* dialog = qobject_cast<HistoryDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog != nullptr);
        dialog->findChild<QSpinBox*>()->setValue(48);
        accept ? dialog->accept() : dialog->reject();
      });
    };
    answer(false);
    window->actions().history->trigger();
    QCOMPARE(runner.historyMemory(), 256 * kMega);
    answer(true);
    window->actions().history->trigger();
    QCOMPARE(runner.historyMemory(), 48 * kMega);
    quiet::leave(window);
  }
};

QTEST_MAIN(HistoryDialogTest)
#include "tst_HistoryDialog.moc"
