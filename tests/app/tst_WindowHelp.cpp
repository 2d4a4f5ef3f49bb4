#include "app/window/help/CommandPalette.h"
#include "app/window/help/ManualViewer.h"
#include "app/window/help/WhatsThis.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/MetricsTable.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/trees/TreeEditor.h"
#include "tests/app/QuietWindow.h"

/// Takes the place of the desktop's browser.
class Browser : public QObject {
  Q_OBJECT
 public:
  Browser() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "show"); }
  ~Browser() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
  Q_DISABLE_COPY_MOVE(Browser)
  QList<QUrl> shown;
 public Q_SLOTS:
  void show(const QUrl& url) { shown << url; }
};

/// The command palette, F1 and *What's this?*, with real keys and clicks.
class WindowHelpTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  app::CommandPalette& palette() { return window_->help().palette(); }
  void openPalette() {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_->windowHandle(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(palette().isVisible());
  }
  QListWidgetItem& row(int index) { return *palette().list().item(index); }
  /// A manual of two pages; F1 shows its Markdown.
  app::WindowSetup withManual() const {
    for (const char* page : {"metrics.md", "index.md"}) {
      QFile file(at(page));
      if (file.open(QIODevice::WriteOnly)) {
        file.write("(label)=\n# Title of ");
        file.write(page);
        file.write(
            "\n\n```{include} part.md\n```\n\n```{note}\nMind the gap.\n```\n\nSee "
            "[index](index.md#lower-part).\n\n");
        file.write(QByteArray("Text.\n\n").repeated(80));
        file.write("## Lower part\n\nEnd.\n");
      }
    }
    QFile part(at("part.md"));
    if (part.open(QIODevice::WriteOnly)) {
      part.write("Included, see [](metrics.md).\n");
    }
    app::WindowSetup setup = quiet::setup();
    setup.manual.markdown = folder_->path();
    return setup;
  }
  void restart(const app::WindowSetup& setup) {
    quiet::leave(window_);
    window_ = quiet::shownWindow(setup);
    QVERIFY(window_->open(quiet::demoPath()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() {
    palette().hide();
    end();
  }

  void score_lettersInOrder_bestForBeginnings_data() {
    QTest::addColumn<QString>("query");
    QTest::addColumn<QString>("better");
    QTest::addColumn<QString>("worse");
    QTest::newRow("initials") << "zf"
                              << "Zoom fit"
                              << "Blizzard of paper";
    QTest::newRow("beginning") << "gri"
                               << "Grid"
                               << "Snap to the grid";
    QTest::newRow("adjacent") << "run"
                              << "Open run"
                              << "Reopen unit";
    QTest::newRow("spaces") << "snap grid"
                            << "Snap to the grid"
                            << "Snapping of a big red icon of dots";
  }
  void score_lettersInOrder_bestForBeginnings() {
    QFETCH(QString, query);
    QFETCH(QString, better);
    QFETCH(QString, worse);
    const std::optional<int> more = app::fuzzyScore(query, better);
    QVERIFY(more.has_value());
    QVERIFY(*more > app::fuzzyScore(query, worse).value_or(-1));
  }

  void score_missingOrSwappedLetter_doesNotMatch() {
    QVERIFY(!app::fuzzyScore(QStringLiteral("gird"), QStringLiteral("Grid")));
    QVERIFY(!app::fuzzyScore(QStringLiteral("x"), QStringLiteral("Grid")));
    QVERIFY(app::fuzzyScore(QStringLiteral("GRD"), QStringLiteral("Grid")));
    QCOMPARE(app::fuzzyScore(QString(), QStringLiteral("Grid")), std::optional<int>(0));
  }

  void palette_everyCommandOfTheMenus_isListed() {
    openPalette();
    QStringList listed;
    for (int i = 0; i < palette().list().count(); ++i) {
      listed << row(i).data(app::CommandPalette::kPathRole).toString() + row(i).text();
    }
    QSet<const QAction*> actions;
    std::function<void(const QMenu&)> look = [&](const QMenu& menu) {
      for (const QAction* action : menu.actions()) {
        if (action->menu() != nullptr) {
          look(*action->menu());
        } else if (!action->isSeparator() && action->isVisible()) {
          actions << action;
          const QString name = app::commandName(*action);
          QVERIFY2(std::any_of(listed.begin(), listed.end(),
                               [&name](const QString& each) { return each.endsWith(name); }),
                   qPrintable(name));
        }
      }
    };
    for (const QAction* top : window_->menuBar()->actions()) {
      look(*top->menu());
    }
    QVERIFY(actions.size() > 80);
    QCOMPARE(palette().list().count(), actions.size());  // once each
    quiet::shoot(palette(), "palette");
  }

  void palette_typedAndEnter_runsTheCommand() {
    openPalette();
    const bool before = window_->actions().grid->isChecked();
    QTest::keyClicks(&palette().search(), QStringLiteral("grd"));
    QCOMPARE(row(0).text(), QStringLiteral("Grid"));
    QCOMPARE(row(0).data(app::CommandPalette::kKeysRole).toString(), QStringLiteral("Shift+G"));
    QTest::keyClick(&palette().search(), Qt::Key_Return);
    QTRY_VERIFY(!palette().isVisible());
    QTRY_COMPARE(window_->actions().grid->isChecked(), !before);
  }

  void palette_lettersScatteredOverTheMenus_doNotMatch() {
    openPalette();
    QTest::keyClicks(&palette().search(), QStringLiteral("copy"));
    QVERIFY(palette().list().count() >= 2);
    for (int i = 0; i < palette().list().count(); ++i) {
      QVERIFY2(row(i).text().contains(QStringLiteral("Copy")), qPrintable(row(i).text()));
    }
    palette().search().clear();
    QTest::keyClicks(&palette().search(), QStringLiteral("arrange tops"));  // menu and name
    QVERIFY(row(0).text().contains(QStringLiteral("tops")));
  }

  /// No name contains the words; explanations of panels do.
  void palette_wordsOfExplanations_findTheirCommands() {
    openPalette();
    const auto isFound = [this](const char* typed, const char* name) {
      palette().search().clear();
      QTest::keyClicks(&palette().search(), QString::fromLatin1(typed));
      for (int i = 0; i < palette().list().count(); ++i) {
        if (row(i).text() == QLatin1String(name)) {
          return true;
        }
      }
      return false;
    };
    QVERIFY(isFound("planners seeds", "Study"));
    QVERIFY(isFound("recorded compare", "Runs"));
    palette().search().clear();
  }

  void palette_cursorKeys_moveInTheList() {
    openPalette();
    QTest::keyClick(&palette().search(), Qt::Key_Down);
    QTest::keyClick(&palette().search(), Qt::Key_Down);
    QCOMPARE(palette().list().currentRow(), 2);
    QVERIFY(palette().search().hasFocus());
    QTest::keyClick(&palette().search(), Qt::Key_Escape);
    QTRY_VERIFY(!palette().isVisible());
  }

  void palette_keyTyped_findsItsCommand() {
    openPalette();
    QTest::keyClicks(&palette().search(), QStringLiteral("ctrl+g"));
    QCOMPARE(row(0).text(), QStringLiteral("Assign goals"));
  }

  void palette_disabledCommand_isLastWithItsReasonAndDoesNothing() {
    document().setSelection({});
    openPalette();
    QTest::keyClicks(&palette().search(), QStringLiteral("duplicate"));
    QCOMPARE(row(0).text(), QStringLiteral("Duplicate"));
    QCOMPARE(row(0).data(app::CommandPalette::kReasonRole).toString(),
             QStringLiteral("Select something first"));
    QVERIFY(widgets::withText<QLabel>(palette(), QStringLiteral("Select something first")) !=
            nullptr);
    const std::size_t people = document().scenario().humans.size();
    QTest::keyClick(&palette().search(), Qt::Key_Return);
    QVERIFY(palette().isVisible());
    QCOMPARE(document().scenario().humans.size(), people);
    palette().search().clear();
    bool isOff = false;
    for (int i = 0; i < palette().list().count(); ++i) {
      const bool isRowOff = !row(i).data(app::CommandPalette::kReasonRole).toString().isEmpty();
      QVERIFY(isRowOff || !isOff);  // available ones first
      isOff = isRowOff;
    }
    QVERIFY(isOff);
  }

  void palette_nothingFound_saysSo() {
    openPalette();
    QTest::keyClicks(&palette().search(), QStringLiteral("qqqq"));
    QVERIFY(palette().findChild<editor::NoMatchesPlaceholder*>()->isVisible());
    QTest::keyClick(&palette().search(), Qt::Key_Return);
    QVERIFY(palette().isVisible());
  }

  void pages_areTheFilesOfTheManual() {
    QStringList names;
    for (const app::ManualPage& page : app::manualPages()) {
      names << QString::fromLatin1(page.name) + QStringLiteral(".md");
      QVERIFY(*page.title != '\0');
    }
    names.sort();
    const QDir sources(QStringLiteral(SOURCE_DIR "/resources/manual"));
    QCOMPARE(names, sources.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name));
  }

  /// F1 with the focus in twenty different widgets.
  void f1_twentyWidgets_openTheirPages() {
    restart(withManual());
    window_->docks().show(window_->docks().names());
    document().setSelection({document().scenario().humans.front().key});
    QCoreApplication::processEvents();
    struct Case {
      const char* what;
      QWidget* widget;
      const char* page;
      QString line(const QString& shown) const {
        return QLatin1String(what) + QLatin1String(": ") + shown;
      }
      QString wanted() const { return line(QLatin1String(page)); }
    };
    const auto dock = [this](const char* name) {
      return window_->docks().dock(QString::fromLatin1(name))->widget();
    };
    window_->docks().dock(QStringLiteral("properties"))->raise();
    QCoreApplication::processEvents();
    auto* personName = widgets::findIf<QLineEdit>(*dock("properties"), [](const QLineEdit* each) {
      return each->isVisible() && each->accessibleName() == QLatin1String("Name");
    });
    std::vector<Case> cases = {
        {"map", &window_->workspace().view(), "window"},
        {"scenario list", window_->docks().panel<editor::ScenarioPanel>().findChild<QTreeView*>(),
         "people-and-groups"},
        {"scenario filter", window_->docks().panel<editor::ScenarioPanel>().findChild<QLineEdit*>(),
         "people-and-groups"},
        {"properties", dock("properties"), "window"},
        {"behaviour", &window_->docks().panel<editor::BehaviorPanel>(), "behaviour-tree"},
        {"behaviour outline", &window_->docks().panel<editor::BehaviorPanel>().outline(),
         "behaviour-tree"},
        {"issues", &window_->docks().panel<editor::IssuesPanel>(), "troubleshooting"},
        {"metrics", &window_->docks().panel<editor::MetricsDock>().table().tree(), "metrics"},
        {"metric search", window_->docks().panel<editor::MetricsDock>().findChild<QLineEdit*>(),
         "metrics"},
        {"events", dock("events"), "recordings"},
        {"runs", dock("runs"), "recordings"},
        {"futures", dock("futures"), "recordings"},
        {"study", &window_->docks().panel<app::StudyPanel>(), "compare-planners"},
        {"tree", window_->findChild<editor::TreeEditor*>(), "behaviour-tree"},
        {"timeline", window_->findChild<editor::TimelineBar*>(), "recordings"},
        {"person", personName, "people-and-groups"},
        {"start page", &window_->startPage(), "first-scenario"},
        {"menu bar", window_->menuBar(), "window"}};
    for (const Case& each : cases) {
      QVERIFY2(each.widget != nullptr, each.what);
      QCOMPARE(each.line(app::manualPageOf(each.widget)), each.wanted());
    }
    for (const Case& each : cases) {  // with the key, where the widget takes the focus
      if (each.widget->focusPolicy() == Qt::NoFocus || !each.widget->isVisible()) {
        continue;
      }
      window_->activateWindow();
      QVERIFY(QTest::qWaitForWindowActive(window_.get()));
      each.widget->setFocus();
      QTest::keyClick(window_->windowHandle(), Qt::Key_F1);
      QVERIFY2(window_->help().viewer() != nullptr, each.what);
      QCOMPARE(each.line(window_->help().viewer()->page()), each.wanted());
    }
  }

  void f1_mapWithATool_opensThePageOfTheTool_data() {
    QTest::addColumn<QString>("icon");
    QTest::addColumn<QString>("page");
    QTest::newRow("person") << "tool-person"
                            << "people-and-groups";
    QTest::newRow("robot") << "tool-robot"
                           << "robots-and-sensors";
    QTest::newRow("wall") << "tool-wall"
                          << "your-map";
    QTest::newRow("dock") << "tool-dock"
                          << "nav2";
    QTest::newRow("select") << "tool-select"
                            << "window";
  }
  void f1_mapWithATool_opensThePageOfTheTool() {
    QFETCH(QString, icon);
    QFETCH(QString, page);
    for (const auto& tool : window_->workspace().tools().entries()) {
      if (tool.info.icon == icon) {
        tool.action->trigger();
      }
    }
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    window_->workspace().view().setFocus();
    QTest::keyClick(window_->windowHandle(), Qt::Key_F1);
    QCOMPARE(window_->help().viewer()->page(), page);
  }

  void f1_propertiesOfARobot_opensRobots() {
    document().setSelection({document().scenario().robots.front().key});
    QCoreApplication::processEvents();
    QWidget* properties = window_->docks().dock(QStringLiteral("properties"))->widget();
    QDoubleSpinBox* field = widgets::shown<QDoubleSpinBox>(*properties);
    QVERIFY(field != nullptr);
    QCOMPARE(app::manualPageOf(field), QStringLiteral("robots-and-sensors"));
  }

  void f1_inADialog_opensItsPage() {
    app::RoomDialog dialog(editor::Theme::light(), window_.get());
    dialog.setModal(true);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QTest::keyClick(dialog.focusWidget(), Qt::Key_F1);
    QVERIFY(window_->help().viewer() != nullptr);
    QCOMPARE(window_->help().viewer()->page(), QStringLiteral("your-map"));
    QCOMPARE(window_->help().viewer()->parentWidget(), &dialog);  // otherwise it would be blocked
  }

  void page_htmlInstalled_opensInTheBrowser() {
    QDir(folder_->path()).mkdir(QStringLiteral("html"));
    QFile html(at("html/metrics.html"));
    QVERIFY(html.open(QIODevice::WriteOnly));
    html.close();
    app::WindowSetup setup = withManual();
    setup.manual.html = at("html");
    restart(setup);
    Browser browser;
    window_->help().showPage(QStringLiteral("metrics"));
    QCOMPARE(browser.shown, QList<QUrl>{QUrl::fromLocalFile(at("html/metrics.html"))});
    QVERIFY(window_->help().viewer() == nullptr);
    window_->help().showPage(QStringLiteral("index"));  // not built
    QCOMPARE(browser.shown.size(), 1);
    QCOMPARE(window_->help().viewer()->page(), QStringLiteral("index"));
  }

  void viewer_links_backAndSearch() {
    restart(withManual());
    window_->help().showPage(QStringLiteral("metrics"));
    app::ManualViewer& viewer = *window_->help().viewer();
    QVERIFY(viewer.text().toPlainText().startsWith(QStringLiteral("Title of metrics.md")));
    QVERIFY(viewer.text().toPlainText().contains(QStringLiteral("Note. Mind the gap.")));
    QVERIFY(!viewer.text().toPlainText().contains(QStringLiteral("{note}")));
    QVERIFY(viewer.text().toPlainText().contains(QStringLiteral("Included, see Metrics.")));
    Q_EMIT viewer.text().anchorClicked(QUrl(QStringLiteral("index.md#lower-part")));
    QCOMPARE(viewer.page(), QStringLiteral("index"));
    QVERIFY(viewer.text().verticalScrollBar()->value() > 0);
    QCOMPARE(viewer.pages().currentItem()->data(Qt::UserRole).toString(), QStringLiteral("index"));
    QVERIFY(QTest::qWaitForWindowActive(&viewer));
    QTest::keyClick(viewer.windowHandle(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(viewer.page(), QStringLiteral("metrics"));
    QTest::keyClicks(&viewer.search(), QStringLiteral("title of index"));
    int shown = 0;
    for (int i = 0; i < viewer.pages().count(); ++i) {
      shown += viewer.pages().item(i)->isHidden() ? 0 : 1;
    }
    QCOMPARE(shown, 1);
    quiet::shoot(viewer, "manual");
    viewer.search().clear();
    QTest::keyClick(&viewer, Qt::Key_Escape);
    QVERIFY(!viewer.isVisible());
  }

  void viewer_missingPage_saysSo() {
    restart(withManual());
    window_->help().showPage(QStringLiteral("nodes"));
    QVERIFY(window_->help().viewer()->text().toPlainText().contains(QStringLiteral("nodes.md")));
  }

  void whatsThis_toolsAndPanels_areExplained() {
    for (const auto& tool : window_->workspace().tools().entries()) {
      QVERIFY2(tool.action->whatsThis().size() > 80, qPrintable(tool.info.name));
      QVERIFY(!tool.tool->statusText().isEmpty());  // the tip in the status bar
    }
    for (const QDockWidget* dock : window_->docks().all()) {
      QVERIFY2(dock->whatsThis().size() > 80, qPrintable(dock->objectName()));
    }
  }

  void whatsThis_shiftF1AndAClick_showsTheExplanation() {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_->windowHandle(), Qt::Key_F1, Qt::ShiftModifier);
    QVERIFY(QWhatsThis::inWhatsThisMode());
    QWidget* view = window_->workspace().view().viewport();
    const QPoint at = view->mapTo(window_.get(), view->rect().center());
    QTest::mouseClick(window_->windowHandle(), Qt::LeftButton, {}, at);
    const auto isText = [](const QWidget* each) {
      return each->isVisible() && QByteArray(each->metaObject()->className()) == "QWhatsThat";
    };
    const QWidgetList all = QApplication::allWidgets();
    QVERIFY(std::any_of(all.begin(), all.end(), isText));
    QWhatsThis::hideText();
    QVERIFY(!QWhatsThis::inWhatsThisMode());
    QVERIFY(document().selection().empty());  // the click selected nothing
  }

  void whatsThis_fieldWithoutItsOwn_usesTheTooltip() {
    QWidget parent;
    parent.setWhatsThis(QStringLiteral("Parent"));
    QLineEdit field(&parent);
    QCOMPARE(app::explanationOf(field), QStringLiteral("Parent"));
    field.setToolTip(QStringLiteral("Speed\nHow fast"));
    QCOMPARE(app::explanationOf(field), QStringLiteral("<p><b>Speed</b></p><p>How fast</p>"));
    QLabel label(&parent);
    label.setBuddy(&field);
    QCOMPARE(app::explanationOf(label), app::explanationOf(field));
  }
};

QTEST_MAIN(WindowHelpTest)
#include "tst_WindowHelp.moc"
