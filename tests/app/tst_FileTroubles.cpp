#include "app/run/Export.h"
#include "app/window/MainWindow.h"
#include "app/window/files/FileCommands.h"
#include "app/window/files/FileDialogs.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

namespace {

QString utf8(const char* text) {
  return QString::fromUtf8(text);
}

}  // namespace

/// Files that are wrong, lost, or cannot be written: what the window tells and offers.
class FileTroublesTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() { end(); }

  void open_mapIsLost_noticeOffersAWayOut() {
    QVERIFY(window_->open(demoOnMap("nowhere")));
    const app::Notice notice = told("map");
    QVERIFY2(notice.text.startsWith(utf8("Map file nowhere.yaml not found, ")),
             qPrintable(notice.text));
    QCOMPARE(notice.choices.size(), std::size_t(2));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    quiet::shoot(*window_, "map-lost");
    window_->setTheme(editor::Theme::dark());
    quiet::shoot(*window_, "map-lost-dark");
    window_->setTheme(editor::Theme::light());
    // a dialog that is cancelled leaves it as it was
    quiet::answerDialog<QDialog>([](QDialog& dialog) { dialog.reject(); });
    window_->notices().choose(utf8("map"), 0);
    QVERIFY(window_->notices().has(utf8("map")));
    window_->notices().choose(utf8("map"), 1);
    QVERIFY(!window_->notices().has(utf8("map")));
    QVERIFY(!window_->docks().panel<editor::IssuesPanel>().hasErrors());
    document().undoStack().undo();
    QVERIFY(window_->notices().has(utf8("map")));
    window_->actions().newOpenPlane->trigger();
    QVERIFY(window_->notices().notices().empty());
  }

  void open_damagedFile_onlyItsMapIsRead_isNotCalledNothing() {
    QVERIFY(base::writeFileAtomically(at("damaged.yaml").toStdString(),
                                      "hunav_loader:\n  ros__parameters:\n    map: nowhere\n"
                                      "   agents: [x\n")
                .empty());
    QVERIFY(!window_->open(at("damaged.yaml")));
    QVERIFY2(told("read-only").text.contains(utf8("only partly loaded")),
             qPrintable(told("read-only").text));
    QVERIFY(told("map").text.startsWith(utf8("Map file nowhere.yaml not found")));
    QVERIFY(
        base::writeFileAtomically(at("nothing.yaml").toStdString(), "hunav_loader: [\n").empty());
    window_->actions().close->trigger();
    QVERIFY(!window_->open(at("nothing.yaml")));
    QVERIFY(told("read-only").text.contains(utf8("cannot be read")));
    QVERIFY(!window_->notices().has(utf8("map")));
  }

  void open_mapIsDamaged_noticeSaysWhatIsWrong() {
    QVERIFY(
        base::writeFileAtomically(at("flat.yaml").toStdString(),
                                  "image: flat.png\nresolution: 0\norigin: [0, 0, 0]\nnegate: 0\n"
                                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
            .empty());
    QVERIFY(window_->open(demoOnMap("flat")));
    const QString text = told("map").text;
    QVERIFY2(text.startsWith(utf8("Map file flat.yaml cannot be used, ")), qPrintable(text));
    QVERIFY2(text.contains(utf8("resolution")), qPrintable(text));
    quiet::shoot(*window_, "map-damaged");
  }

  void open_wrongYaml_isShownUnderItsNameAsReadOnly_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("syntax") << QByteArray("hunav_loader: [\n");
    QTest::newRow("another kind") << QByteArray("services:\n  web: {build: x}\n");
    QTest::newRow("no agents") << QByteArray("hunav_loader:\n  ros__parameters: {map: x}\n");
    QTest::newRow("empty") << QByteArray();
  }
  void open_wrongYaml_isShownUnderItsNameAsReadOnly() {
    QFETCH(QByteArray, text);
    const QString file = at("wrong.yaml");
    QVERIFY(base::writeFileAtomically(file.toStdString(), text.toStdString()).empty());
    QVERIFY(!window_->open(file));
    QVERIFY(!window_->isOnStartPage());
    QVERIFY2(window_->windowTitle().startsWith(utf8("wrong.yaml")),
             qPrintable(window_->windowTitle()));
    QVERIFY(document().isReadOnly());
    QVERIFY(window_->notices().has(utf8("read-only")));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    quiet::shoot(*window_, "wrong-yaml");
  }

  void open_noScenarioAtAll_staysOnTheStartPageAndTells() {
    const QString file = at("notes.txt");
    QVERIFY(base::writeFileAtomically(file.toStdString(), "milk, bread").empty());
    QVERIFY(!window_->open(file));
    QVERIFY(window_->isOnStartPage());
    QVERIFY(told("unread").text.startsWith(utf8("notes.txt cannot be opened: ")));
    quiet::shoot(*window_, "start-unread");
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(window_->notices().notices().empty());
  }

  void open_wrongYaml_keepsTheDocumentThatIsOpen() {
    QVERIFY(window_->open(quiet::demoPath()));
    const sim2d::Scenario before = document().scenario();
    const QString file = at("wrong.yaml");
    QVERIFY(base::writeFileAtomically(file.toStdString(), "hunav_loader: [\n").empty());
    QVERIFY(!window_->open(file));
    QVERIFY(document().scenario() == before);
    QCOMPARE(document().path(), quiet::demoPath());
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    QVERIFY(!window_->files().openNewFromMap(at("no_map.yaml")));
    QVERIFY(document().scenario() == before);
  }

  void save_folderCannotBeWritten_isOneNoticeAndNothingIsLost() {
    QVERIFY(window_->open(quiet::demoPath()));
    editor::pushRemove(document(), {document().entities(base::EntityKind::Human).front()});
    const sim2d::Scenario edited = document().scenario();
    QVERIFY(base::writeFileAtomically(at("file").toStdString(), "no folder").empty());
    QVERIFY(!window_->files().saveTo(at("file/cafe.yaml")));
    const app::Notice notice = told("not-saved");
    QVERIFY2(notice.text.startsWith(utf8("cafe.yaml was not saved: ")), qPrintable(notice.text));
    QVERIFY(notice.text.endsWith(utf8("Your changes are not lost.")));
    QCOMPARE(window_->notices().notices().size(), std::size_t(1));
    QVERIFY(!window_->docks().panel<editor::IssuesPanel>().hasErrors());
    QVERIFY(document().isDirty());
    QVERIFY(document().scenario() == edited);
    quiet::shoot(*window_, "not-saved");
    QVERIFY(window_->files().saveTo(at("cafe.yaml")));
    QVERIFY(window_->notices().notices().empty());
    QVERIFY(!document().isDirty());
  }

  void export_isToldInOneLine() {
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(base::writeFileAtomically(at("file").toStdString(), "no folder").empty());
    app::ExportRequest request;
    request.folder = at("file/out").toStdString();
    QVERIFY(
        !window_->files().exportPlan(app::planExport(window_->files().exportSource(), request)));
    QVERIFY(told("export").isWarning);
    QVERIFY2(told("export").text.startsWith(utf8("Export failed: ")),
             qPrintable(told("export").text));
    quiet::shoot(*window_, "not-exported");
    request.folder = at("out").toStdString();
    const app::ExportPlan plan = app::planExport(window_->files().exportSource(), request);
    QVERIFY(window_->files().exportPlan(plan));
    QCOMPARE(told("export").text,
             utf8("Exported %1 files to %2.").arg(plan.files.size()).arg(at("out")));
    quiet::shoot(*window_, "exported");
    window_->notices().choose(utf8("export"), 0);  // there is no desktop here
    QVERIFY(told("export").isWarning);
    QVERIFY(told("export").text.endsWith(utf8("The files are in %1.").arg(at("out"))));
    QVERIFY(!window_->docks().panel<editor::IssuesPanel>().hasErrors());
  }

  void anotherProgramRemovesTheFile_noticeOffersToSaveItAgain() {
    const QString file = demoOnMap("nowhere");
    QVERIFY(window_->open(file));
    QVERIFY(QFile::rename(file, at("moved.yaml")));
    QTRY_VERIFY(window_->notices().has(utf8("gone")));
    QVERIFY(told("gone").text.startsWith(utf8("demo.yaml was moved or deleted")));
    QVERIFY(QFile::rename(at("moved.yaml"), file));
    QTRY_VERIFY(!window_->notices().has(utf8("gone")));
    QVERIFY(QFile::remove(file));
    QTRY_VERIFY(window_->notices().has(utf8("gone")));
    quiet::shoot(*window_, "gone");
    window_->notices().choose(utf8("gone"), 0);
    QVERIFY(QFile::exists(file));
    QVERIFY(!window_->notices().has(utf8("gone")));
  }

  void statusBar_newDocument_forgetsThePlaceOnTheOldOne() {
    QVERIFY(window_->open(quiet::demoPath()));
    editor::MapView& view = window_->workspace().view();
    Q_EMIT view.cursorMoved(base::Vec2(1.25, 2.5));
    const auto isShown = [this] {
      return widgets::findIf<QLabel>(*window_->statusBar(), [](const QLabel* label) {
               return label->text().startsWith(utf8("1.25, 2.50 m"));
             }) != nullptr;
    };
    QVERIFY(isShown());
    window_->actions().newOpenPlane->trigger();
    QCoreApplication::processEvents();
    QVERIFY(!isShown());
  }

  void imageMap_createsNothingBeforeItsSizeIsKnown() {
    QImage image(400, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QVERIFY(image.save(at("plan.png")));
    const auto grid = editor::gridOfImage(at("plan.png"), 0.05);
    app::ImageMapDialog dialog(*grid, image, editor::Theme::light());
    QPushButton* create = nullptr;
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
      create = button->isDefault() ? button : create;
    }
    QVERIFY(create != nullptr && !create->isEnabled());
    dialog.show();
    quiet::shoot(dialog, "image-empty");
    dialog.view().setPoints({{0.0, 0.0}});
    QVERIFY(!create->isEnabled());
    quiet::shoot(dialog, "image-one");
    dialog.view().setPoints({{0.0, 0.0}, {0.0, 0.0}});
    QVERIFY(!create->isEnabled());  // both on one place
    dialog.view().setPoints({{0.0, 0.0}, {400.0, 200.0}});
    QVERIFY(create->isEnabled());
    QDoubleSpinBox& distance = quiet::part<QDoubleSpinBox>(dialog, "Distance 1 – 2");
    distance.setValue(9000.0);
    QVERIFY(!create->isEnabled());  // no map has cells as large as that
    QVERIFY(!dialog.isMeasured());
    quiet::shoot(dialog, "image-too-large");
    distance.setValue(0.1);
    QVERIFY(!create->isEnabled());
    distance.setValue(7.0);
    QVERIFY(create->isEnabled());
    QCOMPARE(dialog.map()->resolution(), 7.0 / std::sqrt(400.0 * 400.0 + 200.0 * 200.0));
    dialog.view().setPoints({});
    QVERIFY(!create->isEnabled());
    quiet::setResolution(dialog, 0.1);
    QVERIFY(create->isEnabled());
    QCOMPARE(dialog.map()->resolution(), 0.1);
    quiet::shoot(dialog, "image-number");
  }

  void exportReport_sameWordsOfSeveralPeople_areOneLine() {
    const auto note = [](int person, const char* name, const char* keys) {
      base::Diagnostic diagnostic =
          base::withContext(name, base::warning("export.keys-unknown", {keys}));
      diagnostic.entity = {base::EntityKind::Human, person};
      return diagnostic;
    };
    const std::vector<app::GroupedDiagnostic> lines =
        app::groupedByAgents({note(1, "Ana", "mass"), base::warning("export.no-ring"),
                              note(2, "Ben", "mass"), note(3, "Chloe", "route")});
    QCOMPARE(lines.size(), std::size_t(3));
    QCOMPARE(lines[0].diagnostic.message, std::string("2 people: mass: not supported by the "
                                                      "target"));
    QCOMPARE(lines[0].people, (std::vector<std::string>{"Ana", "Ben"}));
    QCOMPARE(lines[1].diagnostic.message,
             std::string("the periodic corridor (wrap_x) is not supported by the target"));
    QCOMPARE(lines[2].diagnostic.message, std::string("Chloe: route: not supported by the target"));
    QVERIFY(lines[2].people.empty());
  }

  void exportDialog_command_isSeenWholeAndCopied() {
    QVERIFY(window_->open(quiet::demoPath()));
    int commands = 0;
    for (const char* target : {"gazebo-classic", "isaac", "native"}) {
      for (const bool isDark : {false, true}) {
        const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
        editor::applyTheme(theme);
        app::ExportDialog dialog(window_->files().exportSource(), at("out"), theme);
        quiet::setTarget(dialog, target);
        dialog.show();
        quiet::shoot(dialog, QByteArray("export-") + target + (isDark ? "-dark" : ""));
        auto* command = dialog.findChild<QPlainTextEdit*>();
        QString shown = command->toPlainText();
        QCOMPARE(shown.replace(utf8(" \\\n  "), utf8(" ")).toStdString(),
                 dialog.plan().startCommand);
        QVERIFY(!command->verticalScrollBar()->isVisible());  // all of it is seen
        QCOMPARE(command->isVisible(), !dialog.plan().startCommand.empty());
        int copies = 0;
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
          if (button->isVisible() && button->text() == utf8("Co&py")) {
            ++copies;
            button->click();
            QCOMPARE(QGuiApplication::clipboard()->text().toStdString(),
                     dialog.plan().startCommand);
          }
        }
        QCOMPARE(copies, command->isVisible() ? 1 : 0);
        commands += copies;
      }
    }
    QVERIFY(commands > 0);
    editor::applyTheme(editor::Theme::light());
  }
};

QTEST_MAIN(FileTroublesTest)
#include "tst_FileTroubles.moc"
