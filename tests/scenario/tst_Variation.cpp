#include <cmath>
#include <set>

#include <QtTest>

#include "ScenarioTest.h"
#include "sim2d/base/Math.h"
#include "sim2d/scenario/Variation.h"

using namespace sim2d;

namespace {

constexpr int kDraws = 10000;

struct Moments {
  double mean = 0.0, sd = 0.0, least = 0.0, most = 0.0;
};

/// Of one draw for each of so many people.
Moments momentsOf(const Spread& spread, Varied quantity, std::uint64_t seed = 7) {
  std::vector<double> all;
  all.reserve(kDraws);
  for (int id = 0; id < kDraws; ++id) {
    all.push_back(drawFrom(spread, quantity, base::AgentRng(seed, id)));
  }
  Moments moments;
  moments.least = *std::min_element(all.begin(), all.end());
  moments.most = *std::max_element(all.begin(), all.end());
  for (const double value : all) {
    moments.mean += value / kDraws;
  }
  double squares = 0.0;
  for (const double value : all) {
    squares += (value - moments.mean) * (value - moments.mean);
  }
  moments.sd = std::sqrt(squares / (kDraws - 1));
  return moments;
}

double density(double z) {
  return std::exp(-z * z / 2.0) / std::sqrt(2.0 * base::kPi);
}
double distribution(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

/// Mean and deviation of the standard normal distribution between two limits: Johnson, Kotz and
/// Balakrishnan, Continuous Univariate Distributions 1 (1994), 13.10.1.
Moments truncatedMoments(double from, double to) {
  const double mass = distribution(to) - distribution(from);
  const double mean = (density(from) - density(to)) / mass;
  const double variance = 1.0 + (from * density(from) - to * density(to)) / mass - mean * mean;
  return {mean, std::sqrt(variance), from, to};
}

Scenario withVariation(const std::string& lines) {
  const std::string text =
      "hunav_loader:\n  ros__parameters:\n    agents: []\nhunavsim_desktop:\n"
      "  ros__parameters:\n    format: 1\n    variation:\n" +
      lines;
  ScenarioReading reading = readScenarioText(text, "test.yaml");
  return reading.ok() ? reading.scenario : Scenario();
}

}  // namespace

class VariationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void normalDraws_haveTheMomentsOfTheTruncatedDistribution_data() {
    QTest::addColumn<double>("sd");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::newRow("two deviations either way") << 0.1 << -0.2 << 0.2;
    QTest::newRow("one side") << 0.5 << -0.1 << 3.0;
    QTest::newRow("narrow, taken from the range") << 1.0 << -0.3 << 0.4;
    QTest::newRow("from the middle on") << 2.0 << 0.0 << 20.0;
    QTest::newRow("wide") << 0.3 << -3.0 << 3.0;
  }
  void normalDraws_haveTheMomentsOfTheTruncatedDistribution() {
    QFETCH(double, sd);
    QFETCH(double, low);
    QFETCH(double, high);
    Spread spread;
    spread.kind = SpreadKind::Normal;
    spread.centre = 1.0;
    spread.sd = sd;
    spread.least = 1.0 + low;
    spread.most = 1.0 + high;
    const Moments drawn = momentsOf(spread, Varied::Speed);
    const Moments wanted = truncatedMoments(low / sd, high / sd);
    const double wantedSd = sd * wanted.sd;
    QVERIFY(drawn.least >= spread.least);
    QVERIFY(drawn.most <= spread.most);
    QVERIFY(std::abs(drawn.mean - 1.0 - sd * wanted.mean) < 4.0 * wantedSd / std::sqrt(kDraws));
    // the standard error of a deviation is at most sd / sqrt(2 n) for tails no heavier than normal
    QVERIFY(std::abs(drawn.sd - wantedSd) < 4.0 * wantedSd / std::sqrt(2.0 * kDraws));
  }

  void uniformDraws_fillTheirRange() {
    Spread spread;
    spread.kind = SpreadKind::Uniform;
    spread.halfWidth = 2.0;
    spread.least = -1.0;
    const Moments drawn = momentsOf(spread, Varied::Start);  // from -1 to 2
    const double wantedSd = 3.0 / std::sqrt(12.0);
    QVERIFY(drawn.least >= -1.0 && drawn.least < -0.99);
    QVERIFY(drawn.most <= 2.0 && drawn.most > 1.99);
    QVERIFY(std::abs(drawn.mean - 0.5) < 4.0 * wantedSd / std::sqrt(kDraws));
    QVERIFY(std::abs(drawn.sd - wantedSd) < 4.0 * wantedSd / std::sqrt(2.0 * kDraws));
  }

