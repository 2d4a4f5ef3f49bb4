#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/RouteModel.h"
#include "editor/canvas/ViewOverlays.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PersonTree.h"

using namespace editor;

namespace {

const QRectF kEverywhere(-1e4, -1e4, 2e4, 2e4);

Label labelAt(const QPointF& centre, double clearance, const QSizeF& size, int priority) {
  Label label;
  label.centre = centre;
  label.clearancePx = clearance;
  label.size = size;
  label.priority = priority;
  return label;
}

sim2d::Frame frameOf(const sim2d::Scenario& scenario, double time) {
  sim2d::Frame frame;
  frame.time = time;
  frame.step = std::llround(time / 0.05);
  for (const sim2d::Human& human : scenario.humans) {
    const double heading = human.initPose.heading;
    frame.humans.add(human.id, {human.initPose.ahead(time), heading},
                     {std::cos(heading), std::sin(heading)}, 0.0, sim2d::kNoGoal);
    frame.humans.group.push_back(-1);
    frame.humans.state.push_back(0);
    frame.forces.goal.push_back({1.2, 0.3});
    frame.forces.social.push_back({-0.5, 0.6});
    frame.forces.obstacle.push_back({0.1, -0.4});
    frame.forces.group.push_back(Vec2::Zero());
  }
  frame.robots.add(-1, {{10.6 - time, 3.4}, base::kPi}, {-1.0, 0.0}, 0.0, sim2d::kNoGoal);
  frame.robotPaths = {{{10.6 - time, 3.4}, {6.0, 4.5}, {1.5, 1.0}}};
  frame.doorOpen = {1};
  return frame;
}

}  // namespace

