#include <algorithm>
#include <random>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/tools/SelectionActions.h"
#include "sim2d/base/Text.h"
#include "tests/support/Interop.h"

using namespace editor;

namespace {

/// All of a document that a command may change.
struct Whole {
  sim2d::Scenario scenario;
  std::string bytes;
  std::vector<std::optional<std::string>> trees;
  sim2d::OccupancyGrid map;

  explicit Whole(const ScenarioDocument& document)
      : scenario(document.scenario()),
        bytes(sim2d::writeScenario(document.scenario())),
        map(*document.map()) {
    for (const sim2d::Human& human : scenario.humans) {
      trees.push_back(document.tree(human.key));
    }
  }
  friend bool operator==(const Whole& a, const Whole& b) {
    return a.scenario == b.scenario && a.bytes == b.bytes && a.trees == b.trees && a.map == b.map;
  }
};

/// Does anything a user could do, drawn by a seed.
class RandomUser {
 public:
  RandomUser(ScenarioDocument& document, unsigned seed) : document_(document), random_(seed) {}

  void act() {
    const std::function<void()> actions[] = {
        [this] { pushAdd(document_, made()); },
        [this] { pushAdd(document_, made()); },
        [this] {
          pushMove(document_, some(), {number(), number()}, merge());
        },
        [this] { turn(); },
        [this] { pushRemove(document_, some()); },
        [this] { pushRemove(document_, some()); },
        [this] {
          if (all().size() < 60) {
            pushDuplicate(document_, some(), {0.5, -0.5});
          }
        },
        [this] { pushRename(document_, any(), "name" + std::to_string(whole(1, 50))); },
        [this] { pushGoalNumber(document_, any(EntityKind::Goal), whole(-1, 30)); },
        [this] {
          pushRoute(document_, some(), {whole(1, 12), whole(1, 12)});
        },
        [this] { pushReorder(document_, {any()}, whole(0, 5)); },
        [this] { change(); },
        [this] { tree(); },
        [this] { pushListed(document_, some(), whole(0, 1) == 0); },
        [this] { group(); },
        [this] { changeOther(); },
        [this] { copyAndPaste(); },
        [this] { block(); },
        [this] { whole(0, 9) == 0 ? otherMap() : paint(); }};
    actions[whole(0, 18)]();
  }

 private:
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Merge merge() { return whole(0, 1) == 0 ? Merge::Never : Merge::WithPrevious; }
  double number() { return std::uniform_real_distribution<double>(-3.0, 3.0)(random_); }

  std::vector<EntityId> all() const {
    std::vector<EntityId> ids;
    for (const EntityKind kind : {EntityKind::Human, EntityKind::Goal, EntityKind::Robot,
                                  EntityKind::Obstacle, EntityKind::Door, EntityKind::Area}) {
      const std::vector<EntityId> more = document_.entities(kind);
      ids.insert(ids.end(), more.begin(), more.end());
    }
    return ids;
  }
  EntityId any() {
    const std::vector<EntityId> ids = all();
    return ids.empty() ? EntityId() : ids[static_cast<std::size_t>(whole(0, int(ids.size()) - 1))];
  }
  EntityId any(EntityKind kind) {
    const std::vector<EntityId> ids = document_.entities(kind);
    return ids.empty() ? EntityId() : ids[static_cast<std::size_t>(whole(0, int(ids.size()) - 1))];
  }
  std::vector<EntityId> some() {
    std::vector<EntityId> ids = {any()};
    if (whole(0, 3) == 0) {
      const EntityId other = any();
      if (other != ids.front()) {
        ids.push_back(other);
      }
    }
    ids.erase(std::remove(ids.begin(), ids.end(), EntityId()), ids.end());
    return ids;
  }

  Entity made() {
    const base::Vec2 at(5.0 + number(), 4.0 + number());
    switch (whole(0, 5)) {
      case 5: {
        sim2d::Robot robot;
        robot.start = {at, number()};
        return robot;
      }
      case 0: {
        sim2d::Human human;
        human.initPose = {at, number()};
        human.behavior.type = static_cast<sim2d::BehaviorType>(whole(1, 6));
        return human;
      }
      case 1: {
        sim2d::GlobalGoal goal;
        goal.position = at;
        return goal;
      }
      case 2: {
        sim2d::Obstacle obstacle;
        obstacle.kind = sim2d::ObstacleKind::Circle;
        obstacle.pose.position = at;
        return obstacle;
      }
      case 3: {
        sim2d::Door door;
        door.from = at;
        door.to = at + base::Vec2(1.0, 0.0);
        return door;
      }
      default: {
        sim2d::Area area;
        area.points = {at, at + base::Vec2(1.0, 0.0), at + base::Vec2(0.0, 1.0)};
        return area;
      }
    }
  }

