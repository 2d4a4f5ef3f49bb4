#include <limits>

#include <QSignalSpy>
#include <QtTest>

#include "Hands.h"
#include "RunFiles.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "editor/panels/runs/BranchDialog.h"
#include "editor/panels/runs/RunPlots.h"

using editor::BranchDialog;
using editor::SimulationRunner;
using namespace outside;

namespace {

constexpr int kBranchMs = 60000;

QAction* entryOf(const QMenu& menu, const char* words) {
  for (QAction* action : menu.actions()) {
    if (action->text().remove(QLatin1Char('&')) == text(words)) {
      return action;
    }
  }
  return nullptr;
}

void clickEntry(QMenu& menu, const char* words) {
  QAction* const action = entryOf(menu, words);
  QVERIFY2(action != nullptr && action->isEnabled(), words);
  QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(action).center());
}

QMenu& openMenu() {
  [] { QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()) != nullptr); }();
  return *qobject_cast<QMenu*>(QApplication::activePopupWidget());
}

void activate(BranchDialog& dialog) {
  dialog.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&dialog));
}

void clickOk(const BranchDialog& dialog) {
  QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                    Qt::LeftButton);
}

void enterNumber(QAbstractSpinBox& field, const QString& number) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, number);
  field.interpretText();  // as when the focus leaves; the window need not be active
}

}  // namespace

