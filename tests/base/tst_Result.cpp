#include <memory>
#include <set>
#include <string>

#include <QtTest>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Result.h"

using base::Diagnostic;
using base::Diagnostics;
using base::Result;

class ResultTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void text_places_areLeftOutWhenUnknown_data();
  void text_places_areLeftOutWhenUnknown();
  void severityName_eachSeverity_isNamed();
  void hasErrors_warningsOnly_isFalse();
  void append_listToItself_doublesIt();
  void result_value_carriesWarnings();
  void result_error_hasNoValue();
  void result_moveOnlyValue_canBeTaken();
  void error_values_fillTheHolesInOrder();
  void error_hintWithoutValue_isLeftOut();
  void problemTexts_ids_areUniqueAndInAreas();
};

void ResultTest::text_places_areLeftOutWhenUnknown_data() {
  QTest::addColumn<QByteArray>("file");
  QTest::addColumn<int>("line");
  QTest::addColumn<int>("column");
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("all") << QByteArray("cafe.yaml") << 12 << 7
                       << QByteArray("cafe.yaml:12:7: warning: odd");
  QTest::newRow("no column") << QByteArray("cafe.yaml") << 12 << 0
                             << QByteArray("cafe.yaml:12: warning: odd");
  QTest::newRow("no line") << QByteArray("cafe.yaml") << 0 << 7
                           << QByteArray("cafe.yaml: warning: odd");
  QTest::newRow("no file") << QByteArray() << 12 << 7 << QByteArray("12:7: warning: odd");
  QTest::newRow("nothing") << QByteArray() << 0 << 0 << QByteArray("warning: odd");
}

void ResultTest::text_places_areLeftOutWhenUnknown() {
  QFETCH(QByteArray, file);
  QFETCH(int, line);
  QFETCH(int, column);
  QFETCH(QByteArray, text);
  const Diagnostic warning = base::makeWarning("odd", file.toStdString(), line, column);
  QCOMPARE(QByteArray::fromStdString(warning.text()), text);
}

void ResultTest::severityName_eachSeverity_isNamed() {
  QCOMPARE(base::severityName(base::Severity::Info), "info");
  QCOMPARE(base::severityName(base::Severity::Warning), "warning");
  QCOMPARE(base::severityName(base::Severity::Error), "error");
}

void ResultTest::hasErrors_warningsOnly_isFalse() {
  Diagnostics list = {base::makeWarning("a"), base::makeWarning("b")};
  QVERIFY(!base::hasErrors(list));
  QVERIFY(!base::hasErrors({}));
  list.push_back(base::makeError("c"));
  QVERIFY(base::hasErrors(list));
}

void ResultTest::append_listToItself_doublesIt() {
  Diagnostics list = {base::makeWarning("a"), base::makeError("b")};
  base::append(list, list);
  QCOMPARE(list.size(), std::size_t{4});
  QVERIFY(list[2].message == "a" && list[3].message == "b");
}

void ResultTest::result_value_carriesWarnings() {
  const Result<int> result(3, {base::makeWarning("odd")});
  QVERIFY(static_cast<bool>(result));
  QCOMPARE(*result, 3);
  QCOMPARE(result.diagnostics().size(), std::size_t{1});
}

void ResultTest::result_error_hasNoValue() {
  const Result<int> one = base::makeError("broken", "x.yaml", 2);
  QVERIFY(!one);
  QCOMPARE(QByteArray::fromStdString(one.diagnostics().front().text()),
           QByteArray("x.yaml:2: error: broken"));
  const Result<int> many = Diagnostics{base::makeWarning("a"), base::makeError("b")};
  QVERIFY(!many);
  QCOMPARE(many.diagnostics().size(), std::size_t{2});
}

void ResultTest::result_moveOnlyValue_canBeTaken() {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  const std::unique_ptr<int> taken = *std::move(result);
  QCOMPARE(*taken, 5);
}

void ResultTest::error_values_fillTheHolesInOrder() {
  const Diagnostic problem = base::error("scenario.id-twice", {"anna", 3, "{name}"}, "x.yaml", 2);
  QCOMPARE(QByteArray::fromStdString(problem.text()),
           QByteArray("x.yaml:2: error: anna: id 3 is that of {name} too"));
  QVERIFY(problem.code == "scenario.id-twice");
  QVERIFY(problem.value("id") == "3" && problem.value("other") == "{name}");
  QVERIFY(problem.value("goal").empty());
  const Diagnostic number = base::warning("person.vel-too-high", {"anna", 2.5});
  QVERIFY(number.severity == base::Severity::Warning && number.value("found") == "2.5");
}

void ResultTest::error_hintWithoutValue_isLeftOut() {
  const auto said = [](const std::optional<std::string>& nearest) {
    return base::error("planner.unknown-parameter", {"bob.x", "pursuit", nearest}).message;
  };
  QVERIFY(said("lookahead") == "bob.x: unknown to 'pursuit' (did you mean 'lookahead'?)");
  QVERIFY(said(std::nullopt) == "bob.x: unknown to 'pursuit'");
  const auto word = [](const char* who, const char* nearest) {
    return base::error("scenario.unknown-word", {who, "model", "sfn", nearest, "sfm, orca"})
        .message;
  };
  QVERIFY(word("anna", "sfm") ==
          "anna: model 'sfn' is unknown (did you mean 'sfm'? known: sfm, orca)");
  QVERIFY(word("", "") == "model 'sfn' is unknown (known: sfm, orca)");
}

void ResultTest::problemTexts_ids_areUniqueAndInAreas() {
  std::set<std::string_view> ids;
  for (const base::ProblemText& each : base::problemTexts()) {
    const QByteArray id(each.id.data(), static_cast<int>(each.id.size()));
    QVERIFY2(ids.insert(each.id).second, id);
    QVERIFY2(QRegularExpression(QStringLiteral("^[a-z]+\\.[a-z]+(-[a-z0-9]+)*$"))
                 .match(QString::fromLatin1(id))
                 .hasMatch(),
             id);
    QVERIFY2(!each.text.empty(), id);
    QVERIFY2(base::problemText(each.id)->text == each.text, id);
  }
  QVERIFY(base::problemText("no.such-problem") == nullptr);
}

QTEST_APPLESS_MAIN(ResultTest)
#include "tst_Result.moc"
