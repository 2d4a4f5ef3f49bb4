#include <cmath>
#include <functional>

#include <QtTest>

#include "metrics/statistics/ConfidenceSequences.h"
#include "sim2d/base/Rng.h"
#include "tests/statistics/Near.h"

using namespace statistics;

namespace {

/// Draws in (0, 1) that belong to one sequence.
double draw(int sequence, int number, int stratum = 0) {
  const base::AgentRng rng(75, stratum, static_cast<std::uint64_t>(sequence));
  return rng.uniform01(base::DrawPurpose::Test, static_cast<std::uint32_t>(number));
}

/// 1, -1 or 0, as the difference of the success of two options.
double ternary(double u, double better, double worse) {
  return u < better ? 1.0 : u < better + worse ? -1.0 : 0.0;
}

struct Population {
  const char* name;
  Interval range;
  double mean;
  std::function<Numbers(int sequence, int round)> observe;
};

std::vector<Population> populations() {
  const auto single = [](const std::function<double(double)>& value) {
    return [value](int sequence, int round) { return Numbers{value(draw(sequence, round))}; };
  };
  return {
      {"rate 10 %", {0.0, 1.0}, 0.1, single([](double u) { return u < 0.1 ? 1.0 : 0.0; })},
      {"rate 50 %", {0.0, 1.0}, 0.5, single([](double u) { return u < 0.5 ? 1.0 : 0.0; })},
      {"equal options", {-1.0, 1.0}, 0.0, single([](double u) { return ternary(u, 0.1, 0.1); })},
      {"rare losses", {-1.0, 1.0}, -0.1, single([](double u) { return ternary(u, 0.0, 0.1); })},
      {"steps", {-1.0, 1.0}, 0.0, single([](double u) {
         return std::floor(21.0 * u) / 10.0 - 1.0;
       })},
      {"one long tail", {-1.0, 1.0}, 0.0, single([](double u) { return u < 0.9 ? -0.1 : 0.9; })},
      {"three strata", {-1.0, 1.0}, 0.0, [](int sequence, int round) {
         return Numbers{ternary(draw(sequence, round, 1), 0.6, 0.0),
                        ternary(draw(sequence, round, 2), 0.0, 0.6),
                        ternary(draw(sequence, round, 3), 0.2, 0.2)};
       }}};
}

}  // namespace

class ConfidenceSequencesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A sequence that excludes the mean after any of its rounds counts as missed.
  void interval_lookedAtAfterEachRound_coversInAtLeast95Percent_data() {
    QTest::addColumn<int>("stakes");
    QTest::newRow("mixed") << static_cast<int>(MeanSequence::Stakes::Mixed);
    QTest::newRow("mostly full") << static_cast<int>(MeanSequence::Stakes::MostlyFull);
  }

  void interval_lookedAtAfterEachRound_coversInAtLeast95Percent() {
    QFETCH(const int, stakes);
    constexpr int kSequences = 600;
    constexpr int kRounds = 150;
    const double enough = -std::log(0.025);
    for (const Population& of : populations()) {
      int missed = 0;
      for (int sequence = 0; sequence < kSequences; ++sequence) {
        MeanSequence betting(of.range, {0.025, 0.025}, static_cast<MeanSequence::Stakes>(stakes));
        bool isMissed = false;
        for (int round = 0; round < kRounds && !isMissed; ++round) {
          betting.addRound(of.observe(sequence, round));
          isMissed = betting.logWealth(of.mean, true) >= enough ||
                     betting.logWealth(of.mean, false) >= enough;
        }
        missed += isMissed ? 1 : 0;
      }
      QVERIFY2(missed <= kSequences / 20, qPrintable(QStringLiteral("%1: %2 of %3")
                                                         .arg(QLatin1String(of.name))
                                                         .arg(missed)
                                                         .arg(kSequences)));
    }
  }

  /// Sums of the five stakes' wealths, by a calculator: Σ w (1 + θ 0.05 / 0.95)^n.
  void logWealth_ofZeros_isThatOfTheFormula() {
    MeanSequence betting({-1.0, 1.0}, {0.05, 0.05});
    betting.addRound(Numbers(40, 0.0));
    double wealth = 0.3 * std::pow(1.0 + 1.0 / 19.0, 40);
    wealth += 0.2 * std::pow(1.0 + 0.6 / 19.0, 40) + 0.2 * std::pow(1.0 + 0.36 / 19.0, 40);
    wealth += 0.2 * std::pow(1.0 + 0.2 / 19.0, 40) + 0.1 * std::pow(1.0 + 0.1 / 19.0, 40);
    VERIFY_NEAR(betting.logWealth(-0.05, true), std::log(wealth), 1e-12);
    VERIFY_NEAR(betting.logWealth(0.05, false), std::log(wealth), 1e-12);
    QVERIFY(betting.logWealth(0.0, true) <= 1e-12);  // fair bets on zeros gain nothing

    MeanSequence full({-1.0, 1.0}, {0.05, 0.05}, MeanSequence::Stakes::MostlyFull);
    full.addRound(Numbers(40, 0.0));
    wealth = 0.6 * std::pow(1.0 + 1.0 / 19.0, 40);
    wealth += 0.15 * std::pow(1.0 + 0.6 / 19.0, 40) + 0.1 * std::pow(1.0 + 0.36 / 19.0, 40);
    wealth += 0.1 * std::pow(1.0 + 0.2 / 19.0, 40) + 0.05 * std::pow(1.0 + 0.1 / 19.0, 40);
    VERIFY_NEAR(full.logWealth(-0.05, true), std::log(wealth), 1e-12);
    VERIFY_NEAR(full.logWealth(0.05, false), std::log(wealth), 1e-12);
  }

  void interval_ofMoreObservations_shrinksAroundTheMean() {
    MeanSequence betting({-1.0, 1.0}, {0.025, 0.025});
    Interval before = betting.interval();
    QCOMPARE(before.low, -1.0);
    QCOMPARE(before.high, 1.0);
    QVERIFY(std::isnan(betting.mean()));
    for (int round = 0; round < 3000; ++round) {
      betting.addRound({ternary(draw(1, round), 0.05, 0.15)});
      const Interval& now = betting.interval();
      QVERIFY(now.low >= before.low && now.high <= before.high);
      QVERIFY(now.low < -0.1 && now.high > -0.1);
      before = now;
    }
    QCOMPARE(betting.count(), 3000);
    QVERIFY(before.high - before.low < 0.09);  // the fixed interval for 3000: 0.031
    VERIFY_NEAR(betting.mean(), -0.1, 0.03);
  }

  void interval_mirroredObservations_isMirrored() {
    MeanSequence one({-1.0, 1.0}, {0.05, 0.01});
    MeanSequence other({-1.0, 1.0}, {0.01, 0.05});
    for (int round = 0; round < 60; ++round) {
      const double value = draw(2, round) - 0.2;
      one.addRound({value});
      other.addRound({-value});
    }
    VERIFY_NEAR(one.interval().low, -other.interval().high, 1e-12);
    VERIFY_NEAR(one.interval().high, -other.interval().low, 1e-12);
  }

  void values_outsideTheRange_countAsItsEnds() {
    MeanSequence given({-1.0, 1.0}, {0.05, 0.05});
    MeanSequence clipped({-1.0, 1.0}, {0.05, 0.05});
    given.addRound({7.0, -2.0, 0.5});
    clipped.addRound({1.0, -1.0, 0.5});
    QCOMPARE(given.interval().low, clipped.interval().low);
    QCOMPARE(given.mean(), clipped.mean());
  }
};

QTEST_APPLESS_MAIN(ConfidenceSequencesTest)
#include "tst_ConfidenceSequences.moc"
