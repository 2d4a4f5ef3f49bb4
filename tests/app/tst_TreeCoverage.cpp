#include <set>

#include <QtTest>

#include "tests/app/ReportFiles.h"
#include "tests/app/StudyFiles.h"

using namespace outside;
using outside::report;

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
      const QStringList owners = row.at(text("owners")).split(text(", "));
      RunsByStatus byStatus;
      std::set<int> runs;
      for (const QString& owner : owners) {
        const auto found = counts.find(owner + QLatin1Char(' ') + row.at(text("node")));
        for (const auto& [status, of] : found == counts.end() ? RunsByStatus() : found->second) {
          for (const int run : of) {
            // In the runs from 3 on, ben is scared and has a tree of his own.
            const bool isOfTree = owner != text("ben") || (owners.size() == 1) == (run >= 3);
            const bool isExecuted = status != text("IDLE") && status != text("SKIPPED");
            if (isOfTree) {
              byStatus[status].insert(run);
            }
            if (isOfTree && isExecuted) {
              runs.insert(run);
            }
          }
        }
      }
      const auto isAtLeast = [&](const char* column, const char* status) {
        return row.at(text(column)).toInt() >= static_cast<int>(byStatus[text(status)].size());
      };
      QVERIFY2(row.at(text("executed")).toInt() == static_cast<int>(runs.size()),
               qPrintable(row.at(text("owners")) + row.at(text("node"))));
      QVERIFY(isAtLeast("running", "RUNNING") && isAtLeast("success", "SUCCESS") &&
              isAtLeast("failure", "FAILURE"));  // recordings have the last status of a step only
      executed += runs.empty() ? 0 : 1;
      ++rows;
    }
    QVERIFY(rows > 5 && executed > 5);
  }

  /// The report lists the trees; trees draws the one of anna, and none that the batch does not
  /// have.
  void report_andPicture_showTheCoverage() {
    const QString out = folder_.path(text("shown"));
    const QString study = folder_.writeStudy("coverage.yaml", kCoverageStudy);
    QCOMPARE(failureOf(StudyFolder::words(study, out)), QString());
    QCOMPARE(failureOf({text("report"), out, text("--no-pdf")}), QString());
    const QByteArray page = bytesOf(out + text("/report.html"));
    QVERIFY(page.contains("id=\"trees\""));
    const auto rows = readCsv(out + text("/tables/tree_coverage.csv"));
    QCOMPARE(rows.size(), std::size_t{2});  // anna's, which ben has in half of the runs, and ben's
    QCOMPARE(rows[0].at(text("Trees of")), text("anna, ben"));
    QCOMPARE(rows[0].at(text("Runs")), text("6"));
    QCOMPARE(rows[1].at(text("Runs")), text("3"));
    const QString yard = folder_.path(text("yard.yaml"));
    const QString plain = folder_.path(text("plain.svg")), covered = folder_.path(text("tree.svg"));
    QCOMPARE(
        failureOf({text("trees"), yard, text("--agent"), text("anna"), text("--picture"), plain}),
        QString());
    QCOMPARE(failureOf({text("trees"), yard, text("--agent"), text("anna"), text("--picture"),
                        covered, text("--coverage"), out}),
             QString());
    QVERIFY(!bytesOf(covered).isEmpty() && bytesOf(covered) != bytesOf(plain));
    const QString other = folder_.path(text("other.xml"));
    writeText(other,
              "<root BTCPP_format=\"4\" main_tree_to_execute=\"A\"><BehaviorTree ID=\"A\">"
              "<AlwaysSuccess/></BehaviorTree></root>");
    QCOMPARE(unexpected(runProgram({text("trees"), other, text("--picture"), plain,
                                    text("--coverage"), out, text("--force")}),
                        2, "no run of the batch has this tree"),
             QString());
    writeText(out + text("/tree_coverage.csv"),
              bytesOf(out + text("/tree_coverage.csv")).replace(",0,", ",none,"));
    QCOMPARE(unexpected(report(out), 2, "not the coverage of trees"), QString());
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

  /// Also of a batch that keeps no run folders.
  void coverage_withoutRecords_isTheSame() {
    const QString study = folder_.writeStudy("coverage.yaml", kCoverageStudy);
    const QString kept = folder_.path(text("kept")), bare = folder_.path(text("bare"));
    QCOMPARE(failureOf(StudyFolder::words(study, kept)), QString());
    writeText(study, bytesOf(study).replace("record: all\n", ""));
    QCOMPARE(failureOf(StudyFolder::words(study, bare)), QString());
    const QByteArray csv = bytesOf(kept + text("/tree_coverage.csv"));
    QVERIFY(!csv.isEmpty());
    QCOMPARE(bytesOf(bare + text("/tree_coverage.csv")), csv);
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
