#include <cmath>
#include <set>

#include "ScenarioTest.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"
#include "sim2d/scenario/Variation.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

constexpr int kDraws = 10000;

double density(double x) {
  return std::isfinite(x) ? std::exp(-x * x / 2.0) / std::sqrt(2.0 * base::kPi) : 0.0;
}
double timesDensity(double x) {
  return std::isfinite(x) ? x * density(x) : 0.0;
}
double below(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

std::vector<double> drawsOf(const Spread& spread, VariationQuantity quantity) {
  std::vector<double> values;
  values.reserve(kDraws);
  for (int person = 0; person < kDraws; ++person) {
    values.push_back(drawFrom(spread, quantity, base::AgentRng(5, person)));
  }
  return values;
}

struct Moments {
  double mean = 0.0, deviation = 0.0, errorOfDeviation = 0.0;
};

Moments momentsOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) {
    moments.mean += value / count;
  }
  double second = 0.0;
  double fourth = 0.0;
  for (const double value : values) {
    const double square = (value - moments.mean) * (value - moments.mean);
    second += square / count;
    fourth += square * square / count;
  }
  moments.deviation = std::sqrt(second);
  moments.errorOfDeviation = std::sqrt((fourth - second * second) / (4.0 * second * count));
  return moments;
}

std::string fileWith(const std::string& lines) {
  return "hunav_loader:\n  ros__parameters:\n    agents: []\nhunavsim_desktop:\n"
         "  ros__parameters:\n    format: 1\n" +
         lines;
}

ScenarioReading read(const std::string& lines) {
  return readScenarioText(fileWith(lines), "file.yaml");
}

Human walker(int id, int group = -1) {
  Human human;
  human.id = id;
  human.groupId = group;
  human.goals = {4, 5, 6, 7, 8};
  human.ours.wait = {0.4, 0.5, 0.6, 0.7, 0.8};
  return human;
}

VariationSettings strong() {
  VariationSettings settings;
  settings.preset = VariationPreset::Strong;
  return settings;
}

}  // namespace

