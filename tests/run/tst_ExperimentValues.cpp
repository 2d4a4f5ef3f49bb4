#include <cmath>
#include <set>

#include <QtTest>

#include "app/run/Experiment.h"
#include "app/run/ExperimentValues.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

using app::ExperimentValue;

namespace {

/// What stands under the only key of this YAML.
base::Result<ExperimentValue> valueOf(const std::string& yaml) {
  base::Diagnostics problems;
  const base::YamlNode root = base::parseYaml(yaml, "e.yaml", problems);
  return app::readExperimentValue(root.items.front());
}

std::vector<double> drawn(const ExperimentValue& value, int count) {
  std::vector<double> numbers;
  for (int seed = 1; seed <= count; ++seed) {
    numbers.push_back(*base::parseDouble(app::drawnText(value, "yard.yaml", seed)));
  }
  return numbers;
}

double meanOf(const std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double number : numbers) {
    sum += number;
  }
  return sum / static_cast<double>(numbers.size());
}

double varianceOf(const std::vector<double>& numbers) {
  const double mean = meanOf(numbers);
  double sum = 0.0;
  for (const double number : numbers) {
    sum += (number - mean) * (number - mean);
  }
  return sum / static_cast<double>(numbers.size());
}

}  // namespace

/// How an experiment gives values.
class ExperimentValuesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void text_isReadAgain_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("text");
    for (const char* same : {"[pursuit, dwa]", "[0.5, 1.0]", "{normal: [1.2, 0.2, 0.6, 1.8]}",
                             "{uniform: [0.5, 1.5]}", "{choice: [a, [1, 2], {b: c}]}"}) {
      QTest::newRow(same) << QString::fromUtf8(same) << QString::fromUtf8(same);
    }
    QTest::newRow("range") << "{range: [0, 1, 0.5]}"
                           << "[0, 0.5, 1]";
    QTest::newRow("words") << "[\"a b, c\", 'x: y', \"\"]"
                           << "[\"a b, c\", \"x: y\", \"\"]";
  }
  void text_isReadAgain() {
    QFETCH(QString, yaml);
    QFETCH(QString, text);
    const auto value = valueOf("a: " + yaml.toStdString());
    QVERIFY(bool(value));
    const std::string written = app::experimentValueText(*value);
    QCOMPARE(QString::fromStdString(written), text);
    const auto again = valueOf("a: " + written);
    QVERIFY(again && again->kind == value->kind && again->texts == value->texts);
    QVERIFY(!value->isDrawn() || again->numbers == value->numbers);
  }

  void labels_ofMaps_areTheirValues_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("labels");
    const auto row = [](const char* yaml, const char* labels) {
      QTest::newRow(yaml) << QString::fromLatin1(yaml) << QString::fromLatin1(labels);
    };
    row("[pursuit, a/b.yaml]", "pursuit|a/b.yaml");
    row("[{planner: dwa}, {planner: nav2, nav2_params: ../x/rpp.yaml}]", "dwa|nav2 (rpp)");
    row("[{nav2_params: [x/rpp.yaml, y.yaml], max_vel: 0.8}]", "rpp + y (0.8)");
    row("[{start: {x: 1.0, h: 2.0}, mass: 4}]", "1.0, 2.0 (4)");
    row("[{planner: external, command: python3 my.py --dir /a/b}]",
        "external (python3 my.py --dir /a/b)");
    row("[{planner: external, command: /x/p/}, {planner: external, command: /x/go.sh}]",
        "external (/x/p/)|external (go)");
    row("[{planner: onnx, planner_parameters: {file: /tmp/rv/crossing_policy.onnx}}]",
        "onnx (crossing_policy)");
    row("[{planner: dwa, planner_parameters: {}}, {planner: ''}, {planner: library, v: 1.2.3}]",
        "dwa ({})|{planner: \"\"}|library (1.2.3)");
    row("[{nav2_params: [a/b.yaml, FollowPath.plugin:=nav2.Mppi], dt: 0.05}]",
        "b + FollowPath.plugin:=nav2.Mppi (0.05)");
    row("[{file: a/p.yaml}, {file: b/p.yaml}]", "{file: a/p.yaml}|{file: b/p.yaml}");
    row("[{planner: nav2, nav2_params: a.yaml, max_vel: 0.8}]", "nav2 (a, 0.8)");
    row("['{no map']", "{no map");
  }
  void labels_ofMaps_areTheirValues() {
    QFETCH(QString, yaml);
    QFETCH(QString, labels);
    const auto value = valueOf("a: " + yaml.toStdString());
    QVERIFY(bool(value));
    QCOMPARE(QString::fromStdString(base::join(app::optionLabels(value->texts), "|")), labels);
  }

  void planners_areOfAKeyOrOfMaps() {
    QVERIFY(app::arePlanners("robot1.planner", {"dwa", "orca"}));
    QVERIFY(app::arePlanners("robot1", {"{max_vel: 1.0}", "{planner: dwa, max_vel: 1.0}"}));
    QVERIFY(!app::arePlanners("robot1", {"{max_vel: 1.0}", "{planner_parameters: {}}"}));
    QVERIFY(!app::arePlanners("p01.max_vel", {"1.0", "planner"}));
  }

  void range_steps_areTidy_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("texts");
    QTest::newRow("tenths") << "a: {range: [0.1, 0.5, 0.1]}"
                            << "0.1 0.2 0.3 0.4 0.5";
    QTest::newRow("whole") << "a: {range: [1, 7, 3]}"
                           << "1 4 7";
    QTest::newRow("not to the end") << "a: {range: [0, 1, 0.3]}"
                                    << "0 0.3 0.6 0.9";
    QTest::newRow("one") << "a: {range: [2.5, 2.5, 1]}"
                         << "2.5";
    QTest::newRow("small") << "a: {range: [1e-7, 3e-7, 1e-7]}"
                           << "1e-07 2e-07 3e-07";
    QTest::newRow("large") << "a: {range: [0.5, 2000000000001, 1e12]}"
                           << "0.5 1000000000000.5 2000000000000.5";
    QTest::newRow("below 0") << "a: {range: [-0.3, 0.1, 0.2]}"
                             << "-0.3 -0.1 0.1";
    QTest::newRow("list") << "a: [x, 2, [3, 4], {b: c}]"
                          << "x 2 [3, 4] {b: c}";
  }
  void range_steps_areTidy() {
    QFETCH(QString, yaml);
    QFETCH(QString, texts);
    const base::Result<ExperimentValue> value = valueOf(yaml.toStdString());
    QVERIFY(bool(value));
    QVERIFY(!value->isDrawn());
    QCOMPARE(QString::fromStdString(base::join(value->texts, " ")), texts);
  }

  void wrongWays_areToldWithTheirPlaces_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("code");
    QTest::addColumn<int>("column");
    QTest::newRow("word") << "a: 3"
                          << "experiment.values-no-list" << 4;
    QTest::newRow("empty list") << "a: []"
                                << "experiment.values-no-list" << 4;
    QTest::newRow("two ways") << "a: {choice: [1], range: [1, 2, 1]}"
                              << "experiment.values-no-list" << 4;
    QTest::newRow("mistyped") << "a: {norml: [1, 2, 3, 4]}"
                              << "experiment.unknown-draw" << 5;
    QTest::newRow("range of two") << "a: {range: [1, 2]}"
                                  << "experiment.bad-range" << 12;
    QTest::newRow("range backwards") << "a: {range: [2, 1, 1]}"
                                     << "experiment.bad-range" << 12;
    QTest::newRow("no step") << "a: {range: [1, 2, 0]}"
                             << "experiment.bad-range" << 12;
    QTest::newRow("too many steps") << "a: {range: [0, 1, 1e-9]}"
                                    << "experiment.bad-range" << 12;
    QTest::newRow("no deviation") << "a: {normal: [1, 0, 0, 2]}"
                                  << "experiment.bad-normal" << 13;
    QTest::newRow("normal of two") << "a: {normal: [1, 2]}"
                                   << "experiment.bad-normal" << 13;
    QTest::newRow("no room") << "a: {normal: [1, 2, 3, 3]}"
                             << "experiment.bad-normal" << 13;
    QTest::newRow("infinite") << "a: {uniform: [0, .inf]}"
                              << "experiment.bad-uniform" << 14;
    QTest::newRow("word for a number") << "a: {uniform: [0, x]}"
                                       << "experiment.bad-uniform" << 14;
    QTest::newRow("uniform backwards") << "a: {uniform: [2, 1]}"
                                       << "experiment.bad-uniform" << 14;
    QTest::newRow("nothing to choose") << "a: {choice: []}"
                                       << "experiment.bad-choice" << 13;
  }
  void wrongWays_areToldWithTheirPlaces() {
    QFETCH(QString, yaml);
    QFETCH(QString, code);
    QFETCH(int, column);
    const base::Result<ExperimentValue> value = valueOf(yaml.toStdString());
    QVERIFY(!value);
    const base::Diagnostic& said = value.diagnostics().front();
    QCOMPARE(QString::fromUtf8(said.code.data(), static_cast<int>(said.code.size())), code);
    QCOMPARE(said.line, 1);
    QCOMPARE(said.column, column);
  }

  /// Refused before any value is tried, with the count and the limit.
  void tooManyRuns_areRefused_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<int>("line");
    QTest::newRow("seeds") << "seeds: 6000000000" << 3;
    QTest::newRow("more than fit in 64 bits") << "seeds: 99999999999999999999" << 3;
    QTest::newRow("seeds x values") << "seeds: 9000000\nvalues:\n  seed: [1, 2]" << 5;
    QTest::newRow("values x values")
        << "values:\n  seed: {range: [1, 900000, 1]}\n  duration: {range: [1, 900000, 1]}" << 5;
  }
  void tooManyRuns_areRefused() {
    QFETCH(QString, yaml);
    QFETCH(int, line);
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("e.yaml")).toStdString();
    const std::string text = "hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                             "/maps/planners/crossing_agents.yaml]\n" +
                             yaml.toStdString() + "\n";
    QVERIFY(base::writeFileAtomically(file, text).empty());
    const base::Result<app::Experiment> experiment = app::readExperiment(file);
    QVERIFY(!experiment);
    QCOMPARE(experiment.diagnostics().size(), std::size_t{1});
    const base::Diagnostic& said = experiment.diagnostics().front();
    QVERIFY2(said.text().find("seeds") != std::string::npos ||
                 said.text().find("the limit is 10000000") != std::string::npos,
             said.text().c_str());
    QCOMPARE(said.line, line);
  }

  /// The same runs again are no more evidence; they are made, and told.
  void listedTwice_isWarnedOf() {
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("e.yaml")).toStdString();
    const std::string text = "hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                             "/maps/planners/crossing_agents.yaml]\n"
                             "seeds: [3, 3, 5]\nvalues:\n  duration: [1.0, 2.0, 1.0]\n";
    QVERIFY(base::writeFileAtomically(file, text).empty());
    const base::Result<app::Experiment> experiment = app::readExperiment(file);
    QVERIFY(experiment);
    QCOMPARE(experiment->runCount(), std::size_t{9});
    std::vector<std::pair<int, int>> places;
    for (const base::Diagnostic& said : experiment.diagnostics()) {
      if (said.code == "experiment.twice") {
        QVERIFY(said.severity == base::Severity::Warning);
        places.emplace_back(said.line, said.column);
      }
    }
    const std::vector<std::pair<int, int>> wanted = {{3, 12}, {5, 24}};
    QCOMPARE(places, wanted);
  }

  /// Moments of the normal distribution between two ends (Johnson, Kotz & Balakrishnan 1994,
  /// 13.134 and 13.135), worked out by hand from tables of phi and Phi.
  void normal_moments_areThoseOfTheTruncatedOne_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<double>("mean");
    QTest::addColumn<double>("variance");
    QTest::newRow("three deviations") << "a: {normal: [1.2, 0.2, 0.6, 1.8]}" << 1.2 << 0.0389335;
    QTest::newRow("half") << "a: {normal: [0, 1, 0, 100]}" << 0.797885 << 0.363380;
    QTest::newRow("tail") << "a: {normal: [0, 1, 3, 8]}" << 3.283099 << 0.070553;
    QTest::newRow("narrow") << "a: {normal: [0, 1, 1, 1.1]}" << 1.049124 << 0.000832;
  }
  void normal_moments_areThoseOfTheTruncatedOne() {
    QFETCH(QString, yaml);
    QFETCH(double, mean);
    QFETCH(double, variance);
    const ExperimentValue value = *valueOf(yaml.toStdString());
    constexpr int kCount = 20000;
    const std::vector<double> numbers = drawn(value, kCount);
    for (const double number : numbers) {
      QVERIFY(number >= value.numbers[2] && number <= value.numbers[3]);
    }
    QVERIFY(std::abs(meanOf(numbers) - mean) < 4.0 * std::sqrt(variance / kCount));
    QVERIFY2(std::abs(varianceOf(numbers) / variance - 1.0) < 0.06,
             qPrintable(QString::number(varianceOf(numbers))));
  }

  void uniform_moments_areThoseOfTheInterval() {
    const std::vector<double> numbers = drawn(*valueOf("a: {uniform: [2, 5]}"), 20000);
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    QVERIFY(*least >= 2.0 && *least < 2.01 && *most < 5.0 && *most > 4.99);
    QVERIFY(std::abs(meanOf(numbers) - 3.5) < 4.0 * std::sqrt(0.75 / 20000.0));  // (5 - 2)^2 / 12
    QVERIFY(std::abs(varianceOf(numbers) - 0.75) < 0.03);
  }

  void choice_texts_areEquallyOften() {
    const ExperimentValue value = *valueOf("a: {choice: [Regular, Scared, Curious]}");
    std::map<std::string, int> counts;
    for (int seed = 0; seed < 3000; ++seed) {
      ++counts[app::drawnText(value, "yard.yaml", seed)];
    }
    QCOMPARE(counts.size(), std::size_t{3});
    for (const auto& [text, count] : counts) {
      QVERIFY(std::abs(count - 1000) < 4.0 * std::sqrt(3000.0 * 2.0 / 9.0));
    }
  }

  /// Of the name of the scenario's file, the seed and the path; of nothing else.
  void draws_dependOnScenarioSeedAndPathAlone() {
    const ExperimentValue value = *valueOf("a: {uniform: [0, 1]}");
    const std::string here = app::drawnText(value, "yard.yaml", 1);
    QCOMPARE(app::drawnText(value, "yard.yaml", 1), here);
    QCOMPARE(app::drawnText(value, "../maps/yard.yaml", 1), here);
    QCOMPARE(app::drawnText(value, "yard", 1), here);
    QVERIFY(app::drawnText(value, "yard2", 1) != here);
    QVERIFY(app::drawnText(value, "yard", 2) != here);
    QVERIFY(app::drawnText(*valueOf("b: {uniform: [0, 1]}"), "yard", 1) != here);
    std::set<std::string> all;
    for (int seed = 0; seed < 1000; ++seed) {
      all.insert(app::drawnText(value, "yard", seed));
    }
    QCOMPARE(all.size(), std::size_t{1000});
  }
};

QTEST_APPLESS_MAIN(ExperimentValuesTest)
#include "tst_ExperimentValues.moc"
