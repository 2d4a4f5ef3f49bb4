#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/panels/properties/PageWidgets.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"
#include "tests/support/Widgets.h"

using editor::ChoiceField;
using editor::EntityId;
using editor::EntityKind;
using editor::NumberField;
using editor::ScenarioDocument;
using editor::TextField;

namespace {

constexpr char kOwnTree[] =
    "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
    "    <RegularNav agent_id=\"{id}\" time_step=\"{dt}\"/>\n  </BehaviorTree>\n</root>\n";

}  // namespace

class PersonPageTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<editor::PropertyPanel> panel_;

  sim2d::Human human(int index) const {
    return document_->scenario().humans[static_cast<std::size_t>(index)];
  }
  void select(std::initializer_list<int> people) {
    std::vector<EntityId> ids;
    for (const int index : people) {
      ids.push_back(human(index).key);
    }
    document_->setSelection(ids);
  }
  template <class Field>
  Field* field(const QString& name) const {
    return widgets::named<Field>(*panel_->currentPage(), name);
  }
  template <class Field>
  void type(const QString& name, const QString& text) {
    Field* widget = field<Field>(name);
    QVERIFY2(widget != nullptr, qPrintable(name));
    widget->setFocus();
    widget->selectAll();
    QTest::keyClicks(widget, text);
    QTest::keyClick(widget, Qt::Key_Return);
  }
  void choose(const QString& name, const QString& words) {
    auto* box = field<ChoiceField>(name);
    QVERIFY2(box != nullptr, qPrintable(name));
    const int index = box->findText(words);
    QVERIFY2(index >= 0, qPrintable(words));
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
  }
  void click(const QString& words) {
    auto* button = widgets::withText<QToolButton>(*panel_->currentPage(), words);
    QVERIFY2(button != nullptr, qPrintable(words));
    QTest::mouseClick(button, Qt::LeftButton);
  }

  bool isTold(const QString& words) const {
    return widgets::findIf<QLabel>(*panel_->currentPage(), [&](const QLabel* label) {
             return label->isVisibleTo(panel_.get()) && label->text().contains(words);
           }) != nullptr;
  }

 private Q_SLOTS:
  /// Trees made with blocks hear of all that is changed, and keep their blocks.
  void tree_madeWithBlocks_isNotCalledTheirOwn() {
    editor::pushAddBlock(*document_, {human(2).key}, {"GreetingInitiator", {}});
    const std::optional<std::string> blocks = document_->tree(human(2).key);
    QVERIFY(blocks.has_value());
    select({2});
    QVERIFY(!isTold(QStringLiteral("custom tree")));
    for (const int person : {0, 1}) {
      document_->exchangeTree(human(person).key, std::string(kOwnTree));
    }
    select({0, 1, 2});
    QVERIFY(
        isTold(QStringLiteral("2 people with custom trees. Behaviour, reaction and goals do "
                              "not affect these trees.")));
    click(QStringLiteral("Regenerate tree"));
    QVERIFY(!document_->tree(human(0).key));
    QVERIFY(!document_->tree(human(1).key));
    QVERIFY(document_->tree(human(2).key) == blocks);
  }

  /// A behaviour that a tree of their own does not hear of is told, and mended by a click.
  void behavior_ofWhoHasATree_tellsAndMakesItAnew() {
    select({0});
    QVERIFY(!isTold(QStringLiteral("Uses a custom tree")));
    document_->exchangeTree(human(0).key, std::string(kOwnTree));
    panel_->currentPage()->refresh();
    QVERIFY(isTold(QStringLiteral("Uses a custom tree")));
    click(QStringLiteral("Regenerate tree"));
    QVERIFY(!document_->tree(human(0).key));
    QVERIFY(!isTold(QStringLiteral("Uses a custom tree")));
    document_->undoStack().undo();
    QVERIFY(document_->tree(human(0).key));
  }

  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(small::scenario());
    panel_ = std::make_unique<editor::PropertyPanel>(*document_, editor::Theme::light());
    panel_->resize(320, 900);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }
  void cleanup() {
    panel_.reset();
    document_.reset();
  }

  void edit_ofOneValue_keepsAllElse() {
    sim2d::Scenario scenario = small::scenario();
    sim2d::Human& ana = scenario.humans[0];
    ana.groupId = 7;
    ana.radius = 0.31;
    ana.goalRadius = 0.55;
    ana.initZ = 1.25;
    ana.unknown = {{"shoe_size", "42"}};
    ana.behavior.unknown = {{"mood", "fine"}};
    document_->load(scenario);
    select({0});
    type<NumberField>(QStringLiteral("Top speed"), QStringLiteral("0.9"));
    sim2d::Human expected = scenario.humans[0];
    expected.maxVel = 0.9;
    QVERIFY(human(0) == expected);
  }

  void factors_ofEverybody_andOnce_areEditable() {
    select({0});
    type<NumberField>(QStringLiteral("Robot"), QStringLiteral("12"));
    QCOMPARE(human(0).behavior.otherForceFactor, std::optional(12.0));
    for (const int person : {2, 3, 4, 5}) {  // curious, surprised, scared, threatening
      select({person});
      auto* once = field<QCheckBox>(QStringLiteral("Only once"));
      QVERIFY(once != nullptr && once->isVisibleTo(panel_->currentPage()));
      once->click();
      QCOMPARE(human(person).behavior.once, std::optional(true));
    }
  }

  void freeze_writesWhatARunOfTheSeedDraws_data() {
    QTest::addColumn<int>("person");
    QTest::addColumn<QString>("mode");
    for (const int person : {0, 2, 4, 5}) {
      for (const char* mode : {"Random, normal", "Random, uniform"}) {
        QTest::addRow("%d %s", person, mode) << person << QString::fromLatin1(mode);
      }
    }
  }
  void freeze_writesWhatARunOfTheSeedDraws() {
    QFETCH(int, person);
    QFETCH(QString, mode);
    select({person});
    choose(QStringLiteral("Strength"), mode);
    type<NumberField>(QStringLiteral("Seed"), QStringLiteral("4711"));
    // What a run with that seed takes.
    sim2d::Scenario seeded = document_->scenario();
    seeded.desktop.seed = 4711;
    const sim2d::ResolvedHuman drawn =
        sim2d::resolveHuman(seeded, human(person), *seeded.desktop.seed);
    QCOMPARE(field<NumberField>(QStringLiteral("Obstacles"))->value(), drawn.obstacleFactor);
    const auto once = human(person).behavior.once;  // is not drawn
    click(QStringLiteral("Freeze"));
    QVERIFY(human(person).behavior.once == once);
    const sim2d::ResolvedHuman frozen =
        sim2d::resolveHuman(document_->scenario(), human(person), 1);
    QCOMPARE(frozen.configuration, sim2d::Configuration::Custom);
    QCOMPARE(frozen.goalFactor, drawn.goalFactor);
    QCOMPARE(frozen.obstacleFactor, drawn.obstacleFactor);
    QCOMPARE(frozen.socialFactor, drawn.socialFactor);
    QCOMPARE(frozen.reactionDuration, drawn.reactionDuration);
    QCOMPARE(frozen.noticeDistance, drawn.noticeDistance);
    QCOMPARE(frozen.reactionSpeed, drawn.reactionSpeed);
    QCOMPARE(frozen.safeDistance, drawn.safeDistance);
    QCOMPARE(frozen.stopDistance, drawn.stopDistance);
    QCOMPARE(frozen.frontDistance, drawn.frontDistance);
  }

  void draws_ofAFile_areTheSameWheneverItIsOpened() {
    select({4});
    choose(QStringLiteral("Strength"), QStringLiteral("Random, uniform"));
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("drawn.yaml"));
    QVERIFY(!base::hasErrors(document_->save(path)));
    const double before = field<NumberField>(QStringLiteral("Obstacles"))->value();
    for (int i = 0; i < 2; ++i) {
      QVERIFY(!base::hasErrors(document_->open(path)));
      select({4});
      QCOMPARE(field<NumberField>(QStringLiteral("Obstacles"))->value(), before);
      QVERIFY(!document_->isDirty());
    }
  }

  void sample_drawsAnew_andTheSeedCanBeTaken() {
    select({0});
    choose(QStringLiteral("Strength"), QStringLiteral("Random, uniform"));
    const double before = field<NumberField>(QStringLiteral("Obstacles"))->value();
    const int steps = document_->undoStack().count();
    for (int i = 0; i < 5; ++i) {
      click(QStringLiteral("Sample"));
    }
    QVERIFY(field<NumberField>(QStringLiteral("Obstacles"))->value() != before);
    QCOMPARE(document_->undoStack().count(), steps);  // only tried out
    const double wanted = field<NumberField>(QStringLiteral("Seed"))->value();
    click(QStringLiteral("Use this seed"));
    QCOMPARE(static_cast<double>(*document_->scenario().desktop.seed), wanted);
  }

  void group_ofTwo_isMadeAndDissolved() {
    select({0, 1});
    choose(QStringLiteral("Walks with"), QStringLiteral("Each other (new group)"));
    QCOMPARE(human(0).groupId, std::optional(1));
    QCOMPARE(human(1).groupId, std::optional(1));
    type<TextField>(QStringLiteral("Group name"), QStringLiteral("friends"));
    QCOMPARE(document_->scenario().desktop.groups.front().second, std::string("friends"));
    click(QStringLiteral("Dissolve"));
    QCOMPARE(human(0).groupId, std::optional(-1));
    QCOMPARE(document_->undoStack().count(), 3);
  }

  void appearance_isThatOfTheSimulator() {
    select({0});
    choose(QStringLiteral("Figure"), QStringLiteral("Worker man"));
    QCOMPARE(human(0).skin, std::optional(4));
    editor::pushChange<editor::ScenarioSettings>(
        *document_, editor::kSettingsId, QStringLiteral("Simulator"),
        [](editor::ScenarioSettings& settings) { settings.simulator = "Webots"; });
    panel_->currentPage()->refresh();
    auto* figure = field<ChoiceField>(QStringLiteral("Figure"));
    QCOMPARE(figure->count(), 4);
    QCOMPARE(figure->currentText(), QStringLiteral("Robert"));  // what Webots takes for 4
    choose(QStringLiteral("Figure"), QStringLiteral("Sophia"));
    QCOMPARE(human(0).skin, std::optional(2));
    QCOMPARE(editor::skinsOf("Isaac Sim").size(), std::size_t(12));
    QCOMPARE(editor::skinsOf("Gazebo Fortress").size(), std::size_t(9));
  }

  /// Each key of a person by its field: what is typed is what the file says.
  void key_ofThePerson_isInTheFile_data() {
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("yaml");
    const auto row = [](const char* label, const char* typed, const char* yaml) {
      QTest::newRow(yaml) << QString::fromUtf8(label) << QString::fromUtf8(typed)
                          << QString::fromUtf8(yaml);
    };
    row("X", "3.5", "x: 3.500");
    row("Y", "4.25", "y: 4.250");
    row("Heading", "90", "h: 1.5707963");
    row("Height z", "1.25", "z: 1.250");
    row("Radius", "0.42", "radius: 0.42");
    row("Top speed", "1.1", "max_vel: 1.1");
    row("Arrival radius", "0.7", "goal_radius: 0.7");
    row("Sees within", "6.5", "dist: 6.5");
    row("Lasts", "33", "duration: 33.0");
    row("Speed", "0.8", "vel: 0.8");
    row("Keeps away", "4.5", "safe_distance: 4.5");
    row("Robot", "17", "other_force_factor: 17.0");
    row("Enters at", "12", "start_time: 12.0");
    row("Mass", "71", "mass: 71.0");
    row("Number", "88", "id: 88");
    row("Waits", "1, 2.5", "wait:\n        - 1.0\n        - 2.5");
    row("Tree file", "own.xml", "tree: own.xml");
  }
  void key_ofThePerson_isInTheFile() {
    QFETCH(QString, label);
    QFETCH(QString, typed);
    QFETCH(QString, yaml);
    sim2d::Scenario scenario = small::scenario();
    scenario.humans[4].goals = {1, 2};  // Farid, scared
    document_->load(scenario);
    select({4});
    if (field<NumberField>(label) != nullptr) {
      type<NumberField>(label, typed);
    } else {
      type<TextField>(label, typed);
    }
    const std::string text = sim2d::writeScenario(document_->scenario());
    const bool there = text.find(yaml.toStdString()) != std::string::npos;
    QVERIFY2(there, text.c_str());
    QVERIFY(sim2d::writeScenario(scenario).find(yaml.toStdString()) == std::string::npos);
  }
};

QTEST_MAIN(PersonPageTest)
#include "tst_PersonPage.moc"
