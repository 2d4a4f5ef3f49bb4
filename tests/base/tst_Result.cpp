#include <memory>
#include <string>

#include <QtTest>

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

QTEST_APPLESS_MAIN(ResultTest)
#include "tst_Result.moc"
