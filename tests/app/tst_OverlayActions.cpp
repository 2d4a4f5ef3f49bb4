#include <QSvgRenderer>
#include <QtTest>

#include "QuietWindow.h"
#include "RunFiles.h"
#include "app/window/RunCommands.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/runs/RunInteraction.h"

using namespace outside;

using editor::CanvasOptions;

/// What the map shows over a run, by keys and menus, and figures of it.
class OverlayActionsTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;
  app::Workspace& workspace() { return window_->workspace(); }
  editor::RunOverlayUpdater& layers() {
    return *workspace().view().findChild<editor::RunOverlayUpdater*>();
  }
  void runDemo(double seconds) {
    QVERIFY(window_->open(quiet::demoPath()));
    workspace().runner().setSpeed(1e9);
    workspace().runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().runner().newestFrame() != nullptr &&
                                 workspace().runner().newestFrame()->time > seconds,
                             60000);
    workspace().runner().pause();
    QTRY_COMPARE(workspace().runner().state(), editor::SimulationRunner::State::Paused);
    QCoreApplication::processEvents();
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { quiet::leave(window_); }

  void keys_switchEachOverlay_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("place");
    QTest::newRow("density") << int(Qt::Key_H) << 0;
    QTest::newRow("sight") << int(Qt::Key_E) << 1;
    QTest::newRow("gaussian") << int(Qt::Key_X) << 2;
    QTest::newRow("velocities") << int(Qt::Key_V) << 3;
    QTest::newRow("plans") << int(Qt::Key_P) << 4;
    QTest::newRow("contacts") << int(Qt::Key_C) << 5;
    QTest::newRow("thoughts") << int(Qt::Key_T) << 6;
    QTest::newRow("speech") << int(Qt::Key_B) << 7;
    QTest::newRow("local costmap") << int(Qt::Key_M) << 8;
    QTest::newRow("global costmap") << int(Qt::Key_K) << 9;
    QTest::newRow("filter masks") << int(Qt::Key_J) << 10;
  }
  void keys_switchEachOverlay() {
    QFETCH(int, key);
    QFETCH(int, place);
    bool CanvasOptions::*const options[] = {
        &CanvasOptions::density,     &CanvasOptions::sight,  &CanvasOptions::gaussian,
        &CanvasOptions::velocities,  &CanvasOptions::plans,  &CanvasOptions::contacts,
        &CanvasOptions::thoughts,    &CanvasOptions::speech, &CanvasOptions::localCosts,
        &CanvasOptions::globalCosts, &CanvasOptions::masks};
    QVERIFY(window_->open(quiet::demoPath()));
    QAction& action = *window_->actions().runOverlays.at(place);
    const bool before = workspace().scene().options().*options[place];
    QCOMPARE(action.isChecked(), before);
    QCOMPARE(before, place == 7);  // speech alone is on at first
    workspace().view().setFocus();
    QTest::keyClick(window_->windowHandle(), Qt::Key(key), Qt::ShiftModifier);
    QCOMPARE(workspace().scene().options().*options[place], !before);
    QCOMPARE(action.isChecked(), !before);
    action.trigger();
    QCOMPARE(workspace().scene().options().*options[place], before);
  }

  void thoughts_ofARun_areWords() {
    runDemo(2.0);
    workspace().runner().seek(30);  // wherever it came to: on the way to the first goal
    window_->actions().runOverlays.at(6)->trigger();  // thoughts
    QTRY_VERIFY(!workspace().scene().overlays().thoughtOf(1).isEmpty());
    const int id = workspace().document().scenario().humans.front().id;
    const QString words = layers().tooltipFor(id);
    QVERIFY2(words.startsWith(
                 QString::fromStdString(workspace().document().scenario().humans.front().name)),
             qPrintable(words));
    QVERIFY2(words.contains(text("walks to the goal")) || words.contains(text("because")),
             qPrintable(words));
    QVERIFY(words.contains(text("m/s")));
    QVERIFY(layers().tooltipFor(12345).isEmpty());
    QVERIFY(layers().tooltipFor(-1).contains(text("m/s")));  // the robot
  }

  void hover_overSomebody_tellsWhoItIs() {
    runDemo(1.0);
    const sim2d::Frame& frame = *workspace().runner().shownFrame();
    const base::Vec2 place(frame.humans.x[0], frame.humans.y[0]);
    const QPoint at = workspace().view().viewportFrom(place);
    QHelpEvent help(QEvent::ToolTip, at, workspace().view().viewport()->mapToGlobal(at));
    QCoreApplication::sendEvent(workspace().view().viewport(), &help);
    QCOMPARE(QToolTip::text(), layers().tooltipFor(frame.humans.id[0]));
  }

  void copyAsFigure_givesPixelsAndVectors() {
    QVERIFY(window_->open(quiet::demoPath()));
    QAction& copy = *window_->actions().copyFigure;
    QVERIFY(!copy.isEnabled());
    runDemo(2.0);
    QVERIFY(copy.isEnabled());
    window_->actions().runOverlays.at(0)->trigger();  // density
    copy.trigger();
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const QImage image = qvariant_cast<QImage>(data->imageData());
    QVERIFY(std::abs(image.width() - 170.0 / 25.4 * 300.0) < 3.0);  // 170 mm at 300 dpi
    QSvgRenderer vectors(data->data(text("image/svg+xml")));
    QVERIFY(vectors.isValid());
    QVERIFY(std::abs(vectors.viewBoxF().width() - 170.0 / 25.4 * 96.0) < 1.0);
    QVERIFY(!data->data(text("image/svg+xml")).contains("<text"));
  }

  void copyPlot_isOfTheMetricThatIsSelected() {
    runDemo(3.0);
    QAction& copy = *window_->actions().copyPlot;
    QTRY_VERIFY_WITH_TIMEOUT(copy.isEnabled(), 20000);
    QGuiApplication::clipboard()->clear();
    copy.trigger();
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    QVERIFY(data->hasImage());
    QSvgRenderer vectors(data->data(text("image/svg+xml")));
    QVERIFY(vectors.isValid());
  }

  void savePlot_writesTheFormatOfTheEnding_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("PNG") << text("png") << QByteArray("\x89PNG");
    QTest::newRow("SVG") << text("svg") << QByteArray("<svg");
    QTest::newRow("PDF") << text("pdf") << QByteArray("%PDF");
  }
  void savePlot_writesTheFormatOfTheEnding() {
    QFETCH(QString, ending);
    QFETCH(QByteArray, start);
    runDemo(3.0);
    QAction& save = *window_->actions().savePlot;
    QTRY_VERIFY_WITH_TIMEOUT(save.isEnabled(), 20000);
    QTemporaryDir folder;
    const QString file = folder.filePath(text("plot.") + ending);
    quiet::answerDialog<QFileDialog>([&file](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>(text("fileNameEdit"))->setText(file);
      QTest::keyClick(&dialog, Qt::Key_Return);
    });
    save.trigger();
    QFile saved(file);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    const QByteArray bytes = saved.readAll();
    QVERIFY2(bytes.left(200).contains(start), bytes.left(60).constData());
    if (ending == text("png")) {  // 170 mm at 300 dpi
      QVERIFY(std::abs(QImage::fromData(bytes).width() - 170.0 / 25.4 * 300.0) < 3.0);
    }
  }

  void picture_withOverlays_isMadeByTheCommandLine() {
    QTemporaryDir folder;
    const auto shoot = [&folder](const QStringList& more) {
      return runProgram(
          list("% --at 1 --screenshot %", {quiet::demoPath(), folder.filePath(text("x.png"))}) +
          more);
    };
    const QString name = QString::fromStdString(
        sim2d::readScenario(quiet::demoPath().toStdString()).scenario.humans.front().name);
    const Finished made = shoot({text("--overlay"), text("sight,density"), text("--select"), name});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QVERIFY(!QImage(folder.filePath(text("x.png"))).isNull());
    const Finished told = shoot({text("--select"), text("Nobody")});
    QVERIFY2(told.exitCode != 0 && told.err.contains(text("no person or robot 'Nobody'")),
             qPrintable(told.err));
    QVERIFY(shoot({text("--overlay"), text("fog")}).exitCode == 64);
  }

  void figureTrace_endsAtTheMoment() {
    runDemo(3.0);
    const sim2d::Trace trace = app::figureTrace(*workspace().runner().recording(), 1.5);
    QVERIFY(std::abs(trace.frames.back().time - 1.5) < 0.051);
    QVERIFY(trace.frames.front().time == 0.0);
    QVERIFY(!trace.frames.back().forces.goal.empty());  // of a run that was made here
  }
};

QTEST_MAIN(OverlayActionsTest)
#include "tst_OverlayActions.moc"
