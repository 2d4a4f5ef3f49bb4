#include <cmath>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/ReportFiles.h"
#include "tests/app/StudyFiles.h"

using namespace outside;
using outside::report;

namespace {

/// A folder with the results written by hand.
struct ResultsFolder : QTemporaryDir {
  ResultsFolder() {
    for (const char* name : {"/results.csv", "/manifest.json"}) {
      writeText(path() + text(name), bytesOf(text(TEST_DATA_DIR "/app/report") + text(name)));
    }
  }
};

/// The row of a table of our own that has these fields at its beginning.
QStringList rowOf(const QString& path, const QStringList& first) {
  for (const QByteArray& line : bytesOf(path).split('\n')) {
    QStringList fields;
    bool isQuoted = false;
    QString field;
    for (const QChar c : QString::fromUtf8(line)) {
      isQuoted = c == QLatin1Char('"') ? !isQuoted : isQuoted;
      if (c == QLatin1Char(',') && !isQuoted) {
        fields.append(field);
        field.clear();
      } else if (c != QLatin1Char('"')) {
        field += c;
      }
    }
    fields.append(field);
    if (fields.mid(0, first.size()) == first) {
      return fields;
    }
  }
  return {};
}

std::map<QString, QByteArray> filesIn(const QString& folder) {
  std::map<QString, QByteArray> files;
  QDirIterator each(folder, QDir::Files, QDirIterator::Subdirectories);
  while (each.hasNext()) {
    const QString path = each.next();
    files[path.mid(folder.size())] = bytesOf(path);
  }
  return files;
}

}  // namespace

