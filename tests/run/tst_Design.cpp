#include <algorithm>

#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Design.h"
#include "app/run/Experiment.h"
#include "sim2d/base/Text.h"

using app::Design;
using app::designPoints;

namespace {

base::Result<app::Experiment> experimentOf(const std::string& values) {
  return app::parseExperiment(
      "hunavsim_experiment: 1\nscenarios: [crossing_agents]\nseeds: 2\n" + values, "e.yaml");
}

std::string firstProblem(const base::Result<app::Experiment>& experiment) {
  return experiment.diagnostics().empty() ? std::string()
                                          : std::string(experiment.diagnostics().front().code);
}

}  // namespace

/// Designs of experiments.
class DesignTest : public QObject {
  Q_OBJECT

  /// The path of an experiment with this text after its first keys.
  std::string fileWith(const QString& yaml) const {
    QFile file(folder_.filePath(QStringLiteral("e.yaml")));
    if (!file.open(QIODevice::WriteOnly)) {
      return {};
    }
    file.write("hunavsim_experiment: 1\nscenarios: [crossing_agents]\nseeds: 2\n" + yaml.toUtf8());
    return file.fileName().toStdString();
  }
  QTemporaryDir folder_;

 private Q_SLOTS:
  void sobol_isThePublishedSequence() {
    // The first points of new-joe-kuo-6.21201 in three dimensions, without the origin (S. Joe and
    // F. Y. Kuo, https://web.maths.unsw.edu.au/~fkuo/sobol).
    const std::vector<std::vector<double>> published = {
        {0.5, 0.5, 0.5},       {0.75, 0.25, 0.25},       {0.25, 0.75, 0.75},
        {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125},    {0.625, 0.125, 0.875},
        {0.125, 0.625, 0.375}, {0.1875, 0.3125, 0.9375}, {0.6875, 0.8125, 0.4375}};
    QVERIFY(designPoints({Design::Method::Sobol, 9, 1}, 3) == published);
  }

