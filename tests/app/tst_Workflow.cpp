#include <QtTest>

#include "Hands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/look/Theme.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/behavior/GoalAssignment.h"
#include "editor/panels/properties/PropertyPage.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "tests/support/Widgets.h"

using app::MainWindow;
using base::Vec2;

namespace {

const Qt::KeyboardModifiers kSnap = Qt::ControlModifier;  // to half a metre and 22.5 degrees

QString dataFile(const QString& name) {
  return QStringLiteral(TEST_DATA_DIR "/app/workflow/") + name;
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll()
                                        : QByteArray("cannot be read: ") + path.toUtf8();
}

/// Without line ends and blanks between the tags.
QByteArray oneLine(const QByteArray& xml) {
  QByteArray line;
  for (const QByteArray& part : xml.split('\n')) {
    line += part.trimmed();
  }
  return line;
}

/// Line by line, so that a difference is seen at once.
void compareFiles(const QString& made, const QString& expected) {
  const QList<QByteArray> a = contentOf(made).split('\n');
  const QList<QByteArray> b = contentOf(expected).split('\n');
  for (int i = 0; i < std::min(a.size(), b.size()); ++i) {
    QVERIFY2(a[i] == b[i], QByteArray(expected.toUtf8() + ":" + QByteArray::number(i + 1) +
                                      ": expected \"" + b[i] + "\", written \"" + a[i] + "\"")
                               .constData());
  }
  QCOMPARE(a.size(), b.size());
}

}  // namespace

class WorkflowTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<MainWindow> window_;
  std::unique_ptr<Hands> hands_;

  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  QString path(const QString& name) const { return folder_->filePath(name); }
  editor::GoalAssignment* assignment() const {
    return qobject_cast<editor::GoalAssignment*>(hands_->openDialog());
  }
  /// Types into the field for the number of people over the canvas.
  void typeCount(const QString& number) {
    auto* field =
        widgets::named<editor::NumberField>(window_->workspace().view(), QStringLiteral("People"));
    QVERIFY(field != nullptr);
    hands_->typeInto(*field, number);
  }
  void openMap() {
    QVERIFY(window_->open(path(QStringLiteral("maps/hall.yaml"))));
    QTest::qWait(300);  // the view fits
  }
  void clickButton(QWidget& dialog, const QString& name) {
    auto* button = widgets::findIf<QAbstractButton>(dialog, [&](const QAbstractButton* each) {
      return each->text() == name || each->accessibleName().startsWith(name);
    });
    QVERIFY2(button != nullptr, qPrintable(name));
    hands_->clickOn(*button, button->rect().center());
  }
  void give(int person, const std::vector<int>& goalRows) {
    hands_->clickRow(assignment()->people(), person);
    for (const int row : goalRows) {
      hands_->clickRow(assignment()->goals(), row);
      clickButton(*assignment(), QStringLiteral("Add"));
    }
  }
  void makeBehave(const Vec2& at, const QString& behavior) {
    hands_->clickMap(at);
    hands_->chooseInMenu(QStringLiteral("Behaviour"), behavior);
  }
  /// Three people, five goals, who walks where, two behaviours: all by mouse and keys.
  void drawHall() {
    QVERIFY(window_->isOnStartPage());
    hands_->countFromHere();
    hands_->answerFileDialog(path(QStringLiteral("maps/hall.yaml")));
    clickButton(*window_, QStringLiteral("New from a map"));
    QVERIFY(!window_->isOnStartPage());
    QTest::qWait(300);  // the view fits
    hands_->chooseTool(QStringLiteral("tool-person"));
    hands_->dragMap({2.0, 2.0}, {2.0, 4.0}, kSnap);
    hands_->dragMap({5.0, 2.0}, {7.0, 2.0}, kSnap);
    hands_->dragMap({8.0, 6.0}, {6.0, 6.0}, kSnap);
    QCOMPARE(document().scenario().humans.size(), std::size_t(3));
    hands_->chooseTool(QStringLiteral("tool-goal"));
    for (const Vec2& at :
         {Vec2(2.0, 6.5), Vec2(5.0, 6.5), Vec2(8.0, 4.0), Vec2(5.0, 4.0), Vec2(8.0, 1.0)}) {
      hands_->clickMap(at, kSnap);
    }
    QCOMPARE(document().scenario().goals.size(), std::size_t(5));
    hands_->press(Qt::Key_G, Qt::ControlModifier);
    QTRY_VERIFY(assignment() != nullptr);
    give(0, {0, 1});
    give(1, {2, 3, 4});
    give(2, {4, 0});
    clickButton(*assignment(), QStringLiteral("Assign"));
    QTRY_VERIFY(assignment() == nullptr);
    hands_->chooseTool(QStringLiteral("tool-select"));
    makeBehave({5.0, 2.0}, QStringLiteral("Curious"));
    makeBehave({8.0, 6.0}, QStringLiteral("Scared"));
  }
  /// Ten people with goals and five behaviours, and a robot with a goal.
  void checkTenPeopleAndARobot() {
    const sim2d::Scenario& scenario = document().scenario();
    QCOMPARE(scenario.humans.size(), std::size_t(10));
    QVERIFY(scenario.goals.size() >= 3);
    std::set<sim2d::BehaviorType> types;
    for (const sim2d::Human& human : scenario.humans) {
      QVERIFY(human.goals.size() >= 3);
      types.insert(*human.behavior.type);
    }
    QVERIFY(types.size() >= 5);
    QCOMPARE(scenario.robots.size(), std::size_t(1));
    QVERIFY(scenario.robots.front().goal.point || !scenario.robots.front().goal.goals.empty());
    document().checkNow();
    QVERIFY(!base::hasErrors(document().issues()));
  }
  void placeRobot(const Vec2& from, const Vec2& to) {
    hands_->chooseTool(QStringLiteral("tool-robot"));
    hands_->clickMap(from);
    hands_->clickMap(to);
  }
  void moveThirdGoal() {
    hands_->clickMap({8.0, 4.15});  // the pin of goal 3 stands above its place
    QCOMPARE(document().selection().size(), std::size_t(1));
    editor::NumberField* y = nullptr;
    for (auto* field : window_->docks()
                           .panel<editor::PropertyPanel>()
                           .currentPage()
                           ->findChildren<editor::NumberField*>()) {
      y = field->accessibleName() == QLatin1String("Y") ? field : y;
    }
    QVERIFY(y != nullptr);
    hands_->typeInto(*y, QStringLiteral("3"));
  }

 private Q_SLOTS:
  void initTestCase() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    editor::applyTheme(editor::Theme::light());
  }
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("maps")));
    QVERIFY(QDir(folder_->path()).mkpath(QStringLiteral("scenarios")));
    for (const char* name : {"hall.yaml", "hall.pgm"}) {
      QVERIFY(QFile::copy(dataFile(QString::fromLatin1(name)),
                          path(QStringLiteral("maps/") + QString::fromLatin1(name))));
    }
    app::WindowSetup setup;
    setup.followsSystem = false;
    setup.storesSettings = false;
    window_ = std::make_unique<MainWindow>(setup);
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    hands_ = std::make_unique<Hands>(*window_);
  }
  void cleanup() {
    document().undoStack().setClean();
    hands_.reset();
    window_.reset();
  }

  void scenario_drawnSavedReopenedEdited_filesAreAsExpected() {
    drawHall();
    QVERIFY(!QTest::currentTestFailed());
    const QString file = path(QStringLiteral("scenarios/hall_agents_demo.yaml"));
    hands_->answerFileDialog(file);
    hands_->press(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!document().isDirty());
    compareFiles(file, dataFile(QStringLiteral("first.yaml")));
    const QString trees = path(QStringLiteral("behavior_trees/"));
    QVERIFY(QFile::exists(trees + QStringLiteral("BTRegularNav.xml")));
    const QByteArray tree =
        oneLine(contentOf(trees + QStringLiteral("hall_agents_demo__agent_2_bt.xml")));
    for (const char* part :
         {"<Sequence name=\"SetGoals\"><RunOnce><SetGoal agent_id=\"{id}\" "
          "goal_id=\"3\"/></RunOnce>",
          "<IsRobotVisible agent_id=\"{id}\" distance=\"5\"/><ApproachRobot agent_id=\"{id}\" "
          "time_step=\"{dt}\" closest_dist=\"1.5\" max_vel=\"1.3\" duration=\"40\"/>"}) {
      QVERIFY2(tree.contains(part), tree.constData());
    }
    QVERIFY(QFile::exists(trees + QStringLiteral("hall_agents_demo__agent_3_bt.xml")));

    hands_->press(Qt::Key_W, Qt::ControlModifier);
    QVERIFY(window_->isOnStartPage());
    hands_->answerFileDialog(file);
    hands_->press(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(!window_->isOnStartPage());
    QCOMPARE(document().scenario().humans.size(), std::size_t(3));
    QTest::qWait(300);
    hands_->chooseTool(QStringLiteral("tool-select"));
    moveThirdGoal();
    QVERIFY(!QTest::currentTestFailed());
    hands_->clickMap({5.0, 4.15});
    window_->workspace().view().setFocus();
    hands_->press(Qt::Key_Delete);
    hands_->press(Qt::Key_S, Qt::ControlModifier);
    compareFiles(file, dataFile(QStringLiteral("second.yaml")));
    QCOMPARE(hands_->boxes(), 0);
    qInfo("%d clicks and drags, no message box", hands_->actions());
  }

  void tenPeople_withGoalsAndBehaviours_takeFortyActionsAtMost() {
    openMap();
    hands_->countFromHere();
    hands_->chooseTool(QStringLiteral("tool-person"));
    for (int i = 0; i < 10; ++i) {
      const Vec2 at(1.0 + 0.8 * (i % 5) * 2.0, i < 5 ? 1.5 : 6.5);
      hands_->dragMap(at, at + Vec2(0.0, i < 5 ? 1.0 : -1.0), kSnap);
    }
    QCOMPARE(document().scenario().humans.size(), std::size_t(10));
    hands_->chooseTool(QStringLiteral("tool-goal"));
    for (int i = 0; i < 5; ++i) {
      hands_->clickMap({1.0 + 2.0 * i, i % 2 == 0 ? 3.5 : 4.5}, kSnap);
    }
    QCOMPARE(document().scenario().goals.size(), std::size_t(5));
    hands_->chooseInMenu(QStringLiteral("Scenario"), QStringLiteral("Assign goals"));
    QTRY_VERIFY(assignment() != nullptr);
    hands_->clickRow(assignment()->people(), 0);
    hands_->clickRow(assignment()->people(), 9, Qt::ShiftModifier);
    hands_->clickRow(assignment()->goals(), 0);
    hands_->clickRow(assignment()->goals(), 4, Qt::ShiftModifier);
    clickButton(*assignment(), QStringLiteral("Add"));
    clickButton(*assignment(), QStringLiteral("Assign"));
    QTRY_VERIFY(assignment() == nullptr);
    hands_->chooseTool(QStringLiteral("tool-select"));
    hands_->dragMap({0.4, 7.3}, {9.6, 5.6});  // those above
    hands_->chooseInMenu(QStringLiteral("Behaviour"), QStringLiteral("Surprised"));
    hands_->dragMap({0.4, 2.3}, {3.4, 0.6});  // two of those below
    hands_->chooseInMenu(QStringLiteral("Behaviour"), QStringLiteral("Threatening"));
    hands_->answerFileDialog(path(QStringLiteral("scenarios/ten.yaml")));
    hands_->clickAction(*window_->actions().save);
    int surprised = 0;
    int threatening = 0;
    for (const sim2d::Human& human : document().scenario().humans) {
      QCOMPARE(human.goals, (std::vector<int>{1, 2, 3, 4, 5}));
      surprised += human.behavior.type == sim2d::BehaviorType::Surprised ? 1 : 0;
      threatening += human.behavior.type == sim2d::BehaviorType::Threatening ? 1 : 0;
    }
    QCOMPARE(surprised, 5);
    QCOMPARE(threatening, 2);
    QVERIFY(!document().isDirty());
    QVERIFY2(hands_->actions() <= 40, QByteArray::number(hands_->actions()).constData());
    QCOMPARE(hands_->boxes(), 0);
    qInfo("%d clicks and drags", hands_->actions());
  }

  void tenPeopleAndARobot_onAPlane_takeTwelveActionsAtMost() {
    hands_->countFromHere();
    hands_->chooseInMenu(QStringLiteral("File"), QStringLiteral("New open plane"));
    QVERIFY(!window_->isOnStartPage());
    QTest::qWait(300);  // the view fits
    hands_->chooseTool(QStringLiteral("tool-goal"));
    for (const Vec2& at : {Vec2(-5.0, 3.0), Vec2(5.0, 3.0), Vec2(5.0, -3.0)}) {
      hands_->clickMap(at);
    }
    hands_->chooseTool(QStringLiteral("tool-fill"));
    hands_->dragMap({-3.0, -3.0}, {3.0, 2.0});
    typeCount(QStringLiteral("10"));
    placeRobot({-6.0, -3.0}, {6.0, 0.0});
    checkTenPeopleAndARobot();
    QVERIFY(!QTest::currentTestFailed());
    QVERIFY2(hands_->actions() <= 12, QByteArray::number(hands_->actions()).constData());
    QCOMPARE(hands_->boxes(), 0);
    qInfo("%d clicks and drags", hands_->actions());
  }

  void tenPeopleAndARobot_onAMapWithFill_takeSixActionsAtMost() {
    openMap();
    hands_->countFromHere();
    hands_->chooseTool(QStringLiteral("tool-fill"));
    hands_->dragMap({1.0, 1.0}, {9.0, 7.0});
    typeCount(QStringLiteral("10"));
    placeRobot({0.6, 0.6}, {9.4, 0.6});
    checkTenPeopleAndARobot();
    QVERIFY(!QTest::currentTestFailed());
    QVERIFY2(hands_->actions() <= 6, QByteArray::number(hands_->actions()).constData());
    QCOMPARE(hands_->boxes(), 0);
    qInfo("%d clicks and drags", hands_->actions());
  }

  void tenPeople_aMixOfBehaviours_takesTwoClicks() {
    openMap();
    hands_->chooseTool(QStringLiteral("tool-person"));
    for (int i = 0; i < 10; ++i) {
      hands_->clickMap({1.0 + 1.6 * (i % 5), i < 5 ? 1.5 : 6.5}, kSnap);
    }
    QCOMPARE(document().scenario().humans.size(), std::size_t(10));
    document().setSelection({});
    hands_->countFromHere();
    hands_->chooseInMenu(QStringLiteral("Behaviour"), QStringLiteral("Mix"));
    QTRY_VERIFY(hands_->openDialog() != nullptr);
    QTest::keyClick(hands_->openDialog(), Qt::Key_Return);
    QTRY_VERIFY(hands_->openDialog() == nullptr);
    QCOMPARE(hands_->actions(), 2);
    std::set<sim2d::BehaviorType> types;
    for (const sim2d::Human& human : document().scenario().humans) {
      types.insert(*human.behavior.type);
    }
    QVERIFY(types.size() >= 4);
  }

  void pageKeys_onTheMap_goFromPersonToPerson() {
    openMap();
    hands_->chooseTool(QStringLiteral("tool-person"));
    for (const double x : {2.0, 4.0, 6.0}) {
      hands_->clickMap({x, 3.0}, kSnap);
    }
    const std::vector<editor::EntityId> people = document().entities(base::EntityKind::Human);
    document().setSelection({});
    window_->workspace().view().setFocus();
    hands_->press(Qt::Key_PageDown);
    QCOMPARE(document().selection(), std::vector<editor::EntityId>{people[0]});
    hands_->press(Qt::Key_PageDown);
    QCOMPARE(document().selection(), std::vector<editor::EntityId>{people[1]});
    hands_->press(Qt::Key_PageUp);
    hands_->press(Qt::Key_PageUp);
    QCOMPARE(document().selection(), std::vector<editor::EntityId>{people[2]});
  }

  void issue_ofAFile_isShownInTheViewer() {
    openMap();
    window_->docks().panel<editor::IssuesPanel>().setActionIssues({base::error(
        "run.failed", {"odd"}, path(QStringLiteral("maps/hall.yaml")).toStdString(), 3, 1)});
    QTableView& table = window_->docks().panel<editor::IssuesPanel>().table();
    hands_->press(Qt::Key_4, Qt::AltModifier);
    QTRY_VERIFY(table.isVisible());
    hands_->clickOn(*table.viewport(), table.visualRect(table.model()->index(0, 0)).center());
    QVERIFY(window_->viewer() != nullptr);
    QVERIFY(window_->viewer()->isVisible());
    QCOMPARE(window_->viewer()->line(), 3);
  }
};

QTEST_MAIN(WorkflowTest)
#include "tst_Workflow.moc"
