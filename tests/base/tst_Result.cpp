#include <memory>
#include <string>

#include <QtTest>

#include "sim2d/base/Result.h"
#include "tests/support/Columns.h"

using base::Diagnostic;
using base::Diagnostics;
using base::Result;

class ResultTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void text_places_areLeftOutWhenUnknown_data() {
    addColumns<QByteArray, int, int, QByteArray>({"file", "line", "column", "text"});
    QTest::newRow("all") << QByteArray("cafe.yaml") << 12 << 7
                         << QByteArray("cafe.yaml:12:7: warning: odd");
    QTest::newRow("no column") << QByteArray("cafe.yaml") << 12 << 0
                               << QByteArray("cafe.yaml:12: warning: odd");
    QTest::newRow("no line") << QByteArray("cafe.yaml") << 0 << 7
                             << QByteArray("cafe.yaml: warning: odd");
    QTest::newRow("no file") << QByteArray() << 12 << 7 << QByteArray("12:7: warning: odd");
    QTest::newRow("nothing") << QByteArray() << 0 << 0 << QByteArray("warning: odd");
  }

  void text_places_areLeftOutWhenUnknown() {
    QFETCH(QByteArray, file);
    QFETCH(int, line);
    QFETCH(int, column);
    QFETCH(QByteArray, text);
    const Diagnostic warning =
        base::warning("run.failed", {"odd"}, file.toStdString(), line, column);
    QCOMPARE(QByteArray::fromStdString(warning.text()), text);
  }

  void severityName_eachSeverity_isNamed() {
    QCOMPARE(base::severityName(base::Severity::Info), "info");
    QCOMPARE(base::severityName(base::Severity::Warning), "warning");
    QCOMPARE(base::severityName(base::Severity::Error), "error");
  }

  void hasErrors_warningsOnly_isFalse() {
    Diagnostics list = {base::warning("run.failed", {"a"}), base::warning("run.failed", {"b"})};
    QVERIFY(!base::hasErrors(list));
    QVERIFY(!base::hasErrors({}));
    list.push_back(base::error("run.failed", {"c"}));
    QVERIFY(base::hasErrors(list));
  }

  void append_listToItself_doublesIt() {
    Diagnostics list = {base::warning("run.failed", {"a"}), base::error("run.failed", {"b"})};
    base::append(list, list);
    QCOMPARE(list.size(), std::size_t{4});
    QVERIFY(list[2].message == "a" && list[3].message == "b");
  }

  void result_value_carriesWarnings() {
    const Result<int> result(3, {base::warning("run.failed", {"odd"})});
    QVERIFY(static_cast<bool>(result));
    QCOMPARE(*result, 3);
    QCOMPARE(result.diagnostics().size(), std::size_t{1});
  }

  void result_error_hasNoValue() {
    const Result<int> one = base::error("run.failed", {"broken"}, "x.yaml", 2);
    QVERIFY(!one);
    QCOMPARE(QByteArray::fromStdString(one.diagnostics().front().text()),
             QByteArray("x.yaml:2: error: broken"));
    const Result<int> many =
        Diagnostics{base::warning("run.failed", {"a"}), base::error("run.failed", {"b"})};
    QVERIFY(!many);
    QCOMPARE(many.diagnostics().size(), std::size_t{2});
  }

  void result_moveOnlyValue_canBeTaken() {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
    const std::unique_ptr<int> taken = *std::move(result);
    QCOMPARE(*taken, 5);
  }

  void error_values_fillTheHolesInOrder() {
    const Diagnostic problem = base::error("scenario.id-twice", {3, "{id}"}, "x.yaml", 2);
    QCOMPARE(QByteArray::fromStdString(problem.text()),
             QByteArray("x.yaml:2: error: id 3 is also used by {id}"));
    QVERIFY(problem.code == "scenario.id-twice");
    QVERIFY(problem.value("id") == "3" && problem.value("other") == "{id}");
    QVERIFY(problem.value("goal").empty());
    const Diagnostic number = base::warning("person.vel-too-high", {2.5});
    QVERIFY(number.severity == base::Severity::Warning && number.value("found") == "2.5");
  }

  void error_hintWithoutValue_isLeftOut() {
    const auto said = [](const std::optional<std::string>& nearest) {
      return base::error("planner.unknown-parameter", {"pursuit", nearest}).message;
    };
    QVERIFY(said("lookahead") == "unknown parameter of 'pursuit' (did you mean 'lookahead'?)");
    QVERIFY(said(std::nullopt) == "unknown parameter of 'pursuit'");
    const auto word = [](const char* nearest) {
      return base::error("scenario.unknown-word", {"model", "sfn", nearest, "sfm, orca"}).message;
    };
    QVERIFY(word("sfm") == "model 'sfn' is unknown (did you mean 'sfm'? known: sfm, orca)");
    QVERIFY(word("") == "model 'sfn' is unknown (known: sfm, orca)");
  }

  void within_anyProblem_namesWhereItIs() {
    const Diagnostic problem =
        base::withContext("anna", base::warning("person.vel-too-high", {2.5}));
    QVERIFY(problem.message == "anna: vel 2.5 is above 1.8: HuNavSim's loader clamps it");
    QVERIFY(problem.value("where") == "anna" && problem.value("found") == "2.5");
    const Diagnostic moved = base::withNewContext("2 people", problem);
    QVERIFY(moved.message == "2 people: vel 2.5 is above 1.8: HuNavSim's loader clamps it");
    QVERIFY(moved.value("where") == "2 people" && moved.code == problem.code);
  }

  /// Only the placeholder: the name of the person is the same word.
  void withValue_ofAPlaceholder_isInTheMessage() {
    const Diagnostic problem = base::withContext(
        "model", base::error("scenario.unknown-word", {"model", "sfn", "sfm", "sfm, orca"}));
    const Diagnostic labelled = base::withValue("key", "Model (model)", problem);
    QVERIFY(labelled.message ==
            "model: Model (model) 'sfn' is unknown (did you mean 'sfm'? known: sfm, orca)");
    QVERIFY(labelled.value("key") == "Model (model)" && labelled.code == problem.code);
    QVERIFY(base::withValue("goal", "7", problem).message == problem.message);
  }
};

QTEST_APPLESS_MAIN(ResultTest)
#include "tst_Result.moc"
