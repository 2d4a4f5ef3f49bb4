#include <cmath>

#include <QtTest>

#include "tests/app/ReportFiles.h"
#include "tests/app/StudyFiles.h"

using namespace outside;
using outside::report;

namespace {

/// A point of a design by hand: values in [0, 1] and the metric; NaN: undefined.
struct HandPoint {
  double u, v, path, time;
};

/// A batch folder with these points for two seeds; the second one adds 100 to the metrics.
void writeBatch(const QString& folder, const char* method, int points,
                const std::vector<HandPoint>& design) {
  QByteArray rows =
      "run,scenario,seed,robot1.a,robot1.b,status,reason,simulated,path_length,"
      "time_to_reach_goal,success\n";
  int run = 0;
  for (const HandPoint& point : design) {
    for (const int seed : {1, 2}) {
      const double offset = seed == 2 ? 100.0 : 0.0;
      const bool isUndefined = seed == 1 && std::isnan(point.time);
      const double time = std::isnan(point.time) ? 0.0 : point.time;
      rows += QByteArray::number(run++) + ",hall," + QByteArray::number(seed) + "," +
              QByteArray::number(2.0 * point.u) + "," + QByteArray::number(10.0 + 10.0 * point.v) +
              ",ok,,20," + QByteArray::number(point.path + offset) + "," +
              (isUndefined ? QByteArray() : QByteArray::number(time + offset)) + ",True\n";
    }
  }
  writeText(folder + text("/results.csv"), rows);
  writeText(folder + text("/manifest.json"),
            "{\"program\": {\"version\": \"1\", \"commit\": \"2\"}, \"inputs\": [], \"runs\": " +
                QByteArray::number(run) + ", \"design\": {\"method\": \"" + method +
                "\", \"points\": " + QByteArray::number(points) +
                ", \"seed\": 1, \"factors\": [{\"path\": \"robot1.a\", \"from\": 0, \"to\": 2}, "
                "{\"path\": \"robot1.b\", \"from\": 10, \"to\": 20}]}}");
}

/// y = 3 u + 6 u v at three trajectories: effects of u 3, 3, 9 and of v 6, 3, 0. The other metric
/// is -y.
std::vector<HandPoint> handTrajectories() {
  const std::vector<std::pair<double, double>> points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.5},
                                                         {0.5, 1.0}, {0.5, 0.0}, {0.0, 0.0},
                                                         {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.5}};
  std::vector<HandPoint> design;
  for (const auto& [u, v] : points) {
    const double y = 3.0 * u + 6.0 * u * v;
    design.push_back({u, v, y, design.empty() ? std::nan("") : -y});
  }
  return design;
}

std::map<QString, QString> rowOf(const QString& folder, const char* metric, const char* path) {
  for (const auto& row : readCsv(folder + text("/sensitivity.csv"))) {
    if (row.at(text("metric")) == text(metric) && row.at(text("path")) == text(path)) {
      return row;
    }
  }
  return {};
}

bool isNumber(const std::map<QString, QString>& row, const char* column, double wanted,
              double tolerance = 1e-12) {
  const auto found = row.find(text(column));
  return found != row.end() && !found->second.isEmpty() &&
         std::abs(found->second.toDouble() - wanted) <= tolerance;
}

constexpr char kSmallStudy[] =
    "seeds: 2\nduration: 4.0\nvalues:\n  robot1.max_vel: {between: [0.4, 1.2]}\n"
    "  \"*.max_vel\": {uniform: [0.8, 1.6]}\n";

}  // namespace

/// `hunavsim sensitivity` from outside.
class SensitivityProgramTest : public QObject {
  Q_OBJECT

 private:
  StudyFolder folder_;

  QStringList words(const QString& out, const QStringList& more) const {
    return QStringList{text("sensitivity"), folder_.path(text("small.yaml")), text("-o"), out,
                       text("--no-pdf")} +
           more;
  }
  static QByteArray filesOf(const QString& out) {
    QByteArray all;
    for (const char* name : {"/results.csv", "/manifest.json", "/sensitivity.json",
                             "/sensitivity.csv", "/report.html"}) {
      all += bytesOf(out + text(name));
    }
    return all;
  }

 private Q_SLOTS:
  void initTestCase() { folder_.writeStudy("small.yaml", kSmallStudy); }

