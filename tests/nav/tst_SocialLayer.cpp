#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <QtTest>

#include "tests/nav/CostmapScenes.h"

using namespace costmapscenes;

namespace {

sim2d::TrackedBody personAt(double x, double y, const Vec2& velocity, double heading) {
  sim2d::TrackedBody person;
  person.position = {x, y};
  person.velocity = velocity;
  person.heading = heading;
  return person;
}

/// Cells of 0.1 m, 10 m wide, a person at the centre of cell (50, 50).
CostmapSetup socialSetup(const SocialLayerParameters& parameters = {}) {
  CostmapSetup setup = plainSetup(10, 0.1);
  setup.settings.plugins = {{"social_layer", parameters}};
  return setup;
}

int costAt(const LayeredCostmap& costmap, int column, int row) {
  return costmap.costmap().at({column, row});
}

}  // namespace

/// Formula of Kirby 2010 in the form with A, B, C of its appendix, and by hand.
class SocialLayerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void update_places_followKirbysFormula() {
    for (const double speed : {0.0, 0.2, 0.8, 1.5}) {
      const double ahead = std::fmax(2.0 * speed, 0.5);
      LayeredCostmap costmap(socialSetup());
      Observation observation = at({1.0, 1.0}, 0.0);
      observation.bodies = {personAt(5.05, 5.05, {speed, 0.0}, 0.0)};
      costmap.updateNow(observation);
      for (int column = -30; column <= 30; ++column) {
        for (int row = -20; row <= 20; ++row) {
          const double x = 0.1 * column, y = 0.1 * row;
          // Her algorithm 1 with theta = 0; behind: alpha <= 0.
          const double alpha = std::remainder(std::atan2(y, x) + base::kPi / 2.0, 2.0 * base::kPi);
          const double sigma = alpha <= 0.0 ? ahead / 2.0 : ahead;
          const double side = 2.0 / 3.0 * ahead;
          const double a = 1.0 / (2.0 * sigma * sigma), c = 1.0 / (2.0 * side * side);
          const double expected = 252.0 * std::exp(-(a * x * x + c * y * y));
          const int found = costAt(costmap, 50 + column, 50 + row);
          const bool isRounding = std::fabs(expected - std::round(expected)) < 1e-9;
          QVERIFY(found == (expected < 10.0 ? 0 : static_cast<int>(expected)) || isRounding);
        }
      }
    }
  }

  /// At 1 m/s: 2 m ahead, 1 m behind, 4/3 m to the sides.
  void update_walkingPerson_castsCostsAhead() {
    LayeredCostmap costmap(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    observation.bodies = {personAt(5.05, 5.05, {1.0, 0.0}, 0.0)};
    costmap.updateNow(observation);
    QCOMPARE(costAt(costmap, 50, 50), 252);
    QCOMPARE(costAt(costmap, 70, 50), static_cast<int>(252.0 * std::exp(-0.5)));    // 2 m ahead
    QCOMPARE(costAt(costmap, 30, 50), static_cast<int>(252.0 * std::exp(-2.0)));    // 2 m behind
    QCOMPARE(costAt(costmap, 50, 62), static_cast<int>(252.0 * std::exp(-0.405)));  // 0.9 sigma
    QCOMPARE(costAt(costmap, 50, 38), costAt(costmap, 50, 62));
    // Below the cutoff of 10 nothing: sqrt(2 ln 25.2) = 2.54 deviations.
    QVERIFY(costAt(costmap, 25, 50) >= 10);  // 2.5 behind
    QCOMPARE(costAt(costmap, 24, 50), 0);    // 2.6
    for (const std::uint8_t cost : costmap.costmap().costs()) {
      QVERIFY(cost == 0 || cost >= 10);
    }
  }

  void update_standingPerson_hasTheLeastDeviation() {
    LayeredCostmap costmap(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    observation.bodies = {personAt(5.05, 5.05, {0.0, 0.0}, 0.0)};
    costmap.updateNow(observation);
    QCOMPARE(costAt(costmap, 55, 50), static_cast<int>(252.0 * std::exp(-0.5)));
    QCOMPARE(costAt(costmap, 45, 50), static_cast<int>(252.0 * std::exp(-2.0)));
  }

  void update_turnedPerson_turnsItsCosts() {
    LayeredCostmap east(socialSetup()), north(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    observation.bodies = {personAt(5.05, 5.05, {0.9, 0.0}, 0.0)};
    east.updateNow(observation);
    observation.bodies = {personAt(5.05, 5.05, {0.0, 0.9}, base::kPi / 2.0)};
    north.updateNow(observation);
    for (int across = -30; across <= 30; ++across) {
      for (int up = -30; up <= 30; ++up) {  // a quarter turn: (across, up) -> (-up, across)
        const int difference =
            costAt(east, 50 + across, 50 + up) - costAt(north, 50 - up, 50 + across);
        QVERIFY(std::abs(difference) <= 1 || costAt(east, 50 + across, 50 + up) == 10 ||
                costAt(north, 50 - up, 50 + across) == 10);  // rounding
      }
    }
  }

  void update_personGone_isWiped() {
    LayeredCostmap costmap(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    observation.bodies = {personAt(3.0, 3.0, {0.5, 0.0}, 0.0)};
    costmap.updateNow(observation);
    QVERIFY(count(costmap.costmap(), kFreeSpace) < 10000);
    observation.bodies = {personAt(8.0, 8.0, {0.5, 0.0}, 0.0)};
    costmap.updateNow(observation);
    QCOMPARE(costAt(costmap, 30, 30), 0);
    observation.bodies.clear();
    costmap.updateNow(observation);
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 10000);
  }

  void update_robots_areNoPeople() {
    LayeredCostmap costmap(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    observation.bodies = {personAt(5.0, 5.0, {0.5, 0.0}, 0.0)};
    observation.bodies[0].kind = sim2d::BodyKind::Robot;
    costmap.updateNow(observation);
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 10000);
  }

  void update_otherCosts_areRaisedOnly() {
    CostmapSetup setup = socialSetup();
    setup.settings.parameters.trackUnknownSpace = true;
    setup.settings.plugins.insert(setup.settings.plugins.begin(),
                                  {"obstacle_layer", obstacleLayer()});
    LayeredCostmap costmap(setup);
    const LaserScan scan = beamTo({2.05, 5.05}, {5.25, 5.05}, 0.0);
    Observation observation = at({1.0, 1.0}, 0.0, &scan);
    observation.bodies = {personAt(5.05, 5.05, {0.0, 0.0}, 0.0)};
    costmap.updateNow(observation);
    QCOMPARE(costAt(costmap, 52, 50), 254);
    QCOMPARE(costAt(costmap, 51, 50), static_cast<int>(252.0 * std::exp(-0.02)));
    QCOMPARE(costAt(costmap, 50, 51), static_cast<int>(252.0 * std::exp(-0.045)));  // was unknown
    QCOMPARE(costAt(costmap, 90, 90), 255);
  }

  void update_disabled_doesNothing() {
    SocialLayerParameters off;
    off.enabled = false;
    SocialLayerParameters faint;
    faint.amplitude = 5.0;  // below the cutoff
    for (const SocialLayerParameters& parameters : {off, faint}) {
      LayeredCostmap costmap(socialSetup(parameters));
      Observation observation = at({1.0, 1.0}, 0.0);
      observation.bodies = {personAt(5.0, 5.0, {0.5, 0.0}, 0.0)};
      costmap.updateNow(observation);
      QCOMPARE(count(costmap.costmap(), kFreeSpace), 10000);
    }
  }

  void update_amplitude_isNoCollisionByDefault() {
    LayeredCostmap costmap(socialSetup());
    Observation observation = at({1.0, 1.0}, 0.0);
    for (int i = 0; i < 20; ++i) {
      observation.bodies.push_back(personAt(5.0 + 0.1 * i, 5.0, {1.0, 0.0}, 0.0));
    }
    costmap.updateNow(observation);
    for (const std::uint8_t cost : costmap.costmap().costs()) {
      QVERIFY(cost < kInscribed);
    }
  }
};

QTEST_APPLESS_MAIN(SocialLayerTest)
#include "tst_SocialLayer.moc"