  void latinHypercube_hasOnePointPerInterval_data() {
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 7, 64}) {
      QTest::addRow("%d", count) << count;
    }
  }
  void latinHypercube_hasOnePointPerInterval() {
    QFETCH(int, count);
    const auto points =
        designPoints({Design::Method::LatinHypercube, static_cast<std::size_t>(count), 5}, 4);
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      std::vector<int> cells;
      for (const auto& point : points) {
        cells.push_back(static_cast<int>(point[dimension] * count));
      }
      std::sort(cells.begin(), cells.end());
      for (int cell = 0; cell < count; ++cell) {
        QCOMPARE(cells[static_cast<std::size_t>(cell)], cell);
      }
    }
  }

  void latinHypercube_coordinatesAreNotOrderedAlike() {
    const auto points = designPoints({Design::Method::LatinHypercube, 200, 1}, 2);
    double covariance = 0.0;
    for (const auto& point : points) {
      covariance += (point[0] - 0.5) * (point[1] - 0.5) / 200.0;
    }
    // Independent orders: the correlation has the standard deviation 1 / sqrt(200).
    QVERIFY(std::abs(12.0 * covariance) < 4.0 / std::sqrt(200.0));
  }

  void random_dependsOnTheSeedAndHasPrefixes() {
    const auto some = designPoints({Design::Method::Random, 10, 1}, 3);
    const auto more = designPoints({Design::Method::Random, 20, 1}, 3);
    QVERIFY(std::equal(some.begin(), some.end(), more.begin()));
    QVERIFY(some != designPoints({Design::Method::Random, 10, 2}, 3));
  }

  void random_isUniform() {
    const auto points = designPoints({Design::Method::Random, 4000, 1}, 1);
    double sum = 0.0, squares = 0.0;
    for (const auto& point : points) {
      QVERIFY(point[0] >= 0.0 && point[0] < 1.0);
      sum += point[0] / 4000.0;
      squares += point[0] * point[0] / 4000.0;
    }
    // Mean 1/2 and variance 1/12; the standard deviation of the mean is 0.0046.
    QVERIFY(std::abs(sum - 0.5) < 0.02);
    QVERIFY(std::abs(squares - sum * sum - 1.0 / 12.0) < 0.005);
  }

  void experiment_combinesPointsWithLists() {
    const auto experiment = experimentOf(
        "design: {method: sobol, points: 3}\n"
        "values:\n  robot1.planner: [pursuit, dwa]\n  robot1.max_vel: {between: [0.4, 1.2]}\n"
        "  robot1.mass: {between: [40.0, 60.0]}\n");
    QVERIFY(experiment);
    QCOMPARE(experiment->runCount(), std::size_t{2 * 3 * 2});
    // Seeds innermost, then the points, then the planner. Second point of Sobol: (0.75, 0.25).
    const app::Experiment::Run third = experiment->run(2);
    QCOMPARE(third.seed, 1LL);
    QCOMPARE(third.values.front(), std::string("pursuit"));
    QVERIFY(std::abs(*base::parseDouble(third.values[1]) - 1.0) < 1e-12);
    QCOMPARE(*base::parseDouble(third.values[2]), 45.0);
    const app::Experiment::Run last = experiment->run(11);
    QCOMPARE(last.seed, 2LL);
    QCOMPARE(last.values.front(), std::string("dwa"));
    QVERIFY(std::abs(*base::parseDouble(last.values[1]) - 0.6) < 1e-12);
    QVERIFY(std::abs(*base::parseDouble(last.values[2]) - 55.0) < 1e-12);
  }

  /// Of `sobol`, a uniform value is drawn per seed; for sensitivity analysis it is a coordinate.
  void sensitivityDesign_takesUniformValuesToo() {
    const std::string values =
        "values:\n  robot1.max_vel: {between: [0.4, 1.2]}\n"
        "  robot1.mass: {uniform: [40.0, 60.0]}\n";
    const auto other = experimentOf("design: {method: sobol, points: 4}\n" + values);
    QVERIFY(other && other->values[1].isDrawn());
    QCOMPARE(other->runCount(), std::size_t{2 * 4});
    const auto morris = experimentOf("design: {method: morris, points: 4}\n" + values);
    QVERIFY(morris && !morris->values[1].isDrawn());
    QCOMPARE(morris->runCount(), std::size_t{2 * 4 * 3});
    const auto saltelli = experimentOf("design: {method: saltelli, points: 4}\n" + values);
    QVERIFY(saltelli);
    QCOMPARE(saltelli->runCount(), std::size_t{2 * 4 * 4});
    const double mass = *base::parseDouble(morris->run(0).values[1]);
    const auto first = designPoints({Design::Method::Morris, 4, 1}, 2)[0];
    QVERIFY(std::abs(mass - (40.0 + 20.0 * first[1])) < 1e-12);
  }

  void sensitivityRequest_changesTheDesignOfTheFile_data() {
    QTest::addColumn<QString>("design");
    QTest::addColumn<int>("method");  // -1: not given
    QTest::addColumn<int>("points");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* design, int method, int points, const char* found) {
      QTest::addRow("%s %d %d", design, method, points) << design << method << points << found;
    };
    constexpr int kMorris = static_cast<int>(Design::Method::Morris);
    constexpr int kSaltelli = static_cast<int>(Design::Method::Saltelli);
    row("", -1, -1, "morris 20 1");
    row("", -1, 7, "morris 7 1");
    row("", kSaltelli, -1, "saltelli 64 1");
    row("design: {method: saltelli, points: 9, seed: 3}\n", -1, -1, "saltelli 9 3");
    row("design: {method: saltelli, points: 9, seed: 3}\n", -1, 5, "saltelli 5 3");
    row("design: {method: saltelli, points: 9, seed: 3}\n", kMorris, -1, "morris 20 3");
    row("design: {method: random, points: 9}\n", -1, -1, "morris 20 1");
  }
  void sensitivityRequest_changesTheDesignOfTheFile() {
    QFETCH(QString, design);
    QFETCH(int, method);
    QFETCH(int, points);
    QFETCH(QString, found);
    app::SensitivityRequest request;
    request.method = method < 0 ? std::nullopt : std::optional(static_cast<Design::Method>(method));
    request.points = points < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(points));
    const auto experiment = app::readSensitivityExperiment(
        fileWith(design + QStringLiteral("values:\n  robot1.max_vel: {between: [0.4, 1.2]}\n")),
        request);
    QVERIFY(experiment && experiment->design);
    QCOMPARE(experiment->design->methodName() + (" " + std::to_string(experiment->design->points)) +
                 " " + std::to_string(experiment->design->seed),
             found.toStdString());
    QCOMPARE(experiment->runCount(), 2 * experiment->design->pointCount(1));
  }

  void sensitivityRequest_withoutRanges_isAnError_data() {
    QTest::addColumn<QString>("yaml");
    QTest::newRow("no values") << QString();
    QTest::newRow("lists only") << QStringLiteral("values:\n  robot1.max_vel: [0.4, 1.2]\n");
  }
  void sensitivityRequest_withoutRanges_isAnError() {
    QFETCH(QString, yaml);
    const auto experiment = app::readSensitivityExperiment(fileWith(yaml), {});
    QVERIFY(!experiment);
    QCOMPARE(firstProblem(experiment), std::string("experiment.no-factors"));
  }

  void experiment_reportsWhatDoesNotFit_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("code");
    const QString value = QStringLiteral("values:\n  robot1.max_vel: {between: [0.4, 1.2]}\n");
    const auto row = [&](const char* design, const char* code) {
      QTest::newRow(code) << QString::fromUtf8(design) + value << QString::fromUtf8(code);
    };
    row("", "experiment.no-design");
    row("design: 5\n", "experiment.bad-design");
    row("design: {method: grid, points: 5}\n", "experiment.unknown-name");
    row("design: {method: sobol, points: 0}\n", "experiment.bad-points");
    row("design: {method: random, points: 5, seed: -1}\n", "experiment.bad-seed");
    row("design: {method: random, points: 5, sed: 1}\n", "experiment.unknown-key");
    QTest::newRow("too many points")
        << QStringLiteral("design: {method: morris, points: 500001}\n") + value
        << QStringLiteral("experiment.bad-points");
    QTest::newRow("unused") << QStringLiteral(
                                   "design: {method: sobol, points: 5}\n"
                                   "values:\n  robot1.max_vel: [1.0]\n")
                            << QStringLiteral("experiment.design-unused");
    QTest::newRow("reversed") << QStringLiteral(
                                     "design: {method: sobol, points: 5}\n"
                                     "values:\n  robot1.max_vel: {between: [2, 1]}\n")
                              << QStringLiteral("experiment.bad-between");
  }
  void experiment_reportsWhatDoesNotFit() {
    QFETCH(QString, yaml);
    QFETCH(QString, code);
    const auto experiment = experimentOf(yaml.toStdString());
    QVERIFY(!experiment);
    QCOMPARE(firstProblem(experiment), code.toStdString());
    QVERIFY(experiment.diagnostics().front().line > 0);
  }
};

QTEST_APPLESS_MAIN(DesignTest)
#include "tst_Design.moc"