  /// By hand: mu* 5 and 3, sigma sqrt(12) and 3; the order holds unless the resample lacks the
  /// third trajectory: 19 of 27, and half of 1 of 27 with equal sums.
  void morris_byHand_isAsCalculated() {
    const QTemporaryDir folder;
    writeBatch(folder.path(), "morris", 3, handTrajectories());
    const Finished done = report(folder.path(), {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const auto u = rowOf(folder.path(), "path_length", "robot1.a");
    const auto v = rowOf(folder.path(), "path_length", "robot1.b");
    QVERIFY(isNumber(u, "rank", 1) && isNumber(v, "rank", 2));
    QVERIFY(isNumber(u, "mu_star", 5.0) && isNumber(v, "mu_star", 3.0));
    QVERIFY(isNumber(u, "mu", 5.0) && isNumber(v, "mu", 3.0));
    QVERIFY(isNumber(u, "sigma", std::sqrt(12.0)) && isNumber(v, "sigma", 3.0));
    QVERIFY(isNumber(u, "effects", 3) && isNumber(v, "effects", 3));
    QVERIFY(isNumber(u, "order_share", 19.5 / 27.0, 0.05));
    // One seed has no value at one point; the effects there are those of the other seed.
    const auto time = rowOf(folder.path(), "time_to_reach_goal", "robot1.a");
    QVERIFY(isNumber(time, "mu_star", 5.0) && isNumber(time, "mu", -5.0));
    const QJsonObject json = readJson(folder.filePath(text("sensitivity.json")));
    QCOMPARE(json.value(text("method")).toString(), text("morris"));
    QCOMPARE(json.value(text("constant_metrics")).toArray(), QJsonArray{text("success")});
    const QJsonObject first = json.value(text("results")).toArray().first().toObject();
    QCOMPARE(first.value(text("seed_share")).toDouble(-1.0), 0.0);  // seeds only add a constant
    QCOMPARE(first.value(text("too_few_points")).toObject().value(text("unordered")).toArray(),
             QJsonArray{QJsonArray({text("robot1.a"), text("robot1.b")})});
  }

  /// The page is well-formed, draws both figures, and says what is not certain.
  void page_ofMorris_saysWhatIsUncertain() {
    const QTemporaryDir folder;
    writeBatch(folder.path(), "morris", 3, handTrajectories());
    QCOMPARE(report(folder.path(), {text("--no-pdf")}).exitCode, 0);
    const QByteArray page = bytesOf(folder.filePath(text("report.html")));
    const QString all = textsOf(page, "html").join(QString());
    QVERIFY2(!all.startsWith(QLatin1Char('!')), qPrintable(all));
    QVERIFY(all.contains(text("the order of a and b is not certain")));
    QVERIFY(all.contains(text("Do not vary in this study: Success")));
    QCOMPARE(textsOf(page, "svg").size(), 4);  // two figures per metric
    QVERIFY(QFile::exists(folder.filePath(text("figures/effects_path_length.svg"))));
    QVERIFY(QFile::exists(folder.filePath(text("figures/importance_path_length.svg"))));
  }

  /// y = u at the rows 0 and 1 of A, 1 and 0 of B: variance 1/4, both indices of u (1/2) / (1/4).
  void sobol_byHand_isAsCalculated() {
    const QTemporaryDir folder;
    std::vector<HandPoint> design;
    for (const double a : {0.0, 1.0}) {
      const double b = 1.0 - a;
      for (const auto& [u, v] : {std::pair{a, a}, {b, b}, {b, a}, {a, b}}) {
        design.push_back({u, v, u, v});
      }
    }
    writeBatch(folder.path(), "saltelli", 2, design);
    const Finished done = report(folder.path(), {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const auto u = rowOf(folder.path(), "path_length", "robot1.a");
    const auto v = rowOf(folder.path(), "path_length", "robot1.b");
    QVERIFY(isNumber(u, "first", 2.0) && isNumber(u, "total", 2.0));
    QVERIFY(isNumber(v, "first", 0.0) && isNumber(v, "total", 0.0));
    QCOMPARE(textsOf(bytesOf(folder.filePath(text("report.html"))), "svg").size(), 2);
  }

  void report_missingRuns_isAnError() {
    const QTemporaryDir folder;
    std::vector<HandPoint> design = handTrajectories();
    design.pop_back();
    writeBatch(folder.path(), "morris", 3, design);
    QCOMPARE(unexpected(report(folder.path()), 2, "8 runs instead of one at each of the 9 points"),
             QString());
    writeBatch(folder.path(), "grid", 3, design);
    QCOMPARE(unexpected(report(folder.path()), 2, "not the manifest of a batch"), QString());
  }

  void jobs_anyNumber_sameBytes() {
    const QString out = folder_.path(text("out"));
    const QStringList points{text("--points"), text("3"), text("--jobs")};
    QCOMPARE(failureOf(words(out, points + QStringList(text("1")))), QString());
    const QByteArray one = filesOf(out);
    QCOMPARE(readCsv(out + text("/results.csv")).size(), std::size_t{18});
    QCOMPARE(failureOf(words(out, points + QStringList(text("2")))), QString());
    QVERIFY(filesOf(out) == one);
    QCOMPARE(failureOf(words(out, points + QStringList{text("2"), text("--resume")})), QString());
    QVERIFY(filesOf(out) == one);
    // The values of both forms are those of the design.
    for (const auto& row : readCsv(out + text("/results.csv"))) {
      const double share = (row.at(text("robot1.max_vel")).toDouble() - 0.4) / 0.8;
      QVERIFY(std::abs(3.0 * share - std::round(3.0 * share)) < 1e-9);
      const double other = (row.at(text("*.max_vel")).toDouble() - 0.8) / 0.8;
      QVERIFY(std::abs(3.0 * other - std::round(3.0 * other)) < 1e-9);
    }
    QCOMPARE(unexpected(runProgram(words(out, {text("--points"), text("4"), text("--resume")})), 2,
                        "the batch has the design"),
             QString());
  }

  /// The same as a batch whose file has the design, in two shards.
  void shards_merged_sameResults() {
    folder_.writeStudy("design.yaml",
                       QByteArray(kSmallStudy) + "design: {method: saltelli, points: 2}\n");
    const QString study = folder_.path(text("design.yaml"));
    const auto run = [&](const QStringList& with) { return failureOf(with); };
    const QString whole = folder_.path(text("whole")), joined = folder_.path(text("joined"));
    QCOMPARE(run({text("sensitivity"), study, text("-o"), whole, text("--no-pdf")}), QString());
    QStringList merge{text("merge"), text("-o"), joined};
    for (const char* shard : {"1", "2"}) {
      const QString part = folder_.path(text("part") + text(shard));
      QCOMPARE(
          run({text("batch"), study, text("-o"), part, text("--shard"), text(shard) + text("/2")}),
          QString());
      merge.append(part);
    }
    QCOMPARE(run(merge), QString());
    QCOMPARE(run({text("report"), joined, text("--no-pdf")}), QString());
    for (const char* name : {"/results.csv", "/sensitivity.json", "/sensitivity.csv"}) {
      QCOMPARE(bytesOf(joined + text(name)), bytesOf(whole + text(name)));
    }
  }

  void killed_andResumed_sameBytes() {
    const QString out = folder_.path(text("killed"));
    const QStringList points{text("--points"), text("20"), text("--jobs"), text("2")};
    QCOMPARE(failureOf(words(out, points)), QString());
    const QByteArray undisturbed = filesOf(out);
    {
      Running analysis(words(out, points));
      QTRY_VERIFY_WITH_TIMEOUT(
          !analysis.isRunning() || QFileInfo(out + text("/results.sqlite-wal")).size() > 60000,
          30000);
    }
    QCOMPARE(failureOf(words(out, points + QStringList(text("--resume")))), QString());
    QVERIFY(filesOf(out) == undisturbed);
  }

  void json_isTheFile() {
    const QString out = folder_.path(text("json"));
    const Finished done = runProgram(words(out, {text("--points"), text("2"), text("--json"),
                                                 text("--metrics"), text("path_length")}));
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QCOMPARE(done.out.toUtf8(), bytesOf(out + text("/sensitivity.json")));
    QCOMPARE(readJson(out + text("/sensitivity.json")).value(text("results")).toArray().size(), 1);
  }

  void shippedStudy_isValid() {
    const QString study = text(SOURCE_DIR "/maps/library/people_sensitivity.yaml");
    const Finished done = runProgram({text("check"), study});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QVERIFY2(done.err.isEmpty(), qPrintable(done.err));
  }

  void wrongInput_isReported() {
    const QString out = folder_.path(text("wrong"));
    folder_.writeStudy("lists.yaml", "values:\n  robot1.max_vel: [0.4, 1.2]\n");
    QCOMPARE(unexpected(runProgram({text("sensitivity"), folder_.path(text("lists.yaml")),
                                    text("-o"), out}),
                        2, "needs values with a range"),
             QString());
    QCOMPARE(runProgram(words(out, {text("--method"), text("sobel")})).exitCode, 64);
    QCOMPARE(unexpected(runProgram(words(out, {text("--metrics"), text("path_length,sucess")})), 64,
                        "--metrics: error: unknown metric 'sucess' (did you mean 'success'?)"),
             QString());
    QCOMPARE(runProgram(words(out, {text("--points"), text("1")})).exitCode, 64);
    QVERIFY(!QFile::exists(out));
  }
};

QTEST_GUILESS_MAIN(SensitivityProgramTest)
#include "tst_SensitivityProgram.moc"
