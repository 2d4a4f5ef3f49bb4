#include <cmath>
#include <set>

#include <QtTest>

#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/realism/RealismTest.h"
#include "tests/support/Columns.h"

using namespace sim2d;

namespace {

RealismRun withModel(const std::string& model) {
  RealismRun run;
  run.model = model;
  return run;
}

/// Among the numbers of a whole validation these are quick.
bool isQuick(const std::string& name) {
  return name == "circle" || name == "head-on" || name == "crossing" || name == "rimea-1" ||
         name == "corner" || name == "groups";
}

}  // namespace

class RealismTestTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void das_corridor_followsWeidmann_data() {
    QTest::addColumn<double>("density");
    QTest::addColumn<double>("expected");  // Weidmann's fit
    QTest::newRow("1 per m2") << 1.0 << 1.06;
    QTest::newRow("2 per m2") << 2.0 << 0.61;
  }

  void das_corridor_followsWeidmann() {
    QFETCH(double, density);
    QFETCH(double, expected);
    CorridorFlow setting;
    setting.density = density;
    setting.seconds = 24.0;
    const Flow flow = corridorFlow(withModel("das"), setting);
    QVERIFY2(std::fabs(flow.speed - expected) < 0.1, qPrintable(QString::number(flow.speed)));
    QVERIFY(flow.overlap <= 0.001);
  }

  void das_quickTests_pass_data() {
    QTest::addColumn<int>("index");
    const std::vector<RealismTest>& tests = realismTests();
    for (std::size_t i = 0; i < tests.size(); ++i) {
      if (isQuick(tests[i].name)) {
        QTest::newRow(tests[i].name.c_str()) << static_cast<int>(i);
      }
    }
  }

  void das_quickTests_pass() {
    QFETCH(int, index);
    const RealismTest& test = realismTests()[static_cast<std::size_t>(index)];
    const base::Result<std::vector<double>> values = test.measure(withModel("das"));
    QVERIFY(values);
    QCOMPARE(values->size(), test.quantities.size());
    for (std::size_t i = 0; i < values->size(); ++i) {
      QVERIFY2(test.quantities[i].passes((*values)[i]),
               (test.quantities[i].name + " " + std::to_string((*values)[i])).c_str());
    }
  }

  /// The weakness of the plain model that the fundamental diagram must show.
  void sfm_crowdedCorridor_isTooFast() {
    CorridorFlow setting;
    setting.density = 2.0;
    setting.seconds = 16.0;
    const Flow flow = corridorFlow(withModel("sfm"), setting);
    QVERIFY2(flow.speed > weidmannSpeed(2.0) + 0.15, qPrintable(QString::number(flow.speed)));
  }

  void orca_headOn_keepsApart() {
    const Meeting meeting = headOn(withModel("orca"));
    QVERIFY2(meeting.leastDistance >= 0.4 - 1e-3,
             qPrintable(QString::number(meeting.leastDistance)));
    QVERIFY2(meeting.timeRatio < 1.1, qPrintable(QString::number(meeting.timeRatio)));
  }

  void realismTests_all_haveDistinctNamesAndQuantities() {
    std::set<std::string> names;
    for (const RealismTest& test : realismTests()) {
      QVERIFY2(names.insert(test.name).second, test.name.c_str());
      QVERIFY(test.play != nullptr && !test.description.empty());
      std::set<std::string> quantities;
      for (const Quantity& quantity : test.quantities) {
        QVERIFY2(quantities.insert(quantity.name).second, quantity.name.c_str());
        QVERIFY2(quantity.least <= quantity.most, quantity.name.c_str());
        QVERIFY(std::isfinite(quantity.least) || std::isfinite(quantity.most));
      }
      QVERIFY(!quantities.empty());
    }
  }

  void measure_unknownModel_isAnError() {
    for (const RealismTest& test : realismTests()) {
      QVERIFY2(!test.measure(withModel("no such model")), test.name.c_str());
    }
  }

  void measure_whenStopped_isAnError() {
    RealismRun run = withModel("das");
    run.wantsStop = [] { return true; };
    for (const RealismTest& test : realismTests()) {
      QVERIFY2(!test.measure(run), test.name.c_str());
    }
  }

  void summaryOf_values_byKind() {
    Quantity quantity;
    const std::vector<double> values = {2.0, 4.0, 9.0};
    QCOMPARE(quantity.summaryOf(values), 5.0);
    quantity.summary = Summary::Smallest;
    QCOMPARE(quantity.summaryOf(values), 2.0);
    quantity.summary = Summary::Largest;
    QCOMPARE(quantity.summaryOf(values), 9.0);
    const double none = std::nan("");
    QVERIFY(std::isnan(quantity.summaryOf({})) && std::isnan(quantity.summaryOf({1.0, none})));
    QVERIFY(!quantity.passes(none));
  }

  void weidmannSpeed_published_data() {
    addColumns<double, double>({"density", "expected"});
    QTest::newRow("0.5") << 0.5 << 1.30;
    QTest::newRow("1.5") << 1.5 << 0.81;
    QTest::newRow("3") << 3.0 << 0.33;
    QTest::newRow("jam") << 5.4 << 0.0;
  }

  void weidmannSpeed_published() {
    QFETCH(double, density);
    QFETCH(double, expected);
    QVERIFY(std::fabs(weidmannSpeed(density) - expected) < 0.005);
  }

  void sampleSpeed_manyPeople_haveTheDistributionOfTheKind() {
    for (const PersonKind kind : {PersonKind::Adult, PersonKind::Child, PersonKind::Elderly,
                                  PersonKind::Wheelchair, PersonKind::Luggage}) {
      const KindProfile& profile = profileOf(kind);
      double sum = 0.0;
      for (int person = 0; person < 2000; ++person) {
        const double speed = sampleSpeed(kind, 7, person);
        QVERIFY(speed >= profile.slowest && speed <= profile.fastest);
        sum += speed;
      }
      QVERIFY(std::fabs(sum / 2000.0 - profile.meanSpeed) < 0.03);
      QCOMPARE(sampleSpeed(kind, 7, 3), sampleSpeed(kind, 7, 3));
      QVERIFY(sampleSpeed(kind, 7, 3) != sampleSpeed(kind, 8, 3));
      QCOMPARE(massOf(kind), profile.mass);
    }
  }
};

QTEST_APPLESS_MAIN(RealismTestTest)
#include "tst_Realism.moc"
