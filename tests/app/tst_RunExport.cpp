#include <QImageReader>
#include <QStandardItemModel>
#include <QtTest>

#include "QuietWindow.h"
#include "RunFiles.h"
#include "app/cli/RunPicture.h"
#include "app/window/RunCommands.h"
#include "app/window/export/RunExportDialog.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"

using app::ExportSource;
using app::SaveFilmDialog;
using app::SavePictureDialog;
using editor::SimulationRunner;
using namespace outside;

namespace {

constexpr int kLongMs = 60000;

/// Types a number into a field, as a user does.
void typeInto(QAbstractSpinBox& field, const QString& number) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, number);
  field.interpretText();  // as when the focus leaves; the window need not be active
}

void choose(QComboBox& box, const QString& words) {
  for (int k = 0; k < box.count(); ++k) {
    if (box.itemText(k).startsWith(words)) {
      box.setFocus();
      QTest::keyClick(&box, Qt::Key_Home);
      for (int step = 0; step < k; ++step) {
        QTest::keyClick(&box, Qt::Key_Down);
      }
    }
  }
  QVERIFY2(box.currentText().startsWith(words), qPrintable(box.currentText()));
}

QPushButton& button(const QDialog& dialog, const char* words) {
  return *widgets::withText<QPushButton>(dialog, text(words));
}

/// The source of a dialog without a window: a person and a robot who walk for `seconds`.
ExportSource walk(double seconds, int steps) {
  auto trace = std::make_shared<sim2d::Trace>();
  trace->header.scenario = "walk";
  trace->header.dt = seconds / steps;
  sim2d::TraceHuman human;
  human.id = 1;
  human.name = "anna";
  trace->header.humans.push_back(human);
  for (int step = 0; step <= steps; ++step) {
    sim2d::Frame frame;
    frame.step = step;
    frame.time = step * trace->header.dt;
    frame.humans.id.push_back(1);
    frame.humans.x.push_back(frame.time);
    frame.humans.y.push_back(1.0);
    frame.humans.heading.push_back(0.0);
    frame.humans.vx.push_back(1.0);
    frame.humans.vy.push_back(0.0);
    trace->frames.push_back(frame);
  }
  ExportSource source;
  source.name = text("walk");
  source.to = seconds;
  source.shown = seconds;
  source.trace = [trace] { return base::Result<sim2d::Trace>(*trace); };
  return source;
}

}  // namespace

