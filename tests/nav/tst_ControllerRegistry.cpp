#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

using namespace sim2d::nav2;

namespace {

struct Sample {
  double length = 1.5;
  int count = 3;
  bool isOn = true;
  std::string word = "a";
  std::vector<double> row = {1.0};
  std::vector<std::string> words;
};

const std::vector<Nav2Key<Sample>>& sampleKeys() {
  static const std::vector<Nav2Key<Sample>> kKeys = {
      {"length", &Sample::length, "m", "how long", kHumble},
      {"count", &Sample::count, "", "how many"},
      {"on", &Sample::isOn, "", "whether"},
      {"word", &Sample::word, "", "which"},
      {"row", &Sample::row, "", "numbers"},
      {"words", &Sample::words, "", "names"},
  };
  return kKeys;
}

}  // namespace

class ControllerRegistryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plugins_foundInBothSpellings() {
    for (const char* plugin :
         {"dwb_core::DWBLocalPlanner", "dwb_core/DWBLocalPlanner",
          "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController",
          "nav2_graceful_controller/GracefulController",
          "nav2_rotation_shim_controller::RotationShimController"}) {
      QVERIFY2(findController(plugin) != nullptr, plugin);
    }
    QVERIFY(findController("DWBLocalPlanner") == nullptr);
    QVERIFY(controllerPlugins().size() >= 4);
  }

  void unknown_tellsTheNearest() {
    const auto made = makeController("dwb_core::DWBPlanner", {});
    QVERIFY(!made);
    QCOMPARE(made.diagnostics()[0].code, std::string_view("nav2.unknown-plugin"));
    QCOMPARE(made.diagnostics()[0].value("nearest"), std::string("dwb_core::DWBLocalPlanner"));
  }

  void names_ofCodes() {
    QCOMPARE(controllerErrorName(ControllerError::NoValidControl), "NO_VALID_CONTROL");
    QCOMPARE(static_cast<int>(ControllerError::NoValidControl), 106);
    QCOMPARE(controllerErrorName(ControllerError::PatienceExceeded), "PATIENCE_EXCEEDED");
    QCOMPARE(static_cast<int>(ControllerError::PatienceExceeded), 104);
  }

  void filled_takesWhatIsGiven() {
    base::Diagnostics problems;
    const Nav2ParameterBlock block{{"length", 2.5}, {"x.on", false}, {"on", false}, {"x.count", 9}};
    const Sample one = applyBlock(Sample(), sampleKeys(), block, Distro::Humble, problems);
    QCOMPARE(one.length, 2.5);
    QCOMPARE(one.count, 3);
    QCOMPARE(one.isOn, false);
    const Sample below = applyBlock(Sample(), sampleKeys(), block, Distro::Humble, problems, "x.");
    QCOMPARE(below.length, 1.5);
    QCOMPARE(below.count, 9);
    const Sample jazzy = applyBlock(Sample(), sampleKeys(), block, Distro::Jazzy, problems);
    QCOMPARE(jazzy.length, 1.5);  // Jazzy has no such key
    QVERIFY(problems.empty());
  }

  void filled_otherTypes_areProblems() {
    base::Diagnostics problems;
    const Nav2ParameterBlock block{
        {"length", 2}, {"count", 2.0}, {"row", std::vector<std::string>{"a"}}};
    const Sample sample = applyBlock(Sample(), sampleKeys(), block, Distro::Humble, problems);
    QCOMPARE(sample.length, 1.5);
    QCOMPARE(problems.size(), std::size_t{3});
    QCOMPARE(problems[0].value("wanted"), std::string("double"));
    QCOMPARE(problems[0].value("found"), std::string("integer"));
    QCOMPARE(problems[2].value("found"), std::string("string_array"));
  }

  void addRows_prefixAndFallbacks() {
    Nav2KeyTable keys;
    addKeyRows(keys, sampleKeys(), Sample(), "critic.");
    QCOMPARE(keys.rows.size(), sampleKeys().size());
    const Nav2KeyTable::Row* row = keys.find("critic.length", Distro::Humble);
    QVERIFY(row != nullptr);
    QCOMPARE(std::get<double>(row->fallback), 1.5);
    QCOMPARE(row->unit, std::string("m"));
    QVERIFY(keys.find("critic.length", Distro::Main) == nullptr);
    QVERIFY(keys.find("length", Distro::Humble) == nullptr);
  }
};

QTEST_APPLESS_MAIN(ControllerRegistryTest)
#include "tst_ControllerRegistry.moc"
