#include "CanvasTester.h"
#include "editor/document/MapEdit.h"

/// Which part of the ground the view shows when the map changes.
class MapViewPlaceTest : public QObject, protected CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(small::scenario()); }

  void map_thatIsPaintedOn_leavesTheViewWhereItIs() {
    view_.zoomIn();
    const double scale = view_.pixelsPerMetre();
    const Vec2 corner = view_.worldAt({0, 0});
    document_.setMap(std::make_shared<sim2d::OccupancyGrid>(*small::room()));
    QCOMPARE(view_.pixelsPerMetre(), scale);
    QVERIFY(isNear(view_.worldAt({0, 0}), corner));
    document_.setMap(editor::emptyRoom(40.0, 30.0));  // another ground is shown as a whole
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
};

QTEST_MAIN(MapViewPlaceTest)
#include "tst_MapViewPlace.moc"