  void change() {
    pushChange<sim2d::Human>(
        document_, any(EntityKind::Human), QStringLiteral("Speed"),
        [this](sim2d::Human& human) { human.maxVel = 1.0 + 0.1 * whole(0, 9); }, merge());
    pushChange<ScenarioSettings>(
        document_, kSettingsId, QStringLiteral("Seed"),
        [this](ScenarioSettings& settings) { settings.desktop.seed = whole(1, 99); });
  }

  /// The size of something, or the goal of a robot.
  void changeOther() {
    pushChange<sim2d::Obstacle>(
        document_, any(EntityKind::Obstacle), QStringLiteral("Radius"),
        [this](sim2d::Obstacle& obstacle) { obstacle.radius = 0.1 * whole(1, 9); });
    pushChange<sim2d::Door>(document_, any(EntityKind::Door), QStringLiteral("Open"),
                            [this](sim2d::Door& door) { door.open = whole(0, 1) == 0; });
    pushChange<sim2d::Area>(document_, any(EntityKind::Area), QStringLiteral("Corner"),
                            [this](sim2d::Area& area) { area.points.front().x() += number(); });
    pushChange<sim2d::Robot>(document_, any(EntityKind::Robot), QStringLiteral("Goal"),
                             [this](sim2d::Robot& robot) {
                               robot.goal.point = base::Vec2(5.0 + number(), 4.0 + number());
                             });
  }

  void group() {
    const EntityId first = any(EntityKind::Human);
    const EntityId second = any(EntityKind::Human);
    if (!first || first == second) {
      return;
    }
    const int number = document_.human(first)->groupId.value_or(-1);
    switch (number < 0 ? 0 : whole(0, 3)) {
      case 0:
        pushGroup(document_, {first, second});
        return;
      case 1:
        return pushJoinGroup(document_, {second}, number);
      case 2:
        return pushGroupName(document_, number, "group " + std::to_string(whole(1, 9)));
      default:
        return pushDissolveGroup(document_, number);
    }
  }

  void copyAndPaste() {
    if (all().size() < 60) {
      document_.setSelection(some());
      const std::unique_ptr<QMimeData> copied = copiedSelection(document_);
      paste(document_, *copied, {number(), number()});
    }
  }

  void block() {
    if (const EntityId person = any(EntityKind::Human)) {
      pushAddBlock(document_, {person},
                   {whole(0, 1) == 0 ? "GreetingInitiator" : "RobotAvoidance", {}});
    }
  }

  void turn() {
    std::vector<Entity> values;
    const double heading = number();
    for (const EntityId id : some()) {
      values.push_back(withHeading(*document_.entity(id), heading));
    }
    pushEdit(document_, std::move(values), QStringLiteral("Turn"));
  }

  void otherMap() {
    pushMap(document_, {emptyRoom(6.0 + whole(0, 4), 5.0, 0.2), {}, false, {}},
            std::get<ScenarioSettings>(*document_.entity(kSettingsId)), QStringLiteral("Map"));
  }

  void tree() {
    const EntityId person = any(EntityKind::Human);
    if (!person) {
      return;
    }
    std::optional<std::string> xml;
    if (whole(0, 2) != 0) {
      xml = "<root BTCPP_format=\"4\"><!-- " + std::to_string(whole(0, 9)) + " --></root>";
    }
    pushTrees(document_, {{person, xml}}, QStringLiteral("Tree"));
  }

  void paint() {
    MapStroke stroke(document_.map());
    stroke.paint({6.0 + number(), 4.5 + number()}, {6.0 + number(), 4.5 + number()}, 0.1,
                 whole(0, 1) == 0 ? MapPaint::Occupied : MapPaint::Free);
    pushStroke(document_, stroke, QStringLiteral("Paint"));
  }

  ScenarioDocument& document_;
  std::mt19937 random_;
};

bool copyFolder(const QString& from, const QString& to) {
  QDirIterator files(from, QDir::Files, QDirIterator::Subdirectories);
  bool fine = QDir().mkpath(to);
  while (files.hasNext()) {
    const QString file = files.next();
    const QString target = to + file.mid(from.size());
    fine = QDir().mkpath(QFileInfo(target).path()) && QFile::copy(file, target) && fine;
    QFile::setPermissions(target, QFile::ReadOwner | QFile::WriteOwner);
  }
  return fine;
}

}  // namespace

class RandomEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tenThousandCommands_undoAllRedoAll_giveEqualDocuments_data() {
    QTest::addColumn<unsigned>("seed");
    QTest::newRow("seed 1") << 1U;
    QTest::newRow("seed 2") << 2U;
  }
  void tenThousandCommands_undoAllRedoAll_giveEqualDocuments() {
    QFETCH(unsigned, seed);
    ScenarioDocument document;
    document.load(small::scenario());
    document.setMap(std::make_shared<sim2d::OccupancyGrid>(60, 45, 0.2, sim2d::Pose2{},
                                                           std::vector<std::int8_t>(2700, 0)));
    const Whole before(document);
    RandomUser user(document, seed);
    int commands = 0;
    while (commands < 10000) {
      const int count = document.undoStack().count();
      user.act();
      commands += document.undoStack().count() > count ? 1 : 0;
    }
    const Whole after(document);
    QVERIFY(!(before == after));
    while (document.undoStack().canUndo()) {
      document.undoStack().undo();
    }
    QVERIFY(before == Whole(document));
    while (document.undoStack().canRedo()) {
      document.undoStack().redo();
    }
    QVERIFY(after == Whole(document));
    // and half of it, twice
    const int half = document.undoStack().count() / 2;
    document.undoStack().setIndex(half);
    const Whole middle(document);
    document.undoStack().setIndex(document.undoStack().count());
    QVERIFY(after == Whole(document));
    document.undoStack().setIndex(half);
    QVERIFY(middle == Whole(document));
  }

  void interopScenario_onePersonMoved_onlyTheirPoseDiffers_data() {
    QTest::addColumn<QString>("file");
    for (const QString& folder : {QStringLiteral(TEST_DATA_DIR "/interop"), interopFolder()}) {
      QDirIterator files(folder + QStringLiteral("/hunavsim2"), {QStringLiteral("*.yaml")},
                         QDir::Files, QDirIterator::Subdirectories);
      while (files.hasNext()) {
        const QString file = files.next();
        const base::Result<std::string> text = base::readTextFile(file.toStdString());
        if (text && text->find("init_pose") != std::string::npos) {
          QTest::newRow(qPrintable(file.mid(folder.size() + 11))) << file;
        }
      }
    }
  }
  void interopScenario_onePersonMoved_onlyTheirPoseDiffers() {
    QFETCH(QString, file);
    const QTemporaryDir folder;
    const QString top = QFileInfo(QFileInfo(file).path()).path();  // with its trees and maps
    QVERIFY(copyFolder(top, folder.filePath(QStringLiteral("all"))));
    const QString copy = folder.filePath(QStringLiteral("all")) + file.mid(top.size());
    ScenarioDocument document;
    const base::Diagnostics problems = document.open(copy);
    QVERIFY2(!base::hasErrors(problems), problems.empty() ? "" : problems[0].text().c_str());
    const std::string canonical = sim2d::writeScenario(document.scenario());
    QVERIFY(canonical == sim2d::writeScenario(sim2d::readScenario(file.toStdString()).scenario));
    const EntityId person = document.entities(EntityKind::Human).back();
    pushMove(document, {person}, Vec2(0.25, -0.125));
    QVERIFY(!base::hasErrors(document.save(copy)));
    const std::string saved = *base::readTextFile(copy.toStdString());
    const std::vector<std::string> was = base::split(canonical, '\n');
    const std::vector<std::string> is = base::split(saved, '\n');
    QCOMPARE(is.size(), was.size());
    std::vector<std::string> changed;
    std::string inside;
    for (std::size_t i = 0; i < was.size(); ++i) {
      if (was[i].size() > 4 && was[i].compare(0, 4, "    ") == 0 && was[i][4] != ' ') {
        inside = base::trimmed(was[i]);
      }
      if (was[i] != is[i]) {
        changed.push_back(base::trimmed(is[i]).substr(0, 2));
        QVERIFY(inside.find(document.human(person)->name) != std::string::npos);
      }
    }
    QVERIFY(changed == (std::vector<std::string>{"x:", "y:"}));
    // no tree was touched
    QDirIterator trees(top, {QStringLiteral("*.xml")}, QDir::Files, QDirIterator::Subdirectories);
    while (trees.hasNext()) {
      const QString tree = trees.next();
      QVERIFY(*base::readTextFile(tree.toStdString()) ==
              *base::readTextFile(
                  (folder.filePath(QStringLiteral("all")) + tree.mid(top.size())).toStdString()));
    }
  }
};

QTEST_MAIN(RandomEditsTest)
#include "tst_RandomEdits.moc"
