#include <QAction>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "QuietWindow.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace {

/// A click makes a goal.
class FlagTool : public editor::Tool {
 public:
  using Tool::Tool;
  QString statusText() const override { return QStringLiteral("Click where the flag stands"); }
  void press(const editor::CanvasMouse& mouse) override {
    sim2d::GlobalGoal goal;
    goal.id = 77;
    goal.position = mouse.world;
    editor::pushAdd(document(), goal);
  }
  void move(const editor::CanvasMouse&) override {}
  void release(const editor::CanvasMouse&) override {}
  void cancel() override {}
};

void addFlagTool(editor::ToolRegistry& to) {
  to.add<FlagTool>({15, QStringLiteral("Flag"), QStringLiteral("tool-goal"),
                    QKeySequence(Qt::Key_F9), QStringLiteral("crowd")});
}

}  // namespace

/// All that a tool needs is in this file.
class MadeUpToolTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  QAction* tool(const char* text) const {
    for (QAction* action : window_->workspace().tools().actions().actions()) {
      if (action->text() == QString::fromUtf8(text)) {
        return action;
      }
    }
    return nullptr;
  }

 private Q_SLOTS:
  void init() {
    app::WindowSetup setup = quiet::setup();
    addFlagTool(setup.tools);
    window_ = quiet::shownWindow(setup);
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { quiet::leave(window_); }

  void tool_ofARegistry_standsInMenuAndBarAtItsPlace() {
    const QList<QAction*> tools = window_->workspace().tools().actions().actions();
    QCOMPARE(tools.indexOf(tool("Select")), 0);
    QCOMPARE(tools.indexOf(tool("Flag")), 1);
    QVERIFY(tools.indexOf(tool("Person")) > 1);
    QVERIFY(tool("Flag")->toolTip().contains(QStringLiteral("F9")));
    QMenu* menu = nullptr;
    for (QAction* each : window_->menuBar()->actions()) {
      menu = each->text() == QStringLiteral("&Scenario") ? each->menu() : menu;
    }
    QVERIFY(menu != nullptr && menu->actions().contains(tool("Flag")));
    bool isShared = false;  // its button, with brush and fill
    for (const QToolButton* button : window_->findChildren<QToolButton*>()) {
      const QList<QAction*> shown =
          button->menu() != nullptr ? button->menu()->actions() : QList<QAction*>();
      isShared |= shown.indexOf(tool("Flag")) == 0 && shown.contains(tool("Brush")) &&
                  shown.contains(tool("Fill"));
    }
    QVERIFY(isShared);
  }

  void tool_chosenAndClicked_works() {
    QAction* flag = tool("Flag");
    flag->trigger();
    QCOMPARE(window_->workspace().tools().current()->statusText(),
             QStringLiteral("Click where the flag stands"));
    editor::MapView& view = window_->workspace().view();
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.viewportFrom({0.0, 0.0}));
    QVERIFY(window_->workspace().document().scenario().goal(77) != nullptr);
  }
};

QTEST_MAIN(MadeUpToolTest)
#include "tst_MadeUpTool.moc"