  void draws_ofAnotherSeedPersonOrQuantity_differ() {
    Spread spread;
    spread.kind = SpreadKind::Uniform;
    spread.halfWidth = 1.0;
    std::set<double> all;
    for (const std::uint64_t seed : {1, 2}) {
      for (const int id : {1, 2}) {
        for (const Varied quantity : {Varied::Start, Varied::Speed}) {
          all.insert(drawFrom(spread, quantity, base::AgentRng(seed, id)));
        }
      }
    }
    QCOMPARE(all.size(), std::size_t{8});
    QCOMPARE(drawFrom(spread, Varied::Start, base::AgentRng(1, 1)),
             drawFrom(spread, Varied::Start, base::AgentRng(1, 1)));
  }

  void spread_keysOfAQuantity_comeBeforeThePreset() {
    const Scenario scenario = withVariation(
        "      preset: strong\n      speed:\n        sd: 0.05\n      start:\n        kind: none\n");
    const VariationSettings& settings = scenario.desktop.variation;
    const Spread speed = spreadOf(settings, Varied::Speed);
    QCOMPARE(speed.kind, SpreadKind::Normal);
    QCOMPARE(speed.sd, 0.05);
    QCOMPARE(spreadOf(settings, Varied::Start).kind, SpreadKind::None);
    QCOMPARE(spreadOf(settings, Varied::FirstGoal).kind, SpreadKind::Uniform);
    QVERIFY(isVaried(settings));
    QVERIFY(!isVaried(VariationSettings()));
  }

  void firstGoal_ofACyclicList_isEachAsOften() {
    const Scenario scenario = withVariation("      preset: strong\n");
    std::vector<int> count(4);
    for (int id = 0; id < kDraws; ++id) {
      const PersonVariation draws(scenario.desktop.variation, 3, id, -1);
      ++count[draws.firstGoal(count.size())];
    }
    const double error = std::sqrt(kDraws * 0.25 * 0.75);  // binomial
    for (const int each : count) {
      QVERIFY(std::abs(each - kDraws * 0.25) < 4.0 * error);
    }
  }

  void withFirstGoal_turnsGoalsAndWaitsAlike() {
    const Scenario scenario = withVariation("      preset: strong\n");
    Human human;
    human.goals = {5, 6, 7};
    human.ours.wait = {0.5, 0.6, 0.7};
    std::set<int> first;
    for (human.id = 0; human.id < 40; ++human.id) {
      const Human turned = withFirstGoal(scenario.desktop.variation, human, 1);
      first.insert(turned.goals.front());
      for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(turned.ours.wait[i], turned.goals[i] / 10.0);
        QCOMPARE(turned.goals[(i + 1) % 3], 5 + (turned.goals[i] - 4) % 3);
      }
    }
    QCOMPARE(first.size(), std::size_t{3});
    human.cyclicGoals = false;
    QCOMPARE(withFirstGoal(scenario.desktop.variation, human, 1).goals, human.goals);
  }

  void group_comesTogether() {
    const Scenario scenario = withVariation("      preset: strong\n");
    std::set<double> times;
    std::set<double> speeds;
    for (const int id : {1, 2, 3}) {
      ResolvedHuman person;
      PersonVariation(scenario.desktop.variation, 4, id, 2).apply(person);
      times.insert(person.startTime);
      speeds.insert(person.desiredSpeed);
    }
    QCOMPARE(times.size(), std::size_t{1});
    QCOMPARE(speeds.size(), std::size_t{3});
  }

  void dependsOnSeed_tellsWhatMakesSeedsDiffer() {
    Scenario scenario;
    QVERIFY(!dependsOnSeed(scenario));
    scenario.robots.emplace_back();
    scenario.humans.emplace_back();
    QVERIFY(!dependsOnSeed(scenario));
    Scenario drawn = scenario;
    drawn.humans[0].behavior.configuration = Configuration::Normal;
    QVERIFY(dependsOnSeed(drawn));
    Scenario noisy = scenario;
    noisy.robots[0].detector.noise = 0.1;
    QVERIFY(dependsOnSeed(noisy));
    Scenario varied = scenario;
    varied.desktop.variation.preset = VariationPreset::Light;
    QVERIFY(dependsOnSeed(varied));
    Scenario visited = scenario;
    visited.areas.emplace_back();
    visited.areas[0].kind = AreaKind::Source;
    visited.areas[0].rate = 0.5;
    QVERIFY(dependsOnSeed(visited));
  }
};

QTEST_APPLESS_MAIN(VariationTest)
#include "tst_Variation.moc"
