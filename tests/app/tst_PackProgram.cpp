#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/StudyFiles.h"

using outside::failureOf;
using outside::runProgram;
using outside::text;

/// `hunavsim pack` from outside; its archives are read by unzip and sha256sum.
class PackProgramTest : public QObject {
  Q_OBJECT

 private:
  outside::StudyFolder folder_;

  QString path(const char* name) const { return folder_.path(text(name)); }
  outside::Finished pack(const QString& study, const char* file, const QStringList& more = {}) {
    return runProgram(QStringList{text("pack"), study, text("-o"), path(file)} + more);
  }
  /// Output of a command of the system in the folder; with its errors if it fails.
  QString shell(const QString& command) const {
    QProcess process;
    process.setWorkingDirectory(path(""));
    process.start(text("sh"), {text("-c"), command});
    const outside::Finished finished = outside::finishedOf(process);
    return finished.exitCode == 0 ? finished.out : finished.out + finished.err;
  }
  QStringList namesIn(const char* file) const {
    return shell(text("unzip -Z1 ") + text(file)).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  }

 private Q_SLOTS:
  void initTestCase() {
    outside::writeText(path("study.yaml"),
                       "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 2\nduration: 2.0\n"
                       "record: all\nvalues:\n  robot1.planner: [pursuit, dwa]\n");
    QCOMPARE(failureOf("batch % -o % -q", {path("study.yaml"), path("results")}), QString());
    QCOMPARE(failureOf("run corner_cafe_agents --duration 1 -o % -q", {path("run")}), QString());
  }

  void batch_packed_isAnArchiveOfOtherTools() {
    if (shell(text("command -v unzip")).isEmpty()) {
      QSKIP("no unzip");
    }
    QCOMPARE(pack(path("results"), "study.hnv").exitCode, 0);
    const QStringList names = namesIn("study.hnv");
    for (const char* name :
         {"README.txt", "SHA256SUMS", "manifest.json", "methods.html", "references.bib",
          "inputs/files/study.yaml", "inputs/files/yard.yaml", "study/results.csv",
          "study/results.sqlite", "study/manifest.json", "study/runs/3/trajectory.csv"}) {
      QVERIFY2(names.contains(text(name)), name);
    }
    QCOMPARE(names.first(), text("mimetype"));
    QCOMPARE(shell(text("unzip -p study.hnv study/results.csv | cmp - results/results.csv")),
             QString());
    QCOMPARE(shell(text("rm -rf un; unzip -q study.hnv -d un && cd un && sha256sum -c --quiet "
                        "SHA256SUMS && grep -c . SHA256SUMS"))
                 .trimmed(),
             QString::number(names.size() - 1));
    const QString methods = shell(text("unzip -p study.hnv methods.html"));
    QVERIFY(methods.contains(text("Wilcoxon")) && methods.contains(text("yard.yaml")));
    QVERIFY(shell(text("unzip -p study.hnv references.bib")).contains(text("2507.17317")));
  }

  void sameStudy_packedTwice_equalBytes() {
    QCOMPARE(pack(path("results"), "a.hnv").exitCode, 0);
    const QByteArray first = outside::bytesOf(path("a.hnv"));
    QCOMPARE(pack(path("results"), "a.hnv").exitCode, 0);
    QCOMPARE(outside::bytesOf(path("a.hnv")), first);
    outside::writeText(path("a.hnv"), "not a capsule");
    QCOMPARE(pack(path("results"), "a.hnv").exitCode, 2);
    QCOMPARE(pack(path("results"), "a.hnv", {text("--force")}).exitCode, 0);
    QCOMPARE(outside::bytesOf(path("a.hnv")), first);
  }

  void shippedScenario_isPackedWithItsMap() {
    QCOMPARE(pack(path("run"), "run.hnv").exitCode, 0);
    const QStringList names = namesIn("run.hnv");
    QVERIFY(names.contains(text("inputs/shared/maps/corner_cafe/corner_cafe_agents.yaml")));
    QVERIFY(names.contains(text("inputs/shared/maps/corner_cafe/corner_cafe.pgm")));
    QVERIFY(names.contains(text("study/trajectory.csv")));
  }