/// Pictures and films of runs, saved from the window.
class RunExportTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  /// The file dialog that opens next gets this path.
  static void answerFile(const QString& file) {
    quiet::answerDialog<QFileDialog>([file](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>(text("fileNameEdit"))->setText(file);
      QMetaObject::invokeMethod(&dialog, "accept");
    });
  }
  /// Opens a dialog of the window by its command, changes it, and saves to the file.
  template <class Dialog>
  void saveAs(QAction& command, const QString& file, const std::function<void(Dialog&)>& change) {
    quiet::answerDialog<Dialog>([file, change](Dialog& dialog) {
      QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), kLongMs);
      dialog.activateWindow();
      QVERIFY(QTest::qWaitForWindowActive(&dialog));
      change(dialog);
      answerFile(file);
      QTest::mouseClick(&button(dialog, "Save…"), Qt::LeftButton);
    });
    command.trigger();  // returns when the dialog has been closed
  }

 private Q_SLOTS:
  void initTestCase() {
    qSetGlobalQHashSeed(0);  // as the program: the order of fonts in a PDF
    editor::applyTheme(editor::Theme::light());
    QCOMPARE(failureOf("run % --duration 4 -q -o %", {quiet::demoPath(), path("run")}), QString());
  }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { quiet::leave(window_); }

  void picture_ofARecordedRun_hasTheBytesOfTheCommand_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QString>("format");
    QTest::newRow("png") << text("png") << text("PNG");
    QTest::newRow("svg") << text("svg") << text("SVG");
    QTest::newRow("pdf") << text("pdf") << text("PDF");
  }
  void picture_ofARecordedRun_hasTheBytesOfTheCommand() {
    QFETCH(QString, ending);
    QFETCH(QString, format);
    const QString ours = path(text("ours.") + ending), theirs = path(text("theirs.") + ending);
    QCOMPARE(failureOf("render % -o % --at 2.5 --overlay velocities --time-marks 1",
                       {path("run"), theirs}),
             QString());
    QVERIFY(window_->open(path("run")));
    saveAs<SavePictureDialog>(
        *window_->actions().savePicture, ours, [format](SavePictureDialog& dialog) {
          choose(quiet::part<QComboBox>(dialog, "Format"), format);
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Time"), text("2.5"));
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Time marks"), text("1"));
          QTest::mouseClick(widgets::withText<QCheckBox>(dialog, text("Velocities")),
                            Qt::LeftButton, {}, QPoint(8, 8));
        });
    QVERIFY(bytesOf(ours).size() > 1000);
    const auto drawn = [](const QString& file) {  // SVG: text is outlines, so no font is used
      return QString::fromLatin1(bytesOf(file))
          .remove(QRegularExpression(QStringLiteral("\\sfont-[a-z]+=\"[^\"]*\"")));
    };
    QVERIFY(ending == text("svg") ? drawn(ours) == drawn(theirs)
                                  : bytesOf(ours) == bytesOf(theirs));
  }

  void film_ofARecordedRun_hasTheBytesOfTheCommand() {
    QCOMPARE(failureOf("render % -o % --fps 10 --speed 2 --width 640",
                       {path("run"), path("theirs.gif")}),
             QString());
    QVERIFY(window_->open(path("run")));
    saveAs<SaveFilmDialog>(
        *window_->actions().saveFilm, path("ours.gif"), [](SaveFilmDialog& dialog) {
          choose(quiet::part<QComboBox>(dialog, "Size"), text("Small"));
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Frame rate"), text("10"));
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Speed"), text("2"));
          QCOMPARE(dialog.timing().frameCount(), 21LL);  // 0, 0.2 … 4 s
        });
    QVERIFY(bytesOf(path("ours.gif")).size() > 1000);
    QVERIFY(bytesOf(path("ours.gif")) == bytesOf(path("theirs.gif")));
  }

  void film_mp4_isWrittenByFfmpeg() {
    if (!app::Movie::isAvailable(".mp4")) {
      QSKIP("ffmpeg is not installed");
    }
    QVERIFY(window_->open(path("run")));
    saveAs<SaveFilmDialog>(*window_->actions().saveFilm, path("film.mp4"),
                           [](SaveFilmDialog& dialog) {
                             choose(quiet::part<QComboBox>(dialog, "Format"), text("MP4"));
                             choose(quiet::part<QComboBox>(dialog, "Size"), text("Small"));
                             typeInto(quiet::part<QAbstractSpinBox>(dialog, "To"), text("1"));
                           });
    QCOMPARE(bytesOf(path("film.mp4")).mid(4, 4), QByteArray("ftyp"));
  }

  void film_ofASection_hasItsFrames() {
    QVERIFY(window_->open(path("run")));
    saveAs<SaveFilmDialog>(*window_->actions().saveFilm, path("part.gif"),
                           [](SaveFilmDialog& dialog) {
                             QPushButton& save = button(dialog, "Save…");
                             typeInto(quiet::part<QAbstractSpinBox>(dialog, "From"), text("3"));
                             typeInto(quiet::part<QAbstractSpinBox>(dialog, "To"), text("2"));
                             QVERIFY(!save.isEnabled());  // the end is before the start
                             typeInto(quiet::part<QAbstractSpinBox>(dialog, "To"), text("3.5"));
                             QVERIFY(save.isEnabled());
                             choose(quiet::part<QComboBox>(dialog, "Size"), text("Small"));
                           });
    QImageReader film(path("part.gif"));
    QCOMPARE(film.imageCount(), 11);  // 3, 3.05 … 3.5 s
  }

  void picture_ofARunOfTheWindow_isDrawnWithItsTheme() {
    QVERIFY(window_->open(quiet::demoPath()));
    SimulationRunner& runner = window_->workspace().runner();
    runner.setSpeed(1e9);
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.newestFrame() && runner.newestFrame()->time > 2.0, kLongMs);
    saveAs<SavePictureDialog>(*window_->actions().savePicture, path("dark.png"),
                              [&runner](SavePictureDialog& dialog) {
                                QCOMPARE(runner.state(), SimulationRunner::State::Paused);
                                choose(quiet::part<QComboBox>(dialog, "Theme"), text("Dark"));
                                choose(quiet::part<QComboBox>(dialog, "Size"), text("Slide"));
                                QVERIFY(widgets::withText<QCheckBox>(dialog, text("Forces"))
                                            ->isEnabled());  // they are in memory
                              });
    const QImage image(path("dark.png"));
    QCOMPARE(image.size(), QSize(1920, 1080));
    QCOMPARE(image.pixelColor(2, 2), QColor(0x2A, 0x2E, 0x33));  // the dark map's free space
    QVERIFY(window_->statusBar()->currentMessage().contains(path("dark.png")));
  }

  void picture_ofAScenario_showsItsStart() {
    QVERIFY(!window_->actions().savePicture->isEnabled());  // the start page
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(!window_->actions().saveFilm->isEnabled());
    saveAs<SavePictureDialog>(
        *window_->actions().savePicture, path("start.svg"), [](SavePictureDialog& dialog) {
          QVERIFY(widgets::named<QAbstractSpinBox>(dialog, text("Time")) == nullptr);
          choose(quiet::part<QComboBox>(dialog, "Format"), text("SVG"));
          QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().image().isNull(), kLongMs);
          quiet::shoot(dialog, "save_picture_start");
        });
    QVERIFY(bytesOf(path("start.svg")).size() > 5000);
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Editing);
    QVERIFY(!window_->workspace().document().isDirty());
  }

  void map_ofARecordedCustomTree_hasItsColour() {
    sim2d::Trace trace = *walk(1.0, 10).trace();
    const app::FigureSizes sizes(1600.0);
    const app::FigureText words(false);
    QCOMPARE(app::FigureMap(trace, sizes, words, {}).lookOf(1), editor::Look::Regular);
    trace.header.humans.front().customTree = true;
    QCOMPARE(app::FigureMap(trace, sizes, words, {}).lookOf(1), editor::Look::CustomTree);
  }

  void picture_ofAPersonWithACustomTree_hasItsColour() {
    QVERIFY(window_->open(quiet::demoPath()));
    editor::ScenarioDocument& document = window_->workspace().document();
    const sim2d::Human person = document.scenario().humans.front();
    const editor::MapScene& scene = window_->workspace().scene();
    QVERIFY(app::figureOptionsOf(scene).customTrees.empty());
    const QColor green = editor::Theme::light().fill(editor::Look::CustomTree);
    const auto greenPixels = [&] {
      const QImage image(path("tree.png"));
      int count = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          count += image.pixelColor(x, y) == green ? 1 : 0;
        }
      }
      return count;
    };
    const auto save = [this] {
      saveAs<SavePictureDialog>(*window_->actions().savePicture, path("tree.png"),
                                [](SavePictureDialog& dialog) {
                                  choose(quiet::part<QComboBox>(dialog, "Size"), text("Slide"));
                                });
    };
    save();
    QCOMPARE(greenPixels(), 0);
    editor::pushTreeText(document, person.key,
                         "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><AlwaysSuccess/>"
                         "</BehaviorTree></root>",
                         text("Tree"));
    QCOMPARE(app::figureOptionsOf(scene).customTrees, std::set<int>{person.id});
    QVERIFY(QFile::remove(path("tree.png")));
    save();
    QVERIFY2(greenPixels() > 40, qPrintable(QString::number(greenPixels())));
  }

  /// Three people pass each other: their names stay apart.
  void names_ofAFilm_doNotCoverEachOther() {
    sim2d::Trace trace = *walk(4.0, 80).trace();
    for (const int id : {2, 3}) {
      sim2d::TraceHuman other = trace.header.humans.front();
      other.id = id;
      other.name = id == 2 ? "benjamin" : "christine";
      trace.header.humans.push_back(other);
      for (sim2d::Frame& frame : trace.frames) {
        frame.humans.id.push_back(id);
        frame.humans.x.push_back(id == 2 ? 4.0 - frame.time : 2.0);
        frame.humans.y.push_back(id == 2 ? 1.3 : 2.0);
        frame.humans.heading.push_back(0.0);
        frame.humans.vx.push_back(0.0);
        frame.humans.vy.push_back(0.0);
      }
    }
    const app::FigureSizes sizes(1600.0);
    const app::FigureText words(false);
    app::FigureMap map(trace, sizes, words, {});
    map.place(QRectF(0.0, 0.0, 600.0, 400.0));
    QImage image(600, 400, QImage::Format_RGB32);
    QPainter painter(&image);
    for (int k = 0; k <= 80; ++k) {
      map.paint(painter, 0.05 * k);
      const std::vector<QRectF>& names = map.nameRects();
      QCOMPARE(names.size(), std::size_t{3});
      for (std::size_t a = 0; a < names.size(); ++a) {
        QVERIFY(!names[a].isNull());
        for (std::size_t b = 0; b < a; ++b) {
          QVERIFY(!names[a].intersects(names[b]));
        }
      }
    }
  }

  /// The trajectories are in the legend if there are any.
  void legend_ofAStart_hasNoLines() {
    const auto dashes = [](std::size_t frames) {  // Pixels of the line colour left of the name.
      sim2d::Trace trace = *walk(4.0, 4).trace();
      trace.frames.resize(frames);
      app::RunPicture picture(trace, {});
      QImage image(picture.size().toSize(), QImage::Format_RGB32);
      image.fill(picture.ground());
      QPainter painter(&image);
      picture.paint(painter, 0.0);
      painter.end();
      const int left = qRound(picture.size().width() - app::FigureSizes(1600.0).legend());
      const QColor line = editor::Theme::light().line(editor::Look::Regular);
      int count = 0;
      for (int y = 0; y < image.height(); ++y) {
        count += image.pixelColor(left + 24, y) == line ? 1 : 0;
      }
      return count;
    };
    QVERIFY(dashes(5) > 0);
    QCOMPARE(dashes(1), 0);
  }

  void customSize_typed_isThatOfTheFile() {
    QVERIFY(window_->open(path("run")));
    saveAs<SavePictureDialog>(
        *window_->actions().savePicture, path("free.png"), [](SavePictureDialog& dialog) {
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Width"), text("1000"));
          typeInto(quiet::part<QAbstractSpinBox>(dialog, "Height"), text("500"));
          QCOMPARE(quiet::part<QComboBox>(dialog, "Size").currentText(), text("Custom"));
        });
    QCOMPARE(QImage(path("free.png")).size(), QSize(1000, 500));
  }

  void forPrint_has300Dpi() {
    QVERIFY(window_->open(path("run")));
    saveAs<SavePictureDialog>(
        *window_->actions().savePicture, path("print.png"), [](SavePictureDialog& dialog) {
          choose(quiet::part<QComboBox>(dialog, "Size"), text("Paper, one column"));
        });
    QCOMPARE(QImage(path("print.png")).width(), qRound(85.0 / 25.4 * 300.0));
  }

  void preview_follows_eachField() {
    SavePictureDialog dialog(walk(4.0, 80), {}, editor::Theme::light());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    const auto settled = [&dialog] {
      [&] { QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().isBusy(), kLongMs); }();
      return dialog.preview().image();
    };
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().image().isNull(), kLongMs);
    QImage before = settled();
    const auto changes = [&](const char* what) {
      const QImage now = settled();
      QVERIFY2(now != before, what);
      before = now;
    };
    typeInto(quiet::part<QAbstractSpinBox>(dialog, "Time"), text("1"));
    changes("time");
    choose(quiet::part<QComboBox>(dialog, "Theme"), text("Dark"));
    changes("theme");
    QTest::mouseClick(widgets::withText<QCheckBox>(dialog, text("Hall zones")), Qt::LeftButton, {},
                      QPoint(8, 8));
    changes("overlay");
    choose(quiet::part<QComboBox>(dialog, "Size"), text("Paper, one column"));
    changes("size");
  }

  void fields_thatNeedARun_sayWhy() {
    ExportSource source = walk(1.0, 20);
    source.isRun = false;
    const SavePictureDialog dialog(source, {}, editor::Theme::light());
    const auto* forces = widgets::withText<QCheckBox>(dialog, text("Forces"));
    const auto* contacts = widgets::withText<QCheckBox>(dialog, text("Contacts"));
    const auto* zones = widgets::withText<QCheckBox>(dialog, text("Hall zones"));
    QVERIFY(!forces->isEnabled() && !contacts->isEnabled() && zones->isEnabled());
    QVERIFY(forces->toolTip().startsWith(text("Recorded runs contain no forces")));
    QVERIFY(contacts->toolTip().startsWith(text("Only a run has this")));
    QVERIFY(zones->toolTip().contains(text("0.45, 1.2 and 3.6 m")));
  }

  void film_itsLengthAndRate_areExplained() {
    const SaveFilmDialog dialog(walk(2.0, 40), {}, editor::Theme::light());
    QVERIFY(widgets::findIf<QLabel>(dialog, [](const QLabel* label) {
              return label->text().startsWith(text("The film has 41 frames and lasts 2."));
            }) != nullptr);
    QVERIFY(quiet::part<QAbstractSpinBox>(dialog, "Frame rate")
                .toolTip()
                .startsWith(text("Frames per second of the film; GIF viewers")));
  }

  void film_stopped_writesNothing() {
    const QString file = path("stopped.gif");
    SaveFilmDialog dialog(
        walk(600.0, 6000), [&file](const QString&, const QString&) { return file; },
        editor::Theme::light());
    dialog.show();
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), kLongMs);
    QTest::mouseClick(&button(dialog, "Save…"), Qt::LeftButton);
    QVERIFY(dialog.isWriting());
    auto& bar = quiet::part<QProgressBar>(dialog, "Progress");
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible() && bar.maximum() == 12001, kLongMs);
    quiet::shoot(dialog, "save_film_progress");
    QTest::mouseClick(&button(dialog, "Stop"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.isWriting(), kLongMs);
    QVERIFY(dialog.isVisible() && dialog.savedFile().isEmpty());
    QVERIFY(!QFile::exists(file));
    QVERIFY(widgets::withText<QLabel>(dialog, text("Stopped. No file was written.")) != nullptr);
    QTest::keyClick(&dialog, Qt::Key_Escape);  // nothing is written: the dialog closes
    QVERIFY(!dialog.isVisible());
  }

  void film_withoutFfmpeg_saysSoBefore() {
    const QByteArray programs = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    const SaveFilmDialog dialog(walk(1.0, 20), {}, editor::Theme::light());
    qputenv("PATH", programs);
    const auto& formats = quiet::part<QComboBox>(dialog, "Format");
    const auto* model = qobject_cast<const QStandardItemModel*>(formats.model());
    for (int k = 0; k < formats.count(); ++k) {
      const bool isGif = formats.itemText(k) == text("GIF");
      QCOMPARE(model->item(k)->isEnabled(), isGif);
      QCOMPARE(formats.itemText(k).contains(text("requires ffmpeg")), !isGif);
    }
    QVERIFY(widgets::findIf<QLabel>(dialog, [](const QLabel* label) {
              return label->text().contains(text("sudo apt install ffmpeg"));
            }) != nullptr);
  }

  void folder_thatCannotBeWritten_isReportedInTheDialog() {
    SavePictureDialog dialog(
        walk(1.0, 20), [](const QString&, const QString&) { return text("/proc/none/x.png"); },
        editor::Theme::light());
    dialog.show();
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), kLongMs);
    QTest::mouseClick(&button(dialog, "Save…"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.isWriting(), kLongMs);
    QVERIFY(dialog.isVisible());
    QVERIFY(widgets::findIf<QLabel>(dialog, [](const QLabel* label) {
              return label->text().startsWith(text("Not saved: "));
            }) != nullptr);
  }

  void dialogs_areShown() {
    QVERIFY(window_->open(path("run")));
    window_->workspace().runner().seek(60);
    for (const bool isDark : {false, true}) {
      window_->setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
      quiet::answerDialog<SavePictureDialog>([isDark](SavePictureDialog& dialog) {
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().image().isNull(), kLongMs);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().isBusy(), kLongMs);
        quiet::shoot(dialog, isDark ? "save_picture_dark" : "save_picture_light");
        dialog.reject();
      });
      window_->actions().savePicture->trigger();
      quiet::answerDialog<SaveFilmDialog>([isDark](SaveFilmDialog& dialog) {
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().image().isNull(), kLongMs);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.preview().isBusy(), kLongMs);
        quiet::shoot(dialog, isDark ? "save_film_dark" : "save_film_light");
        dialog.reject();
      });
      window_->actions().saveFilm->trigger();
    }
    window_->setTheme(editor::Theme::light());
  }
};

QTEST_MAIN(RunExportTest)
#include "tst_RunExport.moc"
