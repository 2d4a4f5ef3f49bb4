#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <QtTest>

#include "sim2d/base/Rng.h"

using base::AgentRng;
using base::DrawPurpose;

namespace {

constexpr int kDraws = 200000;

}  // namespace

class RngTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The three rows "philox4x32 10" of kat_vectors in Random123 1.14.
  void philox_publishedVectors_areReproduced() {
    using Words4 = std::array<std::uint32_t, 4>;
    constexpr std::uint32_t kOnes = 0xffffffffU;
    QVERIFY(base::philox4x32({0, 0, 0, 0}, {0, 0}) ==
            (Words4{0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U}));
    QVERIFY(base::philox4x32({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}) ==
            (Words4{0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU}));
    QVERIFY(base::philox4x32({0x243f6a88U, 0x85a308d3U, 0x13198a2eU, 0x03707344U},
                             {0xa4093822U, 0x299f31d0U}) ==
            (Words4{0xd16cfe09U, 0x94fdccebU, 0x5001e420U, 0x24126ea1U}));
  }

  void bits_anyPartOfTheAddress_changesTheDraw() {
    std::set<std::uint32_t> seen;
    seen.insert(AgentRng(1, 2, 3).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(2, 2, 3).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(1 + (1ULL << 32U), 2, 3).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(1, -2, 3).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(1, 2, 4).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(1, 2, 3 + (1ULL << 32U)).bits(DrawPurpose::Test, 4));
    seen.insert(AgentRng(1, 2, 3).bits(DrawPurpose::Sensor, 4));
    seen.insert(AgentRng(1, 2, 3).bits(DrawPurpose::Test, 5));
    QCOMPARE(seen.size(), std::size_t{8});
  }

  void bits_sameAddress_isTheSameDraw() {
    const AgentRng one(42, 7, 100);
    const AgentRng other(42, 7, 100);
    QVERIFY(one.uniform01(DrawPurpose::Parameter, 1) != one.uniform01(DrawPurpose::Parameter, 2));
    QVERIFY(one.normal(1.0, 2.0, DrawPurpose::Parameter, 1) ==
            other.normal(1.0, 2.0, DrawPurpose::Parameter, 1));
  }

  void uniform01_moments_areThoseOfTheUnitInterval() {
    const AgentRng rng(1, 1);
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
      const double u = rng.uniform01(DrawPurpose::Test, i);
      QVERIFY(u >= 0.0 && u < 1.0);
      sum += u;
      squares += (u - 0.5) * (u - 0.5);
    }
    QVERIFY(std::abs(sum / kDraws - 0.5) < 0.003);  // four deviations of the mean
    QVERIFY(std::abs(squares / kDraws - 1.0 / 12.0) < 0.001);
  }

  void uniform_narrowRange_neverReachesTheUpperEnd() {
    const double low = 1.0;
    const double high = std::nextafter(1.0, 2.0);
    for (int agent = 0; agent < 1000; ++agent) {
      QVERIFY(AgentRng(5, agent).uniform(low, high, DrawPurpose::Test) == low);
      const double value = AgentRng(5, agent).uniform(-3.0, 4.0, DrawPurpose::Test);
      QVERIFY(value >= -3.0 && value < 4.0);
    }
  }

  void uniform_emptyRange_isItsLowerEnd() {
    QVERIFY(AgentRng(5, 1).uniform(2.5, 2.5, DrawPurpose::Test) == 2.5);
  }

  void normal_moments_areThoseOfTheNormalDistribution() {
    double sum = 0.0;
    double squares = 0.0;
    double fourth = 0.0;
    int withinOne = 0;
    for (int i = 0; i < kDraws; ++i) {
      const double z = (AgentRng(9, i).normal(10.0, 2.0, DrawPurpose::Test) - 10.0) / 2.0;
      QVERIFY(std::isfinite(z));
      sum += z;
      squares += z * z;
      fourth += z * z * z * z;
      withinOne += std::abs(z) < 1.0 ? 1 : 0;
    }
    QVERIFY(std::abs(sum / kDraws) < 0.01);
    QVERIFY(std::abs(squares / kDraws - 1.0) < 0.015);
    QVERIFY(std::abs(fourth / kDraws - 3.0) < 0.1);
    QVERIFY(std::abs(withinOne / static_cast<double>(kDraws) - 0.682689) < 0.005);
  }

  void normalPair_moments_areThoseOfIndependentNormals() {
    double sums[5] = {};  // of both, their squares and their product
    for (int i = 0; i < kDraws; ++i) {
      const AgentRng rng(9, i);
      const std::array<double, 2> pair = rng.normalPair(DrawPurpose::Lidar, 3);
      QVERIFY(pair[0] == rng.normal(0.0, 1.0, DrawPurpose::Lidar, 3));
      sums[0] += pair[0];
      sums[1] += pair[1];
      sums[2] += pair[0] * pair[0];
      sums[3] += pair[1] * pair[1];
      sums[4] += pair[0] * pair[1];
    }
    const double expected[5] = {0.0, 0.0, 1.0, 1.0, 0.0};
    for (int i = 0; i < 5; ++i) {
      QVERIFY(std::abs(sums[i] / kDraws - expected[i]) < 0.015);
    }
  }

  void neighbouringAddresses_areUncorrelated() {
    double byAgent = 0.0;
    double byStep = 0.0;
    for (int i = 0; i < kDraws; ++i) {
      const double here = AgentRng(3, i, 50).uniform01(DrawPurpose::Test) - 0.5;
      byAgent += here * (AgentRng(3, i + 1, 50).uniform01(DrawPurpose::Test) - 0.5);
      byStep += here * (AgentRng(3, i, 51).uniform01(DrawPurpose::Test) - 0.5);
    }
    const double scale = 12.0 / kDraws;
    QVERIFY(std::abs(byAgent * scale) < 0.01);
    QVERIFY(std::abs(byStep * scale) < 0.01);
  }
};

QTEST_APPLESS_MAIN(RngTest)
#include "tst_Rng.moc"
