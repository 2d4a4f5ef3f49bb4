#include "QuietWindow.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/PanelRegistry.h"

namespace {

void addHeadcountPanel(editor::PanelRegistry& to) {
  to.add({45, QStringLiteral("Headcount"), Qt::RightDockWidgetArea}, [](auto& context) {
    auto* panel = new QLabel;
    panel->setObjectName(QStringLiteral("headcount"));
    const auto follow = [&context, panel] {
      const auto people = static_cast<int>(context.document.scenario().humans.size());
      panel->setText(QString::number(people));
      Q_EMIT context.counted(panel, people);
    };
    QObject::connect(&context.document, &editor::ScenarioDocument::stepFinished, panel, follow);
    QObject::connect(&context, &editor::PanelContext::themeChanged, panel,
                     [panel](const editor::Theme& theme) { panel->setPalette(theme.palette()); });
    return panel;
  });
}

}  // namespace

/// All that a panel needs is in this file.
class MadeUpPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

 private Q_SLOTS:
  void init() {
    app::WindowSetup setup = quiet::setup();
    addHeadcountPanel(setup.panels);
    window_ = quiet::shownWindow(setup);
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { quiet::leave(window_); }

  void panel_ofARegistry_isADockWithANameAndAMenuEntry() {
    const auto placeOf = [this](const char* name) {
      return window_->docks().names().indexOf(QString::fromUtf8(name));
    };
    QVERIFY(placeOf("behaviour") < placeOf("headcount"));
    QVERIFY(placeOf("headcount") < placeOf("issues"));
    QDockWidget* dock = window_->docks().dock(QStringLiteral("Headcount"));
    QVERIFY(dock != nullptr);
    QCOMPARE(window_->dockWidgetArea(dock), Qt::RightDockWidgetArea);
    const QList<QDockWidget*> tabs = window_->tabifiedDockWidgets(dock);
    for (const char* name : {"Properties", "Behaviour"}) {
      QVERIFY2(tabs.contains(window_->docks().dock(QString::fromUtf8(name))), name);
    }
    for (QDockWidget* each : tabs) {
      QCOMPARE(window_->dockWidgetArea(each), Qt::RightDockWidgetArea);
    }
    window_->docks().show({QStringLiteral("headcount")});  // as --dock does
    QVERIFY(dock->isVisible());
    QVERIFY(!window_->docks().panel<editor::IssuesPanel>().isVisible());
    bool isInMenu = false;
    for (const QAction* each : window_->menuBar()->actions()) {
      isInMenu |= each->menu()->actions().contains(window_->docks().toggleOf(*dock));
    }
    QVERIFY(isInMenu);
  }

  void panel_withItsContext_followsDocumentAndTheme() {
    QDockWidget* dock = window_->docks().dock(QStringLiteral("headcount"));
    QCOMPARE(window_->findChild<QLabel*>(QStringLiteral("headcount"))->text(), QStringLiteral("8"));
    QCOMPARE(dock->windowTitle(), QStringLiteral("Headcount  8"));
    QCOMPARE(window_->docks().toggleOf(*dock)->text(), QStringLiteral("Headcount"));
    QCOMPARE(window_->docks().toggleOf(*dock)->iconText(), QStringLiteral("Headcount  8"));
    window_->setTheme(editor::Theme::dark());
    QCOMPARE(dock->widget()->palette().color(QPalette::Base),
             editor::Theme::dark().palette().color(QPalette::Base));
  }
};

QTEST_MAIN(MadeUpPanelTest)
#include "tst_MadeUpPanel.moc"