/// With HUNAV_PICTURES set to a folder, what the canvas looks like is written there.
class CanvasTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start(small::scenario());
    view_.resize(860, 640);
    view_.fitAll(false);
    scene_.routes().finish();
  }

  void zoomBy_atAPoint_keepsItInPlace() {
    const QPoint at(200, 150);
    const Vec2 before = view_.worldAt(at);
    view_.zoomBy(2.0, at);
    QVERIFY((view_.worldAt(at) - before).norm() * view_.pixelsPerMetre() < 2.0);
  }

  void fitAll_afterwards_showsTheWholeMap() {
    view_.zoomBy(9.0, QPointF(5.0, 5.0));
    view_.fitAll(false);
    const QRect window = view_.viewport()->rect();
    QVERIFY(window.contains(view_.viewportFrom(Vec2(0.0, 0.0))));
    QVERIFY(window.contains(view_.viewportFrom(Vec2(12.0, 9.0))));
    QVERIFY(view_.viewportFrom(Vec2(0.0, 0.0)).y() > view_.viewportFrom(Vec2(0.0, 9.0)).y());
  }

  void wall_onTheCanvas_hasTheColourOfTheTheme() {
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      scene_.setTheme(theme);
      const QImage picture = view_.grab().toImage();
      QCOMPARE(picture.pixelColor(view_.viewportFrom(Vec2(6.04, 2.5))),
               theme.color(Role::MapOccupied));
      QCOMPARE(picture.pixelColor(view_.viewportFrom(Vec2(0.1, 4.5))),
               theme.color(Role::MapOccupied));
    }
    scene_.setTheme(Theme::light());
  }

  void entityAt_inAClosedWall_isWhatStandsInTheRoom() {
    sim2d::Obstacle room;
    room.key = {EntityKind::Obstacle, 901};
    room.name = "room";
    room.kind = sim2d::ObstacleKind::Wall;
    room.points = {{20.0, 0.0}, {26.0, 0.0}, {26.0, 6.0}, {20.0, 6.0}, {20.0, 0.0}};
    room.thickness = 0.1;
    sim2d::Dock dock;
    dock.key = {EntityKind::Dock, 902};
    dock.name = "home";
    dock.pose = {{22.0, 2.0}, 0.0};
    editor::pushAdd(document_, room);
    editor::pushAdd(document_, dock);
    QVERIFY(!scene_.entityAt(Vec2(24.5, 4.5)));  // the floor of the room
    QVERIFY(scene_.entityAt(Vec2(22.0, 2.0)).kind == EntityKind::Dock);
    QVERIFY(scene_.entityAt(Vec2(23.0, 0.0)).kind == EntityKind::Obstacle);
  }

  void entityAt_overlapping_prefersPeople() {
    QVERIFY(scene_.entityAt(Vec2(2.0, 2.0)) == EntityId({EntityKind::Human, 1}));
    QVERIFY(scene_.entityAt(Vec2(4.2, 1.4)) == EntityId({EntityKind::Obstacle, 31}));
    QVERIFY(scene_.entityAt(Vec2(1.5, 1.0)) == EntityId({EntityKind::Robot, 21}));
    QVERIFY(!scene_.entityAt(Vec2(11.0, 8.0)));
  }

  void routes_aroundTheWall_goThroughTheGap() {
    const EntityRoute* route = scene_.routes().route({EntityKind::Human, 1});
    QVERIFY(route != nullptr);
    QCOMPARE(route->size(), std::size_t{3});
    QVERIFY(route->back().points.back() == route->front().points.back());  // returns
    const RouteLeg& leg = route->front();
    QVERIFY(leg.isReachable);
    QVERIFY(leg.points.size() > 2);
    bool throughGap = false;
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Vec2& a = leg.points[i - 1];
      const Vec2& b = leg.points[i];
      if ((a.x() - 6.0) * (b.x() - 6.0) <= 0.0 && a.x() != b.x()) {
        const double y = a.y() + (6.0 - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        throughGap = throughGap || (y > 3.5 && y < 5.5);
      }
    }
    QVERIFY(throughGap);
  }

  /// A custom tree replaces the goals if it does not use them.
  void routes_ofACustomTree_areThoseOfTheTree() {
    const EntityId person{EntityKind::Human, 1};
    const auto routeWith = [&](const char* nodes) {
      editor::pushTreeText(document_, person,
                           std::string("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">"
                                       "<Sequence>") +
                               nodes + "</Sequence></BehaviorTree></root>",
                           QStringLiteral("Tree"));
      scene_.routes().finish();
      const EntityRoute* route = scene_.routes().route(person);
      return route == nullptr ? EntityRoute() : *route;
    };
    const EntityRoute own = *scene_.routes().route(person);
    const EntityRoute one = routeWith("<GoTo agent_id=\"{id}\" goal_id=\"2\"/>");
    QCOMPARE(one.size(), std::size_t{1});
    QVERIFY(one.front().points.back() == document_.scenario().goal(2)->position);
    QCOMPARE(editor::walkedGoals(document_, *document_.human(person)), std::vector<int>{2});
    QVERIFY(routeWith("<AlwaysSuccess/>").empty());
    QVERIFY(routeWith("<RegularNav agent_id=\"{id}\" dt=\"{dt}\"/>") == own);
    const EntityRoute named =  // a name and a comment are no nodes
        routeWith("<!-- no RegularNav --><GoTo name=\"SetGoal\" agent_id=\"{id}\" goal_id=\"2\"/>");
    QVERIFY(named == one);
    for (int k = 0; k < 4; ++k) {
      document_.undoStack().undo();
    }
    scene_.routes().finish();
    QVERIFY(*scene_.routes().route(person) == own);
  }

  void routes_ofTenSelectedPeople_showAllLegs() {
    sim2d::Scenario scenario;
    scenario.goals = {small::goal(11, 1, {7.0, 7.5}), small::goal(12, 2, {11.0, 7.5})};
    std::vector<EntityId> all;
    for (int key = 1; key <= 10; ++key) {
      scenario.humans.push_back(small::person(key, qPrintable(QString::number(key)),
                                              {7.0 + 0.4 * key, 0.6}, 0.0,
                                              sim2d::BehaviorType::Regular, {1, 2}));
      all.push_back(scenario.humans.back().key);
    }
    document_.load(scenario);
    document_.setMap(small::room());
    scene_.routes().finish();
    CanvasOptions options;
    options.names = options.grid = false;
    scene_.setOptions(options);
    const auto isDrawn = [this] {  // between the goals, where only the second leg is
      QImage picture(90, 24, QImage::Format_RGB32);
      picture.fill(Qt::white);
      QPainter painter(&picture);
      scene_.render(&painter, picture.rect(), QRectF(toScene({8.0, 7.7}), toScene({9.5, 7.3})));
      painter.end();
      for (int x = 0; x < picture.width(); ++x) {
        for (int y = 0; y < picture.height(); ++y) {
          if (picture.pixel(x, y) != QColor(Qt::white).rgb()) {
            return true;
          }
        }
      }
      return false;
    };
    document_.setSelection({});
    QVERIFY(!isDrawn());
    document_.setSelection(all);
    QVERIFY(isDrawn());
  }

  void routeStrength_manyRoutes_fadesButStays() {
    QCOMPARE(editor::routeOpacity(0), 1.0);
    QCOMPARE(editor::routeOpacity(12), 1.0);
    double before = 1.0;
    for (const std::size_t count : {20u, 60u, 100u, 300u}) {
      QVERIFY(editor::routeOpacity(count) < before);
      before = editor::routeOpacity(count);
    }
    QVERIFY(editor::routeOpacity(100) < 0.45);
    QVERIFY(editor::routeOpacity(5000) > 0.1);
  }

  void preview_ofAValue_isShownAndCleared() {
    sim2d::Human moved = *document_.human({EntityKind::Human, 1});
    moved.initPose.position = {5.0, 8.0};
    scene_.setPreview({moved});
    QVERIFY(scene_.entityAt(Vec2(5.0, 8.0)) == EntityId({EntityKind::Human, 1}));
    scene_.clearPreview();
    QVERIFY(!scene_.entityAt(Vec2(5.0, 8.0)));
    QVERIFY(document_.scenario() == small::scenario());
  }

  void layoutLabels_crowded_neverOverlap() {
    std::vector<Label> labels;
    labels.reserve(30);
    for (int i = 0; i < 30; ++i) {
      labels.push_back(labelAt({i * 9.0, (i % 3) * 7.0}, 10.0, {40.0, 12.0}, i % 2));
    }
    const std::vector<QRectF> places =
        layoutLabels(labels, {QRectF(0.0, 0.0, 20.0, 60.0)}, kEverywhere);
    int shown = 0;
    for (std::size_t a = 0; a < places.size(); ++a) {
      shown += places[a].isNull() ? 0 : 1;
      for (std::size_t b = a + 1; b < places.size(); ++b) {
        QVERIFY(!places[a].intersects(places[b]));
      }
    }
    QVERIFY(shown >= 8);
    QVERIFY(!places[1].isNull());
  }

  void layoutLabels_atTheEdge_staysWithinAndBeside_data() {
    QTest::addColumn<QPointF>("centre");
    QTest::addColumn<bool>("hasRoom");
    QTest::newRow("left") << QPointF(3.0, 100.0) << true;
    QTest::newRow("left, half seen") << QPointF(-6.0, 100.0) << true;
    QTest::newRow("right") << QPointF(297.0, 100.0) << true;
    QTest::newRow("top") << QPointF(150.0, 2.0) << true;
    QTest::newRow("bottom") << QPointF(150.0, 198.0) << true;
    QTest::newRow("corner") << QPointF(0.0, 200.0) << true;
    QTest::newRow("far out") << QPointF(-80.0, 100.0) << false;
  }

  void layoutLabels_atTheEdge_staysWithinAndBeside() {
    QFETCH(QPointF, centre);
    const QRectF window(0.0, 0.0, 300.0, 200.0);
    Label label = labelAt(centre, 12.0, {60.0, 14.0}, 1);
    label.isNeeded = true;
    const QRectF place = layoutLabels({label}, {}, window).front();
    QTEST(!place.isNull(), "hasRoom");
    if (!place.isNull()) {
      QVERIFY(window.contains(place));
      const QRectF around(centre - QPointF(12.5, 12.5), QSizeF(25.0, 25.0));
      QVERIFY2(place.intersects(around), "stands beside its person");
    }
  }

  /// A label does not change its side while that is free, also if a preferred side becomes free.
  void layoutLabels_bodyPasses_theSideStays() {
    Label label = labelAt({0.0, 0.0}, 10.0, {40.0, 12.0}, 1);
    std::vector<int> sides;
    for (int x = -60; x <= 60; x += 5) {  // A body passes below.
      const QRectF body(x - 8.0, 10.0, 16.0, 16.0);
      const QRectF place = layoutLabels({label}, {body}, kEverywhere).front();
      QVERIFY(!place.intersects(body));
      label.side = sideOf(label, place, kEverywhere);
      if (sides.empty() || sides.back() != label.side) {
        sides.push_back(label.side);
      }
    }
    QCOMPARE(sides, (std::vector<int>{0, 1}));  // Below, then above.
  }

  /// One that was left out returns when there is some more space than it needs.
  void layoutLabels_leftOut_returnsWithSpareRoom() {
    Label label = labelAt({0.0, 0.0}, 10.0, {40.0, 12.0}, 1);
    label.side = Label::kHiddenSide;
    const auto walls = [](double gap) {  // Above, and below at a distance.
      return std::vector<QRectF>{QRectF(-200.0, -200.0, 400.0, 205.0),
                                 QRectF(-200.0, 22.0 + gap, 400.0, 200.0)};
    };
    QVERIFY(layoutLabels({label}, walls(1.0), kEverywhere).front().isNull());
    label.side = Label::kNoSide;
    QVERIFY(!layoutLabels({label}, walls(1.0), kEverywhere).front().isNull());
    Label shown = label;
    shown.side = 0;
    label.side = Label::kHiddenSide;
    const std::vector<QRectF> places = layoutLabels({label, shown}, walls(1.0), kEverywhere);
    QVERIFY(places[0].isNull() && !places[1].isNull());  // The shown one stays.
  }

  void layoutLabels_noRoom_onlyTheNeededOneCoversBodies() {
    const QRectF body(-200.0, -200.0, 400.0, 400.0);
    const Label label = labelAt({0.0, 0.0}, 10.0, {40.0, 12.0}, 1);
    Label needed = label;
    needed.isNeeded = true;
    const std::vector<QRectF> places = layoutLabels({label, needed, needed}, {body}, kEverywhere);
    QVERIFY(places[0].isNull());
    QVERIFY(!places[1].isNull() && !places[2].isNull());
    QVERIFY(!places[1].intersects(places[2]));
  }

  void niceLength_anyZoom_isRound() {
    QCOMPARE(niceLength(50.0, 100.0), 2.0);
    QCOMPARE(niceLength(43.0, 100.0), 2.0);
    QCOMPARE(niceLength(400.0, 100.0), 0.2);
  }

  void showFrame_people_areDrawnWhereTheyAre() {
    const auto frame = std::make_shared<const sim2d::Frame>(frameOf(document_.scenario(), 0.5));
    scene_.showFrame(frame);
    QVERIFY(scene_.isRunMode());
    const QImage picture = view_.grab().toImage();
    const Vec2 ana(frame->humans.x[0], frame->humans.y[0]);
    const QColor head = picture.pixelColor(view_.viewportFrom(ana));
    QVERIFY(std::abs(head.hue() - scene_.theme().head(Look::Regular).hue()) < 12);
    QVERIFY(scene_.frameLayer().agentAt(ana) == 1);
    scene_.showFrame(nullptr);
    QVERIFY(!scene_.isRunMode());
  }

  void forcesOn_person_lastIsTheSum() {
    const std::vector<ForceArrow> forces = forcesOn(frameOf(document_.scenario(), 0.0), 1);
    QCOMPARE(forces.size(), std::size_t{5});
    QVERIFY((forces.back().force - Vec2(0.8, 0.5)).norm() < 1e-12);
    QVERIFY(forcesOn(frameOf(document_.scenario(), 0.0), 99).empty());
  }

  void map_thatIsPaintedOn_leavesTheViewWhereItIs() {
    view_.zoomIn();
    const double scale = view_.pixelsPerMetre();
    const Vec2 corner = view_.worldAt({0, 0});
    document_.setMap(std::make_shared<sim2d::OccupancyGrid>(*small::room()));
    QCOMPARE(view_.pixelsPerMetre(), scale);
    QVERIFY(isNear(view_.worldAt({0, 0}), corner));
    document_.setMap(emptyRoom(40.0, 30.0));  // another ground is shown as a whole
    QVERIFY(view_.pixelsPerMetre() < scale);
    QVERIFY(view_.viewport()->rect().contains(view_.viewportFrom({39.0, 29.0})));
  }

  /// Maps of robots have much around them that nobody has seen.
  void fit_onAMapThatIsKnownInPart_showsWhatIsKnown() {
    constexpr int kSize = 400;
    std::vector<std::int8_t> cells(static_cast<std::size_t>(kSize) * kSize, -1);
    for (int row = 180; row < 220; ++row) {
      for (int column = 160; column < 220; ++column) {
        const int cell = row * kSize + column;
        cells[static_cast<std::size_t>(cell)] = 0;
      }
    }
    document_.load(sim2d::Scenario());
    document_.setMap(std::make_shared<sim2d::OccupancyGrid>(kSize, kSize, 0.1, sim2d::Pose2{},
                                                            std::move(cells)));
    view_.fitAll(false);
    const QRect seen = view_.viewport()->rect();
    QVERIFY(seen.contains(view_.viewportFrom({16.0, 18.0})));
    QVERIFY(seen.contains(view_.viewportFrom({22.0, 22.0})));
    QVERIFY(!seen.contains(view_.viewportFrom({1.0, 20.0})));
    QVERIFY(!seen.contains(view_.viewportFrom({39.0, 20.0})));
  }

  void pictures() {
    const QString folder = qEnvironmentVariable("HUNAV_PICTURES");
    if (folder.isEmpty()) {
      QSKIP("HUNAV_PICTURES is not set");
    }
    for (const Theme& theme : {Theme::light(), Theme::dark()}) {
      const QString kind = theme.isDark() ? QStringLiteral("dark") : QStringLiteral("light");
      scene_.setTheme(theme);
      document_.setSelection({});
      save(folder, QStringLiteral("edit-") + kind);
      document_.setSelection({{EntityKind::Human, 3}});
      CanvasOptions options;
      options.proxemics = true;
      options.rulers = true;
      scene_.setOptions(options);
      save(folder, QStringLiteral("selected-") + kind);
      document_.setSelection(document_.entities(EntityKind::Obstacle));
      document_.toggleSelected({EntityKind::Area, 41});
      document_.toggleSelected({EntityKind::Robot, 21});
      document_.toggleSelected({EntityKind::Goal, 12});
      scene_.setOptions({});
      save(folder, QStringLiteral("shapes-") + kind);
      run(folder, kind);
    }
    scene_.setTheme(Theme::light());
  }

 private:
  void run(const QString& folder, const QString& kind) {
    document_.setSelection({{EntityKind::Human, 3}});
    CanvasOptions options;
    options.forces = true;
    scene_.setOptions(options);
    for (int step = 0; step < 30; ++step) {
      const double time = 0.05 * step;
      scene_.showFrame(std::make_shared<const sim2d::Frame>(frameOf(document_.scenario(), time)));
    }
    sim2d::Event say;
    say.kind = sim2d::EventKind::Say;
    say.id = 2;
    say.text = "Two coffees, table 3";
    scene_.frameLayer().addSpeech({say}, 1.0);
    view_.setCanvasState(CanvasState::Running);
    save(folder, QStringLiteral("run-") + kind);
    view_.setCanvasState(CanvasState::Editing);
    scene_.showFrame(nullptr);
    scene_.setOptions({});
  }

  void save(const QString& folder, const QString& name) {
    QVERIFY(view_.grab().save(QStringLiteral("%1/canvas-%2.png").arg(folder, name)));
  }
};

QTEST_MAIN(CanvasTest)
#include "tst_Canvas.moc"
