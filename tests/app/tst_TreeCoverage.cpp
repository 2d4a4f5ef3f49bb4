#include <set>

#include <QtTest>

#include "tests/app/StudyFiles.h"

using namespace outside;

namespace {

/// Statuses of a node in the runs of a scenario.
using RunsByStatus = std::map<QString, std::set<int>>;

/// From trees.csv of the kept run folders, without the program's own count: (person, node) to runs
/// by status. People with equal trees are counted together, as their names are in `owners`.
std::map<QString, RunsByStatus> countedIn(const QString& out, const std::map<int, QString>& names) {
  std::map<QString, RunsByStatus> counts;
  for (const QString& run : StudyFolder::runFolders(out)) {
    for (const auto& row : readCsv(out + text("/runs/") + run + text("/trees.csv"))) {
      const QString owner = names.at(row.at(text("id")).toInt());
      counts[owner + QLatin1Char(' ') + row.at(text("node"))][row.at(text("status"))].insert(
          run.toInt());
    }
  }
  return counts;
}

constexpr char kCoverageStudy[] =
    "seeds: 3\nduration: 6.0\nrecord: all\ntree_coverage: true\nvalues:\n"
    "  ben.behavior.type: [Regular, Scared]\n";

}  // namespace

/// The coverage of behaviour trees over a batch.
class TreeCoverageTest : public QObject {
  Q_OBJECT

 private:
  StudyFolder folder_;

 private Q_SLOTS:
  /// Executed: a node whose status in some step was another one than IDLE and SKIPPED.
  void coverage_equalsTheCountInTheRecordings() {
    const QString out = folder_.path(text("out"));
    const QString study = folder_.writeStudy("coverage.yaml", kCoverageStudy);
    QCOMPARE(failureOf(StudyFolder::words(study, out, {text("--jobs"), text("2")})), QString());
    const auto counts = countedIn(out, {{1, text("anna")}, {2, text("ben")}});
    int executed = 0, rows = 0;
    for (const auto& row : readCsv(out + text("/tree_coverage.csv"))) {
      std::set<int> runs;
      std::map<QString, std::set<int>> byStatus;
      for (const QString& owner : row.at(text("owners")).split(text(", "))) {
        const auto found = counts.find(owner + QLatin1Char(' ') + row.at(text("node")));
        for (const auto& [status, of] : found == counts.end() ? RunsByStatus() : found->second) {
          byStatus[status].insert(of.begin(), of.end());
          if (status != text("IDLE") && status != text("SKIPPED")) {
            runs.insert(of.begin(), of.end());
          }
        }
      }
      ++rows;
      // Trees of two kinds share node names, so that the count can contain runs of the other one.
      const int count = row.at(text("executed")).toInt();
      QVERIFY(count <= row.at(text("runs")).toInt());
      QVERIFY2(count <= static_cast<int>(runs.size()), qPrintable(row.at(text("node"))));
      if (row.at(text("owners")).contains(text("anna"))) {
        QVERIFY2(count == static_cast<int>(runs.size()), qPrintable(row.at(text("node"))));
        QVERIFY(row.at(text("running")).toInt() >=
                static_cast<int>(byStatus[text("RUNNING")].size()));
        QVERIFY(row.at(text("success")).toInt() >=
                static_cast<int>(byStatus[text("SUCCESS")].size()));
        QVERIFY(row.at(text("failure")).toInt() >=
                static_cast<int>(byStatus[text("FAILURE")].size()));
      }
      executed += count > 0 ? 1 : 0;
    }
    QVERIFY(rows > 5 && executed > 5);
  }

  void coverage_ofShards_isThatOfTheBatch() {
    const QString study = folder_.writeStudy("coverage.yaml", kCoverageStudy);
    const QString whole = folder_.path(text("whole")), joined = folder_.path(text("joined"));
    QCOMPARE(failureOf(StudyFolder::words(study, whole, {text("--jobs"), text("1")})), QString());
    QStringList merge{text("merge"), text("-o"), joined};
    for (const char* shard : {"1", "2"}) {
      const QString part = folder_.path(text("part") + text(shard));
      QCOMPARE(
          failureOf(StudyFolder::words(study, part, {text("--shard"), text(shard) + text("/2")})),
          QString());
      merge.append(part);
    }
    QCOMPARE(failureOf(merge), QString());
    const QByteArray csv = bytesOf(whole + text("/tree_coverage.csv"));
    QVERIFY(!csv.isEmpty());
    QCOMPARE(bytesOf(joined + text("/tree_coverage.csv")), csv);
  }

  void withoutTheKey_thereIsNoFile() {
    const QString out = folder_.path(text("none"));
    const QString study = folder_.writeStudy("none.yaml", "seeds: 1\nduration: 1.0\n");
    QCOMPARE(failureOf(StudyFolder::words(study, out)), QString());
    QVERIFY(!QFile::exists(out + text("/tree_coverage.csv")));
  }

  void wrongKey_isAnError() {
    const QString study = folder_.writeStudy("wrong.yaml", "tree_coverage: yes\n");
    QCOMPARE(unexpected(runProgram({text("check"), study}), 2, "must be true or false"), QString());
  }
};

QTEST_GUILESS_MAIN(TreeCoverageTest)
#include "tst_TreeCoverage.moc"