/// `hunavsim report` from outside. Numbers of results.csv in data/app/report worked out by hand.
class ReportProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Its own files are replaced, those of others and what somebody changed are not.
  void report_again_replacesItsOwnFilesOnly() {
    const ResultsFolder folder;
    const QString own = folder.filePath(text("own.txt"));
    writeText(own, "mine");
    QCOMPARE(report(folder.path(), {text("--no-pdf")}).exitCode, 0);
    const Finished again = report(folder.path(), {text("--no-pdf")});
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    const QString table = folder.filePath(text("tables/results.csv"));
    writeText(table, "edited");
    QCOMPARE(unexpected(report(folder.path(), {text("--no-pdf")}), 2, "tables/results.csv"),
             QString());
    QCOMPARE(bytesOf(table), QByteArray("edited"));
    QCOMPARE(report(folder.path(), {text("--no-pdf"), text("--force")}).exitCode, 0);
    QVERIFY(bytesOf(table) != QByteArray("edited"));
    QCOMPARE(bytesOf(own), QByteArray("mine"));
  }
  void report_handMade_numbersAreThoseByHand() {
    const ResultsFolder folder;
    const Finished done = report(folder.path());
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QString table = folder.filePath(text("tables/results.csv"));
    // Times 10 … 24: mean 102 / 6; of the other 86 / 5. Success 5 of 6, once because a run failed:
    // Wilson (13.8415 ± 1.95996 √7.1748) / 19.683 = 0.4365, 0.9699.
    const QStringList alpha = rowOf(table, {text("alpha"), text("6")});
    const QStringList beta = rowOf(table, {text("b<&eta"), text("6")});
    QVERIFY2(alpha.size() == 10 && beta.size() == 10, qPrintable(alpha.join(text("|"))));
    QCOMPARE(alpha[2], text("83 %"));
    QCOMPARE(alpha[3], text("[44, 97]"));
    QCOMPARE(beta[2], text("83 %"));
    QCOMPARE(alpha[4], text("17.0"));  // the intervals are some seconds wide
    QCOMPARE(beta[4], text("17.2"));
    const QStringList all = rowOf(folder.filePath(text("tables/all_metrics.csv")),
                                  {text("b<&eta"), text("all"), text("time_to_reach_goal")});
    QCOMPARE(all.value(4), text("5"));
    QCOMPARE(all.value(5).toDouble(), 17.2);
    QCOMPARE(beta[6], text("n = 5"));
    QCOMPARE(alpha[6], QString());
    QCOMPARE(alpha[7].toDouble(), 5.0);
    // Medians 17 and 15.
    const QString medians = folder.filePath(text("tables/medians.csv"));
    QCOMPARE(rowOf(medians, {text("alpha")}).value(1).toDouble(), 17.0);
    QCOMPARE(rowOf(medians, {text("b<&eta")}).value(1).toDouble(), 15.0);
    // Differences −1, −3, 1 in the hall (weight 1 / 4) and −1, −4 at the door (1 / 3): ranks 1.5,
    // 3, 1.5 and 1, 2, times 3 and 4; four of 32 sums are at most 4.5, p = 2 4 / 32. Means of pairs
    // −4, −3, −2.5, −2 have 14 of the weight of 30, up to −1 it is 24. Delta (−3 − 2) / (9 + 6).
    const QStringList pair =
        rowOf(folder.filePath(text("tables/pairs.csv")),
              {text("Time to reach the goal [s]"), text("alpha - b<&eta"), text("5")});
    QVERIFY(pair.size() > 8);
    QCOMPARE(pair[3], text("1 / 0 / 4"));
    QCOMPARE(pair[4].toDouble(), -1.0);
    QCOMPARE(pair[6].toDouble(), 0.25);
    // Holm over the three tests of the table: path 1 / 16, time 1 / 4, success 1.
    QCOMPARE(pair[7].toDouble(), 2.0 * 0.25);
    QCOMPARE(pair[8], text("-0.33"));
    // Five pairs reach at least p = 2 / 2^5 > 5 %: nothing can be detected. Two cases: the seeds
    // are half of the pairs that are enough.
    QVERIFY(pair.size() > 11);
    QCOMPARE(pair[10], text("%1 seeds").arg(std::ceil(pair[9].toDouble() / 2.0)));
    QCOMPARE(pair[11], QString());
    // At the door alone: two differences of one sign, p = 2 / 4.
    const QStringList door = rowOf(
        folder.filePath(text("tables/pairs_by_case.csv")),
        {text("Time to reach the goal [s]"), text("alpha - b<&eta"), text("door"), text("2")});
    QVERIFY(door.size() > 7);
    QCOMPARE(door[4], text("0 / 0 / 2"));
    QCOMPARE(door[5].toDouble(), -2.5);
    QCOMPARE(door[7].toDouble(), 0.5);
  }

  void report_page_isWellFormedAndHasTheRows() {
    const ResultsFolder folder;
    QCOMPARE(report(folder.path()).exitCode, 0);
    const QByteArray page = bytesOf(folder.filePath(text("report.html")));
    const QStringList cells = textsOf(page, "td");
    QVERIFY2(cells.size() > 20, qPrintable(cells.join(text("|"))));
    for (const char* wanted : {"alpha", "b<&\"eta", "gave up, <sad>", "not successful", "door"}) {
      QVERIFY2(cells.contains(text(wanted)), wanted);
    }
    QVERIFY(!cells
                 .filter(text("hunavsim /nowhere/door.yaml --seed 3 --set "
                              "'robot1.planner=b<&\"eta'"))
                 .isEmpty());
    QCOMPARE(textsOf(page, "h1"), QStringList(text("Planners compared")));
    const QStringList captions = textsOf(page, "caption");
    for (int k = 0; k < captions.size(); ++k) {
      QVERIFY2(captions[k].startsWith(text("Table %1. ").arg(k + 1)), qPrintable(captions[k]));
    }
    const QStringList lead = textsOf(page, "p").filter(text("Table 1: means and rates"));
    QVERIFY2(lead.size() == 1 && lead[0].contains(text("Table 3: paired tests; ")),
             qPrintable(lead.join(text("|"))));
    for (const char* outer : {"http://", "https://", "src=", "@import", "url("}) {  // no network
      QByteArray rest = page;
      rest.replace("http://www.w3.org/", "");
      rest.replace("url(#", "");
      QVERIFY2(!rest.contains(outer), outer);
    }
    for (const char* fact : {"0123456789ab", "hunavsim batch /nowhere/e.yaml", "1 to 3"}) {
      QVERIFY2(page.contains(fact), fact);
    }
    for (const auto& [name, bytes] : filesIn(folder.filePath(text("figures")))) {
      if (name.endsWith(text(".svg"))) {
        const QStringList words = textsOf(bytes, "text");
        QVERIFY2(!words.isEmpty() && !words[0].startsWith(QLatin1Char('!')), qPrintable(name));
        QVERIFY2(!bytes.contains("class="), qPrintable(name));  // a file has no style sheet
      } else {
        QVERIFY2(bytes.startsWith("%PDF-"), qPrintable(name));
      }
    }
    const QByteArray latex = bytesOf(folder.filePath(text("tables/results.tex")));
    QVERIFY(latex.contains("b$<$\\&\"eta & 6 & 83 \\%"));
    QVERIFY(latex.contains("\\toprule"));
  }

  void report_equalBest_areNamedTogether() {
    const ResultsFolder folder;
    const QString results = folder.filePath(text("results.csv"));
    QByteArray rows = bytesOf(results);
    for (const QByteArray& row : rows.split('\n')) {
      if (row.contains(",alpha,")) {
        rows += '2' + QByteArray(row).replace(",alpha,", ",gamma,") + '\n';  // run 20, 21 …
      }
    }
    writeText(results, rows);
    const Finished done = report(folder.path());
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QStringList findings = textsOf(bytesOf(folder.filePath(text("report.html"))), "li");
    QVERIFY2(!findings.filter(text("Path length: best are alpha, gamma (5")).isEmpty(),
             qPrintable(findings.join(text("|"))));
  }

  /// The folder of all scenarios tells none of them from the others.
  void report_scenariosOfOneFolder_areNamedWithoutIt() {
    const ResultsFolder folder;
    const QString results = folder.filePath(text("results.csv"));
    QByteArray rows = bytesOf(results);
    rows.replace(",hall,", ",/home/somebody/studies/one/hall,");
    rows.replace(",door,", ",/home/somebody/studies/one/more/door,");
    writeText(results, rows);
    QCOMPARE(report(folder.path(), {text("--no-pdf")}).exitCode, 0);
    const QString figure =
        QString::fromUtf8(bytesOf(folder.filePath(text("figures/difficulty.svg"))));
    QVERIFY2(figure.contains(text(">hall<")) && figure.contains(text(">more/door<")),
             qPrintable(figure));
  }

  void report_twice_givesEqualBytes() {
    const ResultsFolder folder;
    QCOMPARE(report(folder.path()).exitCode, 0);
    const auto first = filesIn(folder.path());
    QTest::qWait(1100);  // a date with seconds would be another one
    QCOMPARE(report(folder.path()).exitCode, 0);
    QVERIFY(first.size() > 12);
    for (const auto& [name, bytes] : filesIn(folder.path())) {
      QVERIFY2(bytes == first.at(name), qPrintable(name));
    }
  }

  void report_words_chooseWhatIsShown() {
    const ResultsFolder folder;
    const Finished done =
        report(folder.path(), {text("--metrics"), text("own_metric,path_length"), text("--compare"),
                               text("scenario"), text("--weights"), text("path_length=1")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    // Own numbers 1, 2, 3 per hall run and 4, 5, 6: the failed one is missing. Of path_length hall
    // has 33 / 6, door 29 / 5: the shorter is the better.
    const QString table = folder.filePath(text("tables/results.csv"));
    const QStringList hall = rowOf(table, {text("hall"), text("6")});
    const QStringList door = rowOf(table, {text("door"), text("6")});
    QVERIFY2(hall.size() == 9, qPrintable(hall.join(text("|"))));
    QCOMPARE(hall[2].toDouble(), 2.0);
    QVERIFY(std::abs(door[2].toDouble() - 24.0 / 5.0) < 0.006);
    QCOMPARE(hall[8], text("1.00"));
    QCOMPARE(door[8], text("0.00"));
    const QByteArray page = bytesOf(folder.filePath(text("report.html")));
    QCOMPARE(textsOf(page, "h1"), QStringList(text("Scenarios compared")));
    QVERIFY(textsOf(page, "td").contains(text("own_metric")));
  }

  void report_badInput_isTold_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("told");
    const QByteArray head = "run,scenario,seed,status,reason,simulated,path_length\n";
    const auto row = [](const char* name, const char* file, const QByteArray& content,
                        const QStringList& words, int exitCode, const char* told) {
      QTest::newRow(name) << text(file) << content << words << exitCode << text(told);
    };
    row("no results", "results.csv", {}, {}, 2, "results.csv: error: ");
    row("columns", "results.csv", "a,b\n1,2\n", {}, 2,
        "results.csv:1:1: error: the first line must be run,scenario,seed");
    row("width", "results.csv", head + "0,hall,1,ok,,5,1\n1,hall,2,ok,,5\n", {}, 2,
        "results.csv:3:1: error: the line has 6 fields instead of 7");
    row("no number", "results.csv", head + "0,hall,1,ok,,5,fast\n", {}, 2,
        "results.csv:2:16: error: path_length is not a finite number: 'fast'");
    row("status", "results.csv", head + "0,hall,1,good,,5,1\n", {}, 2,
        "results.csv:2:10: error: status must be ok or failed, not 'good'");
    row("twice", "results.csv", head + "0,hall,1,ok,,5,1\n0,hall,2,ok,,5,1\n", {}, 2,
        "results.csv:3:1: error: run 0 is duplicated");
    row("no runs", "results.csv", head, {}, 2, "results.csv: error: the results contain no runs");
    row("cut", "results.csv", head + "0,hall,1,ok,,5,1", {}, 2,
        "results.csv:2:16: error: the file ends inside this line (truncated?)");
    row("manifest", "manifest.json", "{\"runs\": 12", {}, 2,
        "manifest.json: error: not the manifest of a batch (damaged?)");
    row("metric", "", {}, {text("--metrics"), text("path_lenght")}, 2,
        "error: unknown metric 'path_lenght' (did you mean 'path_length'?)");
    row("path", "", {}, {text("--compare"), text("robot1.model")}, 2,
        "error: 'robot1.model' is not varied in this batch (known: robot1.planner, scenario)");
    row("weights", "", {}, {text("--weights"), text("path_length=much")}, 64, "--weights takes");
    row("weight of nothing better", "", {}, {text("--weights"), text("own_metric=1")}, 2,
        "--weights: error: 'own_metric' cannot have a weight");
    row("weight of nothing", "", {}, {text("--weights"), text("path=1")}, 2,
        "--weights: error: unknown metric 'path'");
    row("pareto", "", {}, {text("--pareto"), text("path_length")}, 64, "--pareto takes two");
  }
  void report_badInput_isTold() {
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, told);
    const ResultsFolder folder;
    if (!file.isEmpty()) {
      QFile::remove(folder.filePath(file));
      if (!content.isEmpty()) {
        writeText(folder.filePath(file), content);
      }
    }
    const Finished done = report(folder.path(), words);
    QVERIFY2(done.exitCode == exitCode, qPrintable(done.err));
    QVERIFY2(done.err.contains(told), qPrintable(done.err));
    QVERIFY(!QFile::exists(folder.filePath(text("report.html"))));
  }

  void report_ofAFile_isOneProblem() {
    const ResultsFolder folder;
    const Finished done = report(folder.filePath(text("results.csv")), {});
    QCOMPARE(done.exitCode, 2);
    QVERIFY2(done.err.endsWith(text("results.csv: error: this is a file: give the folder that "
                                    "hunavsim batch wrote\n")) &&
                 done.err.count(QLatin1Char('\n')) == 1,
             qPrintable(done.err));
  }

  /// A arrives only where it is easy and is slower there; C is quick because it gives up.
  void report_findings_sayWhatThePairsSay() {
    const ResultsFolder folder;
    QByteArray rows =
        "run,scenario,seed,robot1.planner,status,reason,simulated,success,time_to_reach_goal\n";
    int run = 0;
    for (int seed = 1; seed <= 12; ++seed) {
      const bool isEasy = seed <= 10;
      const auto add = [&](const char* planner, bool success, double time) {
        rows += QByteArray::number(run++) + ",hall," + QByteArray::number(seed) + "," + planner +
                ",ok,,20," + (success ? "True" : "False") + "," +
                (time > 0.0 ? QByteArray::number(time) : QByteArray()) + "\n";
      };
      add("A", isEasy, isEasy ? 10.0 + 0.1 * seed : 0.0);
      add("B", true, isEasy ? 9.0 + 0.2 * seed - 0.1 * (seed % 2) : 60.0);
      add("C", false, 1.0 + 0.01 * seed);
    }
    writeText(folder.filePath(text("results.csv")), rows);
    const Finished done = report(folder.path(), {text("--no-pdf"), text("--force")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QString findings =
        textsOf(bytesOf(folder.filePath(text("report.html"))), "li").join(text("|"));
    QVERIFY2(findings.contains(text("best is A (10.55 s), but B is better on the same cases and "
                                    "seeds; C never succeeds and is excluded.")),
             qPrintable(findings));
    const Finished weighed =
        report(folder.path(), {text("--no-pdf"), text("--weights"), text("time_to_reach_goal=1"),
                               text("--pareto"), text("time_to_reach_goal,success")});
    QVERIFY2(weighed.exitCode == 0, qPrintable(weighed.err));
    const QString table = folder.filePath(text("tables/results.csv"));
    QCOMPARE(rowOf(table, {text("A")}).last().toDouble(), 1.0);
    QCOMPARE(rowOf(table, {text("C")}).last(), QString());
    QVERIFY(bytesOf(folder.filePath(text("report.html")))
                .contains("Options that never succeed are excluded from it."));
    QVERIFY2(findings.contains(text("Success: best is B (100 %), better than C; not significantly "
                                    "different from A.")),
             qPrintable(findings));
  }

  /// Who reads the page can make the batch again, and sees that it is a part.
  void report_ofAShard_saysSo() {
    const ResultsFolder folder;
    const QString file = folder.filePath(text("manifest.json"));
    QJsonObject manifest = readJson(file);
    manifest[text("shard")] = text("1/3");
    manifest[text("code")] = QJsonObject{{text("allowed"), true}};
    writeText(file, QJsonDocument(manifest).toJson());
    QCOMPARE(report(folder.path(), {text("--no-pdf")}).exitCode, 0);
    const QByteArray page = bytesOf(folder.filePath(text("report.html")));
    QVERIFY(page.contains("This report contains only the runs of shard 1/3 of the study"));
    QVERIFY(page.contains(" --allow-code --shard 1/3\n"));
  }

  /// What is drawn for each seed is no option and makes no case: planners meet in pairs.
  void report_drawnValues_belongToTheSeed() {
    const StudyFolder yard;
    const QString study =
        yard.writeStudy("drawn.yaml",
                        "seeds: 3\nduration: 2.0\nvalues:\n  robot1.planner: [pursuit, dwa]\n"
                        "  \"*.max_vel\": {uniform: [0.8, 1.4]}\n");
    const QString out = yard.path(text("out"));
    QCOMPARE(failureOf("batch % -o %", {study, out}), QString());
    const Finished done = report(out, {text("--no-pdf"), text("--metrics"), text("path_length")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QVERIFY(!rowOf(out + text("/tables/results.csv"), {text("dwa"), text("3")}).isEmpty());
    QVERIFY(!rowOf(out + text("/tables/pairs.csv"),
                   {text("Path length [m]"), text("pursuit - dwa"), text("3")})
                 .isEmpty());
    const auto all = readCsv(out + text("/tables/all_metrics.csv"));
    QVERIFY(!all.empty());
    for (const auto& row : all) {
      QCOMPARE(row.at(text("case")), text("all"));
    }
    const QByteArray page = bytesOf(out + text("/report.html"));
    QVERIFY(page.contains("Drawn per scenario and seed"));
    QCOMPARE(unexpected(report(out, {text("--compare"), text("*.max_vel")}), 2,
                        "is sampled again for each seed"),
             QString());
  }

  /// Figures and tables of another choice of metrics would be taken for those of this page.
  void report_again_leavesNoFigureOfBefore() {
    const ResultsFolder folder;
    QCOMPARE(report(folder.path()).exitCode, 0);
    QVERIFY(QFile::exists(folder.filePath(text("figures/intervals.pdf"))));
    QVERIFY(QFile::exists(folder.filePath(text("figures/distributions.svg"))));
    writeText(folder.filePath(text("figures/own.svg")), "mine");
    QCOMPARE(report(folder.path(), {text("--no-pdf"), text("--metrics"), text("success")}).exitCode,
             0);
    const QStringList figures = QDir(folder.filePath(text("figures"))).entryList(QDir::Files);
    QVERIFY2(figures.filter(text(".pdf")).isEmpty(), qPrintable(figures.join(text(" "))));
    QVERIFY(figures.contains(text("success.svg")) && !figures.contains(text("intervals.svg")));
    QVERIFY(figures.contains(text("own.svg")));
  }

  /// Runs that are the same for every seed are one run: `batch` and `report` say so.
  void report_seedsAlike_areWarnedOf() {
    const StudyFolder folder;
    writeText(folder.path(text("yard.yaml")),
              QByteArray(kYardText).replace("configuration: 2", "configuration: 0"));
    const QString out = folder.path(text("out"));
    const auto batchOf = [&](const QByteArray& more) {
      const QString study =
          folder.writeStudy("alike.yaml", "seeds: 3\nduration: 4.0\nvalues:\n" + more);
      return runProgram(StudyFolder::words(study, out, {text("--force")}));
    };
    const QByteArray planners = "  robot1.planner: [pursuit, straight]\n";
    const char* const warning =
        "results.csv: warning: all seeds gave the same results, within 0.1 %, in 2 combinations of "
        "scenario and values, the first is ";
    const Finished alike = batchOf(planners);
    QVERIFY2(alike.exitCode == 0 && alike.err.contains(text(warning)), qPrintable(alike.err));
    QVERIFY2(alike.err.contains(text("'yard.yaml, robot1.planner=pursuit'")),
             qPrintable(alike.err));
    const Finished shown = report(out, {text("--no-pdf")});
    QVERIFY2(shown.exitCode == 0 && shown.err.contains(text(warning)), qPrintable(shown.err));
    const QStringList notes = textsOf(bytesOf(out + text("/report.html")), "p");
    QVERIFY2(notes.filter(text("all seeds gave the same values, within 0.1 %")).size() == 1,
             qPrintable(notes.join(text("|"))));
    const Finished varied = batchOf(planners + "  \"*.max_vel\": {uniform: [0.8, 1.6]}\n");
    QVERIFY2(!varied.err.contains(text("all seeds gave")), qPrintable(varied.err));
  }

  /// The results are those of the earlier content.
  void report_inputChangedAfterTheRuns_isWarnedOf() {
    const StudyFolder folder;
    const QString out = folder.path(text("out"));
    const QString study = folder.writeStudy("study.yaml", "seeds: 2\nduration: 3.0\n");
    QCOMPARE(failureOf(StudyFolder::words(study, out)), QString());
    const Finished before = report(out, {text("--no-pdf")});
    QVERIFY2(before.exitCode == 0 && !before.err.contains(text("was changed after the runs")),
             qPrintable(before.err));
    writeText(folder.path(text("yard.yaml")), QByteArray(kYardText).replace("1.2", "1.3"));
    QCOMPARE(unexpected(report(out, {text("--no-pdf")}), 0,
                        "yard.yaml: warning: this file was changed after the runs"),
             QString());
    const QStringList notes = textsOf(bytesOf(out + text("/report.html")), "p");
    QVERIFY2(notes.filter(text("Changed after the runs: ")).size() == 1,
             qPrintable(notes.join(text("|"))));
    QFile::remove(folder.path(text("yard.yaml")));  // the folder of a colleague
    const Finished elsewhere = report(out, {text("--no-pdf")});
    QVERIFY2(!elsewhere.err.contains(text("was changed after")), qPrintable(elsewhere.err));
  }

  /// Who reads the page has not seen what `check` says of its scenarios.
  void report_warningsOfTheInputs_areListedWithTheirNumber() {
    const StudyFolder folder;
    const QString out = folder.path(text("out"));
    writeText(folder.path(text("yard.yaml")),
              QByteArray(kYardText).replace("goal_radius: 0.3", "goal_radius: 40.0"));
    const Finished checked = runProgram({text("check"), folder.path(text("yard.yaml"))});
    QCOMPARE(checked.err.count(text("goal_radius 40 is implausible")), 2);
    const QString study = folder.writeStudy("study.yaml", "seeds: 1\nduration: 3.0\n");
    QCOMPARE(failureOf(StudyFolder::words(study, out)), QString());
    const Finished done = report(out, {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QByteArray page = bytesOf(out + text("/report.html"));
    const QStringList items = textsOf(page, "li").filter(text("is implausible"));
    QVERIFY2(items.size() == 1 && items.front().endsWith(text("(and 1 of the same kind)")),
             qPrintable(items.join(text("|"))));
    QVERIFY(!textsOf(page, "p").filter(text("The inputs of this study have ")).isEmpty());
  }

  void report_missingManifest_isAWarning() {
    const ResultsFolder folder;
    QVERIFY(QFile::remove(folder.filePath(text("manifest.json"))));
    QCOMPARE(unexpected(report(folder.path()), 0, "manifest.json: warning: the file is missing"),
             QString());
  }
};

QTEST_MAIN(ReportProgramTest)
#include "tst_ReportProgram.moc"
