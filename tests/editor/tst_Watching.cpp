#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/panels/properties/PropertyPanel.h"

using editor::PropertyPanel;

namespace {

/// A moment with Ana, somebody whom a source brought in, and the robot.
sim2d::Frame moment(const base::Vec2& robot) {
  sim2d::Frame frame;
  frame.humans.add(1, {{2.0, 2.0}, 0.0}, {0.5, 0.0}, 0.0, 2);
  frame.humans.add(99, {{7.0, 7.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
  frame.humans.group = {-1, -1};
  frame.humans.state = {0, 1};
  frame.robots.add(-1, {robot, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
  return frame;
}

}  // namespace

/// Who is looked at in a run: people and robots of the scenario, and those from sources.
class WatchingTest : public QObject, protected CanvasTester {
  Q_OBJECT

 private:
  bool says(const PropertyPanel& panel, const char* words) const {
    const QList<QLabel*> labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->text() == QString::fromUtf8(words) && label->isVisibleTo(&panel);
    });
  }

 private Q_SLOTS:
  void init() { start(small::scenario()); }
  void cleanup() { scene_.showFrame(nullptr); }

  void click_onSomebodyFromASource_looksAtThem() {
    sim2d::TraceHeader header;
    header.humans.resize(1);
    header.humans[0].id = 99;
    header.humans[0].name = "entrance_1";
    header.humans[0].behavior = static_cast<int>(sim2d::BehaviorType::Curious);
    sim2d::Recording recording;
    recording.setHeader(header);
    recording.addState(moment({10.0, 3.0}));
    tools_.setEditingEnabled(false);
    scene_.showFrame(recording.frame(0), &recording);
    click({7.0, 7.0});
    QVERIFY(scene_.spawnedAgent() == 99);
    QVERIFY(document_.selection().empty());
    QCOMPARE(scene_.frameLayer().nameOf(99), QStringLiteral("entrance_1"));
    click({2.0, 2.0});
    QVERIFY(!scene_.spawnedAgent());
    QVERIFY(document_.isSelected(person(1)));
    click({7.0, 7.0});
    QVERIFY(scene_.spawnedAgent() == 99);
    scene_.showFrame(nullptr);
    QVERIFY(!scene_.spawnedAgent());
  }

  void page_ofSomebodyFromASource_tellsBehaviourGoalAndState() {
    PropertyPanel panel(document_, editor::Theme::light());
    panel.showFrame(std::make_shared<const sim2d::Frame>(moment({10.0, 3.0})));
    sim2d::TraceHuman spawnedAgent;
    spawnedAgent.id = 99;
    spawnedAgent.name = "entrance_1";
    spawnedAgent.behavior = static_cast<int>(sim2d::BehaviorType::Curious);
    spawnedAgent.goals = {{3, {1.0, 1.0}, 0.3}};
    panel.setSpawnedAgent(spawnedAgent);
    QVERIFY(says(panel, "entrance_1"));
    QVERIFY(says(panel, "Person 99 · Curious · goals 3"));
    QVERIFY(says(panel, "7.00, 7.00 m"));
    QVERIFY(says(panel, "reacting"));
    QVERIFY(!says(panel, "Changes take effect at the next start."));
    document_.setSelection({person(1)});
    panel.setSpawnedAgent(std::nullopt);
    QVERIFY(says(panel, "Ana") && !says(panel, "entrance_1"));
    QVERIFY(says(panel, "Changes take effect at the next start."));
  }

  void step_inShares_isWalkedSmoothly() {
    const auto show = [this](const base::Vec2& robot) {
      scene_.showFrame(std::make_shared<const sim2d::Frame>(moment(robot)));
    };
    const auto isAt = [this](const base::Vec2& place) {
      return isNear(*scene_.frameLayer().positionOf(-1), place, 1e-9);
    };
    show({10.0, 3.0});
    show({10.8, 3.0});
    QVERIFY(isAt({10.8, 3.0}));  // a frame alone is shown as it is
    scene_.setFrameInterpolation(0.25);
    QVERIFY(isAt({10.2, 3.0}));
    scene_.setFrameInterpolation(1.0);
    QVERIFY(isAt({10.8, 3.0}));
    show({2.0, 3.0});  // set somewhere else, not walked
    scene_.setFrameInterpolation(0.25);
    QVERIFY(isAt({2.0, 3.0}));
  }

  void trail_ofAStepInShares_endsAtTheBody() {
    const auto color = [this](bool trails) {
      editor::CanvasOptions options = scene_.options();
      options.trails = trails;
      scene_.setOptions(options);
      const QImage picture = view_.viewport()->grab().toImage();
      return picture.pixelColor(view_.viewportFrom({10.4, 8.0}));
    };
    scene_.showFrame(std::make_shared<const sim2d::Frame>(moment({10.0, 8.0})));
    sim2d::Frame next = moment({10.9, 8.0});
    next.time = 0.1;
    scene_.showFrame(std::make_shared<const sim2d::Frame>(next));
    QVERIFY(color(true) != color(false));
    scene_.setFrameInterpolation(0.0);
    QVERIFY(color(true) == color(false));
  }

  /// The model `das` has a body radius of its own (density-based model, b = 0.2 m).
  void body_beforeTheRun_isAsLargeAsInIt_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("radius");
    QTest::newRow("own") << "das" << 0.2;
    QTest::newRow("the scenario's") << "sfm" << 0.31;
    QTest::newRow("unknown model") << "no_such_model" << 0.31;
  }
  void body_beforeTheRun_isAsLargeAsInIt() {
    QFETCH(QString, model);
    auto ana = std::get<sim2d::Human>(*document_.entity(person(1)));
    ana.radius = 0.31;
    ana.ours.model = model.toStdString();
    QTEST(scene_.bodyRadius(ana), "radius");
    QCOMPARE(scene_.isSizable(ana), model != QLatin1String("das"));
  }

  /// As the pin on the map and the list of the scenario have it.
  void goal_ofAPerson_hasTheNumberOfItsPin() {
    PropertyPanel panel(document_, editor::Theme::light());
    document_.setSelection({person(1)});
    panel.showFrame(std::make_shared<const sim2d::Frame>(moment({10.0, 3.0})));
    QVERIFY(says(panel, "Goal 2"));
    QCOMPARE(editor::displayName(*document_.entity(document_.goalKey(2))), editor::goalName(2));
  }

  void goal_ofARobotThatHasAPoint_isThePoint() {
    PropertyPanel panel(document_, editor::Theme::light());
    document_.setSelection(document_.entities(base::EntityKind::Robot));
    QVERIFY(says(panel, "Robot · pursuit · to 1.50, 1.00 m"));
    panel.showFrame(std::make_shared<const sim2d::Frame>(moment({10.0, 3.0})));
    QVERIFY(says(panel, "1.50, 1.00 m"));
    panel.showFrame(std::make_shared<const sim2d::Frame>(moment({1.5, 1.1})));
    QVERIFY(says(panel, "1.50, 1.00 m, reached"));
    editor::pushChange<sim2d::Robot>(document_, document_.selection().front(), QString(),
                                     [](sim2d::Robot& robot) { robot.goal = {}; });
    QVERIFY(says(panel, "Robot · pursuit · stands still"));
  }
};

QTEST_MAIN(WatchingTest)
#include "tst_Watching.moc"