/// The one command that branches a run, and what the panels show of a branch.
class BranchCommandTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;
  std::unique_ptr<Hands> hands_;

  app::Workspace& workspace() { return window_->workspace(); }
  SimulationRunner& runner() { return workspace().runner(); }
  editor::ScenarioDocument& document() { return workspace().document(); }
  editor::TimelineBar& timeline() { return *window_->findChild<editor::TimelineBar*>(); }
  editor::PropertyPanel& properties() { return window_->docks().panel<editor::PropertyPanel>(); }

  void runDemo(double seconds) {
    QVERIFY(window_->open(quiet::demoPath()));
    auto settings = static_cast<const sim2d::ScenarioSettings&>(document().scenario());
    settings.desktop.duration = seconds;
    editor::pushEdit(document(), {settings}, text("Duration"));
    runner().setSpeed(std::numeric_limits<double>::infinity());
    QSignalSpy finished(&runner(), &SimulationRunner::finished);
    runner().play();
    QVERIFY(finished.wait(kBranchMs));
  }
  /// Paused in the middle of a run.
  void pauseDemo() {
    QVERIFY(window_->open(quiet::demoPath()));
    for (int step = 0; step < 20; ++step) {
      runner().stepOnce();
    }
    QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() && runner().newestFrame()->step == 20,
                             kBranchMs);
    QCOMPARE(runner().state(), SimulationRunner::State::Paused);
  }
  void sendMenu(QWidget& widget, const QPoint& at) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(&widget, &event);
  }
  void waitForBranch(int number, std::int64_t step) {
    QTRY_VERIFY_WITH_TIMEOUT(runner().branch() == number && runner().newestFrame() &&
                                 runner().newestFrame()->step == step,
                             kBranchMs);
  }
  base::Vec2 placeOf(int person) { return *workspace().scene().frameLayer().positionOf(person); }
  QWidget& row(const char* name) {
    return *properties().currentPage()->findChild<QWidget*>(text(name));
  }
  /// The label before a field of the properties.
  QString markOf(const char* name) {
    const QLabel* label = widgets::findIf<QLabel>(
        properties(), [field = &row(name)](const QLabel* each) { return each->buddy() == field; });
    return label == nullptr ? text("no label") : label->toolTip();
  }
  QString listTextOf(base::EntityId person) {
    const editor::EntityModel& model = window_->docks().panel<editor::ScenarioPanel>().model();
    return model.indexOf(person)
        .siblingAtColumn(editor::EntityModel::BehaviorColumn)
        .data()
        .toString();
  }
  editor::Look lookOnMap(int person) {
    for (const editor::ShownBody& body : workspace().scene().frameLayer().shownBodies()) {
      if (body.id == person) {
        return body.look;
      }
    }
    return editor::Look::CustomTree;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    window_ = quiet::shownWindow();
    hands_ = std::make_unique<Hands>(*window_);
  }
  void cleanup() {
    hands_.reset();
    quiet::leave(window_);
  }

  void command_isTheOnlyOne() {
    QStringList names;
    for (const QAction* action : window_->findChildren<QAction*>()) {
      if (action->text().contains(text("branch"), Qt::CaseInsensitive)) {
        names << action->text().remove(QLatin1Char('&'));
      }
    }
    for (const QAction* action : workspace().playback().findChildren<QAction*>()) {
      if (action->text().contains(text("branch"), Qt::CaseInsensitive)) {
        names << action->text().remove(QLatin1Char('&'));
      }
    }
    QCOMPARE(names, QStringList{text("Branch here…")});
  }

  /// Properties show the planner of the branch; the document keeps its own.
  void timelineMenu_branchesThere_andPropertiesShowTheBranch() {
    runDemo(4.0);
    const base::EntityId robot = document().entities(base::EntityKind::Robot).front();
    const auto before = std::get<sim2d::Robot>(*document().entity(robot)).planner;
    QVERIFY(before.value_or("pursuit") != "dwa");
    QVERIFY(!workspace().playback().branchHere->isEnabled());  // the end
    sendMenu(timeline(), QPoint(qRound(timeline().xOf(2.0)), 17));
    QVERIFY(std::abs(runner().shownFrame()->time - 2.0) < 0.06);
    const std::int64_t step = runner().shownFrame()->step;
    quiet::answerDialog<BranchDialog>([](BranchDialog& dialog) {
      dialog.findChildren<QComboBox*>().front()->setCurrentText(text("dwa"));
      clickOk(dialog);
    });
    clickEntry(openMenu(), "Branch here…");
    waitForBranch(1, step);
    document().setSelection({robot});
    QCOMPARE(static_cast<QComboBox&>(row("planner")).currentText(), text("dwa"));
    QCOMPARE(markOf("planner"), QString());
    QCOMPARE(std::get<sim2d::Robot>(*document().entity(robot)).planner, before);
    runner().showBranch(0);
    QVERIFY(static_cast<QComboBox&>(row("planner"))
                .currentText()
                .startsWith(QString::fromStdString(before.value_or("pursuit"))));
    QVERIFY(!document().undoStack().canRedo());
  }

  void plotMenu_branchesAtItsTime() {
    runDemo(4.0);
    window_->docks().show({text("metrics")});
    auto* plot = &window_->docks().panel<editor::MetricsDock>().plot();
    QTRY_VERIFY_WITH_TIMEOUT(plot->lines() > 0, kBranchMs);
    QTRY_VERIFY(plot->isVisible());
    std::vector<double> times;
    for (const double part : {0.5, 0.8}) {  // of the width
      sendMenu(*plot, QPoint(qRound(part * plot->width()), plot->height() / 2));
      times.push_back(runner().shownFrame()->time);
      QMenu& menu = openMenu();
      QVERIFY(entryOf(menu, "Branch here…")->isEnabled());
      menu.close();
    }
    QVERIFY2(times[0] > 0.0 && times[1] > times[0] + 0.1 && times[1] < 4.0,
             qPrintable(QStringLiteral("%1 %2").arg(times[0]).arg(times[1])));
  }

  void dragWhilePaused_branchesWithThePersonThere() {
    pauseDemo();
    const sim2d::HumanColumns& people = runner().shownFrame()->humans;
    const int person = people.id.front();
    const base::Vec2 from(people.x.front(), people.y.front());
    const base::Vec2 to = from + base::Vec2(0.6, 0.4);
    hands_->dragMap(from, to);
    QVERIFY(workspace().scene().placement().has_value());  // shown there until answered
    QMenu& menu = openMenu();
    quiet::shoot(*window_, "branch_drag");
    quiet::answerDialog<BranchDialog>([to](BranchDialog& dialog) {
      QCOMPARE(dialog.changes().moves.size(), std::size_t{1});
      quiet::shoot(dialog, "branch_dialog_light");
      clickOk(dialog);
    });
    QTest::keyClick(&menu, Qt::Key_Return);
    waitForBranch(1, 21);
    QVERIFY((placeOf(person) - to).norm() < 0.15);
    QVERIFY(!workspace().scene().placement());
    runner().showBranch(0);  // the run is kept
    waitForBranch(0, 20);
    QVERIFY((placeOf(person) - from).norm() < 1e-9);
  }

  void dragWhilePaused_cancelled_changesNothing() {
    pauseDemo();
    const sim2d::HumanColumns& people = runner().shownFrame()->humans;
    const base::Vec2 from(people.x.front(), people.y.front());
    hands_->dragMap(from, from + base::Vec2(0.6, 0.4));
    QMenu& menu = openMenu();
    QTest::keyClick(&menu, Qt::Key_Escape);
    QTRY_VERIFY(!workspace().scene().placement());
    QCOMPARE(runner().branches().size(), std::size_t{1});
    QVERIFY(!document().isDirty());
  }

  void mapMenu_onPersonAndRobot_offersIt() {
    pauseDemo();
    const sim2d::Frame& frame = *runner().shownFrame();
    for (const base::Vec2& place : {base::Vec2(frame.humans.x[0], frame.humans.y[0]),
                                    base::Vec2(frame.robots.x[0], frame.robots.y[0])}) {
      editor::MapView& view = workspace().view();
      sendMenu(*view.viewport(), view.viewportFrom(place));
      QMenu& menu = openMenu();
      QVERIFY(entryOf(menu, "Branch here…") != nullptr);
      menu.close();
    }
  }

  /// A position, a seed and other values, by mouse and keys; wrong values keep the dialog open.
  void dialog_changes_areThoseOfTheCommandLine() {
    pauseDemo();
    const QString name = QString::fromStdString(
        runner().recording()->header()->human(runner().shownFrame()->humans.id.front())->name);
    app::RunSpec changes;
    quiet::answerDialog<BranchDialog>([&](BranchDialog& dialog) {
      activate(dialog);
      auto& people = quiet::part<QComboBox>(dialog, "Move a person");
      people.setFocus();
      QTest::keyClick(&people, Qt::Key_Down);
      QCOMPARE(dialog.changes().moves.size(), std::size_t{1});
      enterNumber(*widgets::named<QAbstractSpinBox>(dialog, text("X of ") + name), text("1.5"));
      enterNumber(*widgets::named<QAbstractSpinBox>(dialog, text("Heading of ") + name),
                  text("180"));
      auto& values = quiet::part<QPlainTextEdit>(dialog, "Other values");
      values.setFocus();
      QTest::keyClicks(&values, text("robot1.radius = 0.9"));
      clickOk(dialog);
      QVERIFY(dialog.isVisible());
      QVERIFY(widgets::findIf<QLabel>(dialog, [](const QLabel* label) {
                return label->isVisible() && label->text().contains(text("robot1.radius"));
              }) != nullptr);
      values.selectAll();
      QTest::keyClicks(&values, text("robot1.goal_radius = 0.4"));
      QTest::mouseClick(widgets::withText<QCheckBox>(dialog, text("New random seed")),
                        Qt::LeftButton, {}, QPoint(8, 8));
      changes = dialog.changes();
      clickOk(dialog);
    });
    hands_->press(Qt::Key_B, Qt::ControlModifier);
    waitForBranch(1, 21);
    QCOMPARE(changes.set, std::vector<std::string>{"robot1.goal_radius=0.4"});
    QVERIFY(changes.seed.has_value());
    QCOMPARE(changes.moves.size(), std::size_t{1});
    QVERIFY(changes.moves.front().rfind(name.toStdString() + " 1.5 ", 0) == 0);
    QVERIFY(std::abs(placeOf(runner().shownFrame()->humans.id.front()).x() - 1.5) < 0.15);
  }

  /// The list says what the map shows, and what comes with the next start.
  void behaviourEditedWhilePaused_appliesAtTheNextStart() {
    pauseDemo();
    const int id = runner().shownFrame()->humans.id.front();
    const base::EntityId person = workspace().scene().frameLayer().entityOf(id);
    const editor::Look look = lookOnMap(id);
    const QString before = listTextOf(person);
    QCOMPARE(before, editor::lookName(look));
    document().setSelection({person});
    QWidget* const behaviour = properties().currentPage()->findChild<QWidget*>(text("type"));
    auto* box = qobject_cast<QComboBox*>(behaviour);
    QVERIFY(box != nullptr);
    const int scared = box->findText(text("Scared"));
    QVERIFY(scared >= 0 && box->currentIndex() != scared);
    box->setFocus();
    while (box->currentIndex() != scared) {
      QTest::keyClick(box, box->currentIndex() < scared ? Qt::Key_Down : Qt::Key_Up);
    }
    QCOMPARE(lookOnMap(id), look);
    QCOMPARE(listTextOf(person), before + text(" → Scared"));
    QCOMPARE(markOf("type"), text("Applies at the next start"));
    quiet::shoot(*window_, "pending_light");
    window_->setTheme(editor::Theme::dark());
    QTest::qWait(50);
    quiet::shoot(*window_, "pending_dark");
    window_->setTheme(editor::Theme::light());
    QTest::mouseClick(widgets::findIf<QToolButton>(properties(),
                                                   [](const QToolButton* each) {
                                                     return each->objectName() == text("restart");
                                                   }),
                      Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr, kBranchMs);
    runner().pause();
    QCOMPARE(lookOnMap(id), editor::Look::Scared);
    QCOMPARE(listTextOf(person), text("Scared"));
    QCOMPARE(markOf("type"), QString());
  }

  void dialog_isShown() {
    runDemo(2.0);
    runner().seek(20);
    for (const bool isDark : {false, true}) {
      window_->setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
      quiet::answerDialog<BranchDialog>([isDark](BranchDialog& dialog) {
        auto& people = quiet::part<QComboBox>(dialog, "Move a person");
        people.setFocus();
        QTest::keyClick(&people, Qt::Key_Down);
        quiet::shoot(dialog, isDark ? "branch_dark" : "branch_light");
        dialog.reject();
      });
      workspace().playback().branchHere->trigger();
    }
    window_->setTheme(editor::Theme::light());
    QCOMPARE(runner().branches().size(), std::size_t{1});
  }

  /// There is no empty space between its rows, before a change, with one and after it.
  void dialog_isAsHighAsItsRows_andListsTheChanges() {
    editor::BranchState state;
    state.time = 5.0;
    state.robots = {{"robot1", "dwa", 0.5}};
    state.people = {{"Ana", {{1.0, 2.0}, 0.0}}};
    BranchDialog dialog(state, text("Branch 1"), editor::Theme::light(), {});
    dialog.show();
    activate(dialog);
    const auto says = [&dialog](const char* words) {
      return widgets::findIf<QLabel>(dialog, [words](const QLabel* label) {
               return label->text().startsWith(text(words));
             }) != nullptr;
    };
    const auto largestGap = [&dialog] {
      int gap = 0;
      for (int k = 1; k < dialog.layout()->count(); ++k) {
        const QRect above = dialog.layout()->itemAt(k - 1)->widget()->geometry();
        gap = std::max(gap, dialog.layout()->itemAt(k)->widget()->y() - above.bottom() - 1);
      }
      return gap;
    };
    QVERIFY(says("No changes yet"));
    QVERIFY2(largestGap() <= 12, qPrintable(QString::number(largestGap())));
    const int height = dialog.height();
    auto& people = *widgets::named<QComboBox>(dialog, text("Move a person"));
    people.setCurrentIndex(1);
    Q_EMIT people.activated(1);
    QVERIFY(says("Changes: Ana"));
    QTRY_VERIFY(largestGap() <= 12);
    auto* remove = widgets::named<QToolButton>(dialog, text("Leave Ana in place"));
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(says("No changes yet"));
    QTRY_COMPARE(dialog.height(), height);
    auto* planner = widgets::findIf<QComboBox>(
        dialog, [](const QComboBox* box) { return box->findText(text("pursuit")) >= 0; });
    QVERIFY(planner != nullptr);
    planner->setCurrentText(text("pursuit"));
    QVERIFY(says("Changes: robot1.planner"));
  }
};

QTEST_MAIN(BranchCommandTest)
#include "tst_BranchCommand.moc"
