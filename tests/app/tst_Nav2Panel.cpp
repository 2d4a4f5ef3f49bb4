#include <QSignalSpy>

#include "app/run/Nav2Robots.h"
#include "app/window/Docks.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/nav2/Nav2Panel.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/StudyFiles.h"

using editor::Nav2Panel;
using namespace outside;

namespace {

/// The yard with two robots, the first of them driven by Nav2.
QByteArray scenarioText() {
  return QByteArray(kYardText).replace("robots: [robot1]", "robots: [robot1, second]") +
         "      planner: nav2\n      nav2_params: mine.yaml\n"
         "    second:\n      start: {x: 0.0, y: -3.0, h: 1.5}\n      goal: {x: 0.0, y: 4.0}\n"
         "      planner: dwa\n";
}

}  // namespace

/// The dock of Nav2's parameters: opened from the robot, edited by mouse and keys, saved as a file.
class Nav2PanelTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  Nav2Panel& panel() { return window_->docks().panel<Nav2Panel>(); }
  const sim2d::Robot& robot() { return document().scenario().robots.front(); }
  QTreeWidgetItem& row(const char* path) { return *panel().form().rowOf(path); }
  QByteArray shipped() const {
    return bytesOf(text(SOURCE_DIR "/resources/nav2_params/generic.yaml"));
  }

  void openPanel() {
    document().setSelection({robot().key});
    auto* open = window_->findChild<QToolButton*>(text("nav2_open"));
    QVERIFY(open != nullptr && open->isVisible());
    QTest::mouseClick(open, Qt::LeftButton);
    QTRY_VERIFY(panel().isVisible());
    QTRY_VERIFY(panel().form().rowOf("FollowPath.temperature") != nullptr);
    // No box of 120 px: several rows are visible, once the dock has its size.
    QTRY_VERIFY(panel().form().tree().viewport()->height() > 6 * 20);
  }
  void type(const char* path, const char* value) {
    QTreeWidget& tree = panel().form().tree();
    QTreeWidgetItem& item = row(path);
    for (QTreeWidgetItem* up = item.parent(); up != nullptr; up = up->parent()) {
      up->setExpanded(true);
    }
    tree.scrollToItem(&item);
    const QModelIndex name = tree.indexAt(QPoint(120, tree.visualItemRect(&item).center().y()));
    const QPoint at = tree.visualRect(name.sibling(name.row(), editor::Nav2ValueColumn)).center();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
    auto* field = tree.viewport()->findChild<QLineEdit*>();
    QVERIFY2(field != nullptr, path);
    field->selectAll();
    QTest::keyClicks(field, text(value));
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of the field
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    writeText(at("mine.yaml"), shipped());
    writeText(at("scene.yaml"), scenarioText());
    QVERIFY(window_->open(at("scene.yaml")));
  }
  void cleanup() { end(); }

  void panel_opensFromTheRobot_andShowsItsFile() {
    QVERIFY(!panel().isVisible());
    openPanel();
    QCOMPARE(panel().robots().count(), 1);  // the other one is driven by dwa
    QCOMPARE(panel().robots().currentText(), text("robot1"));
    QCOMPARE(QFileInfo(panel().form().file()).fileName(), text("mine.yaml"));
    QCOMPARE(row("FollowPath.temperature").text(editor::Nav2ValueColumn), text("0.3"));
    quiet::shoot(*window_, "nav2_panel");
  }

  void panel_withoutNav2_saysHowToGetIt() {
    openPanel();
    editor::pushChange<sim2d::Robot>(document(), robot().key, text("Planner"),
                                     [](sim2d::Robot& edited) { edited.planner = "dwa"; });
    QTRY_VERIFY(!panel().form().isVisible());
    QVERIFY(
        isSaid(text("No robot is driven by Nav2. Select a robot and choose the planner nav2 in "
                    "its properties.")));
    document().undoStack().undo();
    QTRY_VERIFY(panel().form().isVisible());
  }

  void edit_isACommand_andUndone() {
    openPanel();
    type("FollowPath.temperature", "0.2");
    QCOMPARE(robot().nav2Values, (sim2d::ParameterTexts{{"FollowPath.temperature", "0.2"}}));
    QCOMPARE(bytesOf(at("mine.yaml")), shipped());
    document().undoStack().undo();
    QVERIFY(robot().nav2Values.empty());
    QTRY_COMPARE(row("FollowPath.temperature").text(editor::Nav2ValueColumn), text("0.3"));
  }

  /// The new file is the old one with these values: comments and order are those of its writer.
  void saveAs_keepsTheUsersText() {
    openPanel();
    type("FollowPath.temperature", "0.2");
    type("FollowPath.vx_max", "0.75");
    // A key that the file does not contain.
    QCOMPARE(row("FollowPath.retry_attempt_limit").text(editor::Nav2FileColumn), text("–"));
    type("FollowPath.retry_attempt_limit", "3");
    QTRY_COMPARE(panel().form().changedCount(), 3);
    quiet::shoot(*window_, "nav2_panel_changed");
    quiet::answerDialog<QFileDialog>([this](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(text("fileNameEdit"));
      name->setText(at("tuned.yaml"));
      QTest::keyClick(name, Qt::Key_Return);
    });
    QTest::mouseClick(&panel().saveButton(), Qt::LeftButton);
    QTRY_VERIFY(QFileInfo::exists(at("tuned.yaml")));
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"tuned.yaml"});
    QVERIFY(robot().nav2Values.empty());
    const QList<QByteArray> before = shipped().split('\n');
    QList<QByteArray> now = bytesOf(at("tuned.yaml")).split('\n');
    QStringList changed;
    for (const QByteArray& line : before) {
      if (!now.isEmpty() && now.front() == line) {
        now.removeFirst();
        continue;
      }
      changed.append(QString::fromUtf8(now.front().trimmed()));
      now.removeFirst();
      if (!now.isEmpty() && changed.back().startsWith(text("retry_attempt_limit"))) {
        now.removeFirst();  // an added line, not an exchanged one
      }
    }
    changed.sort();
    QVERIFY2(changed.contains(text("vx_max: 0.75")) && changed.contains(text("temperature: 0.2")) &&
                 changed.size() == 3,
             qPrintable(changed.join(text("|"))));
    QCOMPARE(bytesOf(at("mine.yaml")), shipped());
    // What the robot does is the same; the panel shows the new file without changes.
    const app::Nav2ParameterList list =
        app::nav2ParameterListOf(robot(), document().path().toStdString());
    for (const app::Nav2Parameter& parameter : list.parameters) {
      if (parameter.name == "FollowPath.retry_attempt_limit") {
        QVERIFY(parameter.fileValue.has_value());
        QCOMPARE(parameter.value(), std::string("3"));
      }
    }
    QTRY_COMPARE(panel().form().changedCount(), 0);
    QCOMPARE(QFileInfo(panel().form().file()).fileName(), text("tuned.yaml"));
    document().undoStack().undo();
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"mine.yaml"});
    QCOMPARE(robot().nav2Values.size(), std::size_t{3});
  }

  void saveAs_whereNothingCanBeWritten_isReported() {
    openPanel();
    type("FollowPath.temperature", "0.2");
    QSignalSpy told(&window_->docks().context(), &editor::PanelContext::problemsFound);
    QVERIFY(!panel().saveAs(at("scene.yaml/tuned.yaml")));
    QVERIFY(told.count() >= 1);
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"mine.yaml"});
    QCOMPARE(robot().nav2Values.size(), std::size_t{1});
  }

  /// In the window the key belongs to the list that has the focus.
  /// The user's own file, chosen in the panel instead of typed as a path.
  void chooseFile_ofTheUser_isUsedAndUndone() {
    openPanel();
    QVERIFY(QDir(folder_->path()).mkdir(text("own")));
    writeText(at("own/other.yaml"), shipped().replace("temperature: 0.3", "temperature: 0.7"));
    bool isAsked = false;
    quiet::answerDialog<QFileDialog>([&isAsked](QFileDialog& dialog) {
      isAsked = dialog.fileMode() == QFileDialog::ExistingFile;
      dialog.reject();
    });
    auto* choose = widgets::withText<QToolButton>(panel(), text("Choose file…"));
    QVERIFY(choose != nullptr && choose->isVisible());
    QTest::mouseClick(choose, Qt::LeftButton);
    QVERIFY(isAsked);
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"mine.yaml"});  // cancelled
    panel().useFile(at("own/other.yaml"));
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"own/other.yaml"});
    QCOMPARE(row("FollowPath.temperature").text(editor::Nav2ValueColumn), text("0.7"));
    document().undoStack().undo();
    QCOMPARE(robot().nav2Params, std::vector<std::string>{"mine.yaml"});
  }

  /// During a run, changed values are marked until the next start.
  void edit_duringARun_isMarkedUntilTheNextStart() {
    openPanel();
    editor::SimulationRunner& runner = window_->workspace().runner();
    runner.stepOnce();
    QTRY_VERIFY(runner.shownFrame() != nullptr);
    QVERIFY(row("FollowPath.temperature").icon(editor::Nav2ValueColumn).isNull());
    type("FollowPath.temperature", "0.5");
    QVERIFY(!row("FollowPath.temperature").icon(editor::Nav2ValueColumn).isNull());
    QVERIFY(row("FollowPath.temperature")
                .toolTip(editor::Nav2ValueColumn)
                .contains(text("Applies at the next start")));
    QVERIFY(row("FollowPath.batch_size").icon(editor::Nav2ValueColumn).isNull());
    quiet::shoot(*window_, "nav2_pending");
    runner.reset();
    QTRY_VERIFY(row("FollowPath.temperature").icon(editor::Nav2ValueColumn).isNull());
  }

  /// Its errors are those of the scenario's value; they end with the value, and no run is marked.
  void run_refusedForAValue_isForgottenWithTheValue() {
    openPanel();
    const char* const key = "local_costmap.inflation_layer.inflation_radius";
    type(key, "-1");
    editor::SimulationRunner& runner = window_->workspace().runner();
    auto& issues = window_->docks().panel<editor::IssuesPanel>();
    const auto refusal = [&issues] {
      const QAbstractItemModel& rows = *issues.table().model();
      QString found;
      for (int at = 0; at < rows.rowCount(); ++at) {
        const QString sentence = rows.index(at, 0).data().toString();
        found = sentence.contains(text("inflation_radius: -1 must be")) ? sentence : found;
      }
      return found;
    };
    QSignalSpy refused(&runner, &editor::SimulationRunner::notStarted);
    runner.play();
    QTRY_COMPARE(refused.count(), 1);
    QTRY_VERIFY(!refusal().isEmpty());
    QVERIFY2(!refusal().contains(text(".yaml")), qPrintable(refusal()));
    document().undoStack().undo();
    document().checkNow();
    QTRY_VERIFY2(refusal().isEmpty(), qPrintable(refusal()));
    openPanel();
    QTRY_COMPARE(row(key).text(editor::Nav2ValueColumn), row(key).text(editor::Nav2FileColumn));
    QVERIFY(row(key).icon(editor::Nav2ValueColumn).isNull());
  }

  /// Fields of Nav2 are shown only for the planner that uses them.
  void body_ofAnotherPlanner_isNotOffered() {
    const auto isOffered = [this] {
      for (const QLabel* label : window_->findChildren<QLabel*>()) {
        if (label->isVisible() && label->text() == text("Body from Nav2")) {
          return true;
        }
      }
      return false;
    };
    document().setSelection({robot().key});
    QTRY_VERIFY(isOffered());
    document().setSelection({document().scenario().robots.back().key});
    QTRY_VERIFY(!isOffered());
  }

  void deleteKey_resetsTheRow() {
    openPanel();
    type("FollowPath.temperature", "0.2");
    QTRY_COMPARE(panel().form().changedCount(), 1);
    QTreeWidget& tree = panel().form().tree();
    tree.setCurrentItem(&row("FollowPath.temperature"));
    tree.setFocus();
    QTest::keyClick(&tree, Qt::Key_Delete);
    QVERIFY(robot().nav2Values.empty());
    QCOMPARE(document().scenario().robots.size(), std::size_t{2});  // no robot is deleted
  }

  void resetAll_isOneCommand() {
    openPanel();
    type("FollowPath.temperature", "0.2");
    type("FollowPath.vx_max", "0.75");
    auto* reset = widgets::withText<QToolButton>(panel(), text("Reset all"));
    QTest::mouseClick(reset, Qt::LeftButton);
    QVERIFY(robot().nav2Values.empty());
    document().undoStack().undo();
    QCOMPARE(robot().nav2Values.size(), std::size_t{2});
  }
};

QTEST_MAIN(Nav2PanelTest)
#include "tst_Nav2Panel.moc"