/// The key `variation`: what is drawn, and how it is read and written.
class VariationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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

  void draws_manyPeople_meanAndDeviationAreThoseOfTheDistribution_data() {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    addColumns<bool, double, double, double, double>(
        {"isNormal", "centre", "width", "low", "high"});
    QTest::newRow("normal") << true << 0.0 << 0.3 << -kFar << kFar;
    QTest::newRow("normal, cut on both sides") << true << 1.0 << 0.2 << 0.8 << 1.3;
    QTest::newRow("normal, a narrow range") << true << 1.0 << 2.0 << 0.9 << 1.2;
    QTest::newRow("normal, one side alone") << true << 0.0 << 2.0 << 0.0 << kFar;
    QTest::newRow("uniform") << false << 0.0 << 5.0 << -kFar << kFar;
    QTest::newRow("uniform, cut") << false << 1.0 << 0.5 << 0.75 << 10.0;
  }

  /// Closed forms: of the normal distribution truncated to [a, b] standard deviations the mean is
  /// (phi(a) - phi(b)) / Z, the variance 1 + (a phi(a) - b phi(b)) / Z - mean².
  void draws_manyPeople_meanAndDeviationAreThoseOfTheDistribution() {
    QFETCH(bool, isNormal);
    QFETCH(double, centre);
    QFETCH(double, width);
    QFETCH(double, low);
    QFETCH(double, high);
    const Spread spread{
        isNormal ? SpreadKind::Normal : SpreadKind::Uniform, centre, width, width, low, high};
    double mean = 0.0;
    double deviation = 0.0;
    if (isNormal) {
      const double from = (low - centre) / width;
      const double to = (high - centre) / width;
      const double all = below(to) - below(from);
      const double shift = (density(from) - density(to)) / all;
      mean = centre + width * shift;
      deviation =
          width * std::sqrt(1.0 + (timesDensity(from) - timesDensity(to)) / all - shift * shift);
    } else {
      const double from = std::max(low, centre - width);
      const double to = std::min(high, centre + width);
      mean = (from + to) / 2.0;
      deviation = (to - from) / std::sqrt(12.0);
    }
    const std::vector<double> values = drawsOf(spread, VariationQuantity::Speed);
    for (const double value : values) {
      QVERIFY2(value >= low && value <= high, qPrintable(QString::number(value)));
    }
    const Moments found = momentsOf(values);
    const QString text = QStringLiteral("%1 ± %2, wanted %3 ± %4")
                             .arg(found.mean)
                             .arg(found.deviation)
                             .arg(mean)
                             .arg(deviation);
    QVERIFY2(std::fabs(found.mean - mean) < 4.0 * deviation / std::sqrt(1.0 * kDraws),
             qPrintable(text));
    QVERIFY2(std::fabs(found.deviation - deviation) < 4.0 * found.errorOfDeviation,
             qPrintable(text));
  }

  void apply_sameSeedAndPerson_sameDraws() {
    const VariationSettings settings = strong();
    const auto drawn = [&](long long seed, int id) {
      ResolvedHuman person;
      person.desiredSpeed = 2.0;
      PersonVariation(settings, seed, id, -1).apply(person);
      return std::vector<double>{person.startTime, person.start.heading, person.desiredSpeed,
                                 person.reactionTime};
    };
    const std::vector<double> first = drawn(3, 7);
    QVERIFY(drawn(3, 7) == first);
    for (std::size_t i = 0; i < first.size(); ++i) {
      QVERIFY(drawn(4, 7)[i] != first[i]);
      QVERIFY(drawn(3, 8)[i] != first[i]);
    }
    QVERIFY(first[0] >= 0.0 && first[0] <= 5.0);
    QVERIFY(first[2] >= 1.0 && first[2] <= 3.0);
  }

  void apply_widthsOfZero_nothingMoves() {
    VariationSettings settings;
    for (SpreadSettings& spread : settings.spreads) {
      spread.kind = SpreadKind::Normal;
      spread.sd = 0.0;
    }
    ResolvedHuman person;
    person.startTime = 2.0;
    person.start.heading = 0.5;
    PersonVariation draws(settings, 1, 1, -1);
    draws.apply(person);
    QCOMPARE(person.startTime, 2.0);
    QCOMPARE(person.start.heading, 0.5);
    QCOMPARE(person.desiredSpeed, ResolvedHuman().desiredSpeed);
    QCOMPARE(person.reactionTime, 1.0);
    QVERIFY(draws.startOffset(0) == Vec2(0.0, 0.0));
    QCOMPARE(draws.firstGoal(5), std::size_t{0});
  }

  void firstGoal_uniform_everyGoalAlike() {
    const VariationSettings settings = strong();
    std::vector<int> counts(5, 0);
    for (int id = 0; id < kDraws; ++id) {
      const FirstGoal first = firstGoalOf(settings, walker(id), 1);
      ++counts[static_cast<std::size_t>(first.index)];
      QCOMPARE(first.goals.front(), 4 + first.index);
      QCOMPARE(first.wait.front(), 0.4 + 0.1 * first.index);
      QCOMPARE(std::set<int>(first.goals.begin(), first.goals.end()).size(), std::size_t{5});
    }
    const double error = std::sqrt(kDraws * 0.2 * 0.8);  // binomial
    for (const int count : counts) {
      QVERIFY2(std::fabs(count - kDraws * 0.2) < 4.0 * error, qPrintable(QString::number(count)));
    }
  }

  void firstGoal_group_beginsTogether() {
    const VariationSettings settings = strong();
    std::set<int> indices;
    for (int seed = 1; seed <= 20; ++seed) {
      const int index = firstGoalOf(settings, walker(1, 3), seed).index;
      QCOMPARE(firstGoalOf(settings, walker(2, 3), seed).index, index);
      indices.insert(index);
    }
    QVERIFY(indices.size() > 2);
  }

  void firstGoal_oneWayRoute_staysWhole() {
    for (int id = 0; id < 20; ++id) {
      Human human = walker(id);
      human.cyclicGoals = false;
      QVERIFY(firstGoalOf(strong(), human, 1).goals == human.goals);
    }
  }

  void spreadOf_ownKeys_comeBeforeThePreset() {
    VariationSettings settings;
    QVERIFY(!isVaried(settings));
    settings.of(VariationQuantity::Speed).sd = 0.3;  // of no kind yet
    QVERIFY(!isVaried(settings));
    settings.preset = VariationPreset::Light;
    QVERIFY(isVaried(settings));
    QVERIFY(spreadOf(settings, VariationQuantity::Speed).kind == SpreadKind::Normal);
    QCOMPARE(spreadOf(settings, VariationQuantity::Speed).sd, 0.3);
    QCOMPARE(spreadOf(settings, VariationQuantity::Speed).least, 0.1);  // not the preset's
    QCOMPARE(spreadOf(settings, VariationQuantity::ReactionTime).least, 0.8);
    settings.of(VariationQuantity::Start).kind = SpreadKind::None;
    QVERIFY(spreadOf(settings, VariationQuantity::Start).kind == SpreadKind::None);
    QVERIFY(spreadOf(settings, VariationQuantity::Heading).kind == SpreadKind::Normal);
  }

  void read_everyKey_isThere() {
    const ScenarioReading reading = read(
        "    variation:\n      preset: strong\n      start:\n        kind: uniform\n"
        "        half_width: 0.5\n        min: -0.25\n        max: 0.75\n      speed:\n"
        "        sd: 0.2\n");
    QVERIFY2(reading.diagnostics.empty() || reading.ok(), qPrintable(shown(reading.diagnostics)));
    const VariationSettings& variation = reading.scenario.desktop.variation;
    QVERIFY(variation.preset == VariationPreset::Strong);
    const SpreadSettings& start = variation.of(VariationQuantity::Start);
    QVERIFY(start.kind == SpreadKind::Uniform && start.halfWidth == 0.5);
    QVERIFY(start.min == -0.25 && start.max == 0.75 && !start.sd);
    QVERIFY(variation.of(VariationQuantity::Speed).sd == 0.2);
  }

  void read_badInput_errorWithLine_data() {
    addColumns<QString, int>({"lines", "line"});
    QTest::newRow("preset") << "    variation:\n      preset: much\n" << 8;
    QTest::newRow("no map") << "    variation: light\n" << 7;
    QTest::newRow("kind") << "    variation:\n      speed:\n        kind: gauss\n" << 9;
    QTest::newRow("sd") << "    variation:\n      speed:\n        kind: normal\n        sd: -0.1\n"
                        << 10;
    QTest::newRow("no number") << "    variation:\n      start:\n        kind: uniform\n"
                                  "        half_width: wide\n"
                               << 10;
    QTest::newRow("not finite") << "    variation:\n      start:\n        kind: normal\n"
                                   "        sd: .nan\n"
                                << 10;
    QTest::newRow("least above") << "    variation:\n      speed:\n        kind: normal\n"
                                    "        min: 1.2\n"
                                 << 10;
    QTest::newRow("most below") << "    variation:\n      start_time:\n        kind: uniform\n"
                                   "        max: -1.0\n"
                                << 10;
    QTest::newRow("quantity") << "    variation:\n      speed: 0.2\n" << 8;
  }

  void read_badInput_errorWithLine() {
    QFETCH(QString, lines);
    QFETCH(int, line);
    const ScenarioReading reading = read(lines.toStdString());
    QVERIFY(!reading.ok());
    std::set<int> told;
    for (const base::Diagnostic& each : reading.diagnostics) {
      if (each.severity == base::Severity::Error) {
        told.insert(each.line);
      }
    }
    QVERIFY2(told.count(line) == 1, qPrintable(shown(reading.diagnostics)));
  }

  void read_widthOfAnotherKind_isToldToHaveNoEffect() {
    const ScenarioReading reading = read(
        "    variation:\n      speed:\n        sd: 0.2\n      start:\n        kind: uniform\n"
        "        sd: 0.5\n");
    QVERIFY(reading.ok());
    std::vector<int> lines;
    for (const base::Diagnostic& each : reading.diagnostics) {
      if (each.code == "scenario.spread-unused") {
        lines.push_back(each.line);
      }
    }
    QVERIFY(lines == (std::vector<int>{9, 12}) || lines == (std::vector<int>{12, 9}));
  }

  void read_unknownKeys_areKept() {
    const std::string lines =
        "    variation:\n      preset: light\n      speed:\n        kind: normal\n"
        "        colour: red\n      strange: 1\n";
    const ScenarioReading reading = read(lines);
    QVERIFY(reading.ok());
    const std::string text = writeScenario(reading.scenario);
    QVERIFY2(text.find(lines) != std::string::npos, text.c_str());
  }

  void setValue_presetAndQuantity() {
    Scenario scenario = read("    seed: 2\n").scenario;
    QVERIFY(!base::hasErrors(setValue(scenario, "variation.preset", "strong")));
    QVERIFY(!base::hasErrors(setValue(scenario, "variation.speed.sd", "0.05")));
    QVERIFY(!base::hasErrors(setValue(scenario, "variation.first_goal.kind", "none")));
    QVERIFY(scenario.desktop.variation.preset == VariationPreset::Strong);
    QVERIFY(scenario.desktop.variation.of(VariationQuantity::Speed).sd == 0.05);
    QVERIFY(scenario.desktop.variation.of(VariationQuantity::FirstGoal).kind == SpreadKind::None);
    const Scenario before = scenario;
    QVERIFY(base::hasErrors(setValue(scenario, "variation.preset", "much")));
    QVERIFY(base::hasErrors(setValue(scenario, "variation.speed.width", "1.0")));
    QVERIFY(scenario == before);
  }

  void write_presetNone_isLeftOut() {
    Scenario scenario = read("    seed: 2\n").scenario;
    const std::string plain = writeScenario(scenario);
    scenario.desktop.variation.preset = VariationPreset::None;
    QCOMPARE(QString::fromStdString(writeScenario(scenario)), QString::fromStdString(plain));
  }
};

QTEST_APPLESS_MAIN(VariationTest)
#include "tst_Variation.moc"