  /// A capsule is published: so it must not name folders of a user. Searched in all files,
  /// results.sqlite too, after `report` has written commands that repeat runs.
  void packed_containsNoPathsOfTheMachine() {
    if (shell(text("command -v unzip")).isEmpty()) {
      QSKIP("no unzip");
    }
    QCOMPARE(failureOf("batch % -o % -q", {path("study.yaml"), path("reported")}), QString());
    QCOMPARE(failureOf("report % --no-pdf -q", {path("reported")}), QString());
    QVERIFY(outside::bytesOf(path("reported/report.html")).contains(path("study.yaml").toUtf8()));
    const std::pair<const char*, QString> packed[] = {
        {"reported", path("")}, {"run", text(SOURCE_DIR)}, {"run", path("")}};
    for (const auto& [study, secret] : packed) {
      QCOMPARE(pack(path(study), "secret.hnv", {text("--force")}).exitCode, 0);
      QCOMPARE(shell(text("rm -rf secret; unzip -q secret.hnv -d secret; grep -rlaF '%1' secret")
                         .arg(QDir::cleanPath(secret))),
               QString());
      QCOMPARE(failureOf("verify % --sample 100%", {path("secret.hnv")}), QString());
    }
  }

  void folders_thatAreNoStudies_areErrors() {
    QCOMPARE(outside::unexpected(pack(path("absent"), "x.hnv"), 2, "is not the folder of a batch"),
             QString());
    outside::writeText(path("own/notes.txt"), "mine");
    QCOMPARE(outside::unexpected(pack(path("own"), "x.hnv"), 2, "is not the folder of a batch"),
             QString());
    QVERIFY(!QFile::exists(path("x.hnv")) && !QFile::exists(path("x.hnv.unchecked")));
  }

  void fileOfTheStudy_changed_isAnError() {
    QCOMPARE(failureOf("run % --duration 1 -o % -q", {path("yard.yaml"), path("changed")}),
             QString());
    outside::writeText(path("changed/steps.csv"), "other");
    QCOMPARE(outside::unexpected(pack(path("changed"), "x.hnv"), 2,
                                 "steps.csv: error: this file has changed"),
             QString());
  }

  void input_changed_isAnError() {
    outside::writeText(path("mine.yaml"), outside::kYardText);
    QCOMPARE(failureOf("run % --duration 1 -o % -q", {path("mine.yaml"), path("old")}), QString());
    outside::writeText(path("mine.yaml"), QByteArray(outside::kYardText) + "\n# later\n");
    QCOMPARE(outside::unexpected(pack(path("old"), "x.hnv"), 2,
                                 "mine.yaml: error: this input of the study is missing"),
             QString());
  }

  void continuedRun_isAnError() {
    QCOMPARE(failureOf("run --from % --seed 5 -q -o %", {path("run@0.5"), path("branch")}),
             QString());
    QCOMPARE(outside::unexpected(pack(path("branch"), "x.hnv"), 2, "continues another run"),
             QString());
  }

  /// Its copy would read the file of this machine.
  void absolutePath_inTheExperiment_isAnError() {
    QDir().mkpath(path("elsewhere"));
    outside::writeText(path("elsewhere/yard.yaml"), outside::kYardText);
    outside::writeText(path("absolute.yaml"), "hunavsim_experiment: 1\nscenarios: [" +
                                                  path("elsewhere/yard.yaml").toUtf8() +
                                                  "]\nseeds: 1\nduration: 1.0\n");
    QCOMPARE(failureOf("batch % -o % -q", {path("absolute.yaml"), path("absolute")}), QString());
    QCOMPARE(outside::unexpected(pack(path("absolute"), "x.hnv"), 2,
                                 "would be read from outside the capsule"),
             QString());
    QVERIFY(!QFile::exists(path("x.hnv")));
  }
};

QTEST_GUILESS_MAIN(PackProgramTest)
#include "tst_PackProgram.moc"
