#include <QtTest/QtTest>
#include <map>

#include "bt/engine/Script.h"

namespace {

/// A script with entries a = 2, s = 'text', and whatever it makes itself.
class Bench {
 public:
  explicit Bench(const QString& source)
      : script_(bt::compileScript(source.toStdString(),
                                  [this](const std::string& key) { return slotOf(key); })) {
    slotOf("a");
    slotOf("s");
    bt::store(slots_[static_cast<std::size_t>(keys_["a"])], 2.0);
    bt::store(slots_[static_cast<std::size_t>(keys_["s"])],
              bt::Value::of(std::string_view("text")));
  }
  bool compiles() const { return static_cast<bool>(script_); }
  std::string problem() const { return script_.diagnostics().front().message; }
  /// The result as text, "!…" when it fails.
  QString run() {
    bt::ScriptRunner runner(*script_, slots_.data());
    if (!runner.run()) {
      return QStringLiteral("!") + QString::fromStdString(runner.error());
    }
    return QString::fromStdString(runner.result().toText());
  }

 private:
  int slotOf(const std::string& key) {
    const auto [place, isNew] = keys_.emplace(key, static_cast<int>(slots_.size()));
    if (isNew) {
      slots_.emplace_back();
    }
    return place->second;
  }
  std::map<std::string, int> keys_;
  std::vector<bt::Slot> slots_;
  base::Result<bt::Script> script_;
};

void row(const char* source, const char* value) {
  QTest::newRow(source) << QString::fromUtf8(source) << QString::fromUtf8(value);
}

void rowsOfNumbers() {
  row("1 + 2 * 3", "7");
  row("(1 + 2) * 3", "9");
  row("7 - 2 - 1", "4");
  row("8 / 2 / 2", "2");
  row("-2 * -3", "6");
  row("0x1F", "31");
  row("1.5e2", "150");
  row(".5 + 1.", "1.5");
  row("true + true", "2");
  row("false", "0");
  row("!0", "1");
  row("!3", "0");
  row("~5", "-6");
  row("6 & 3", "2");
  row("6 | 1 ^ 2", "5");
  row("1 + 1 & 3", "2");
  row("1 | 2 == 3", "1");
  row("1 < 2", "1");
  row("2 <= 2", "1");
  row("3 != 3", "0");
  row("0 < 3 < 5", "1");
  row("0 < 6 < 5", "0");
  row("5 > 3 > 4", "0");
  row("0.1 + 0.2 == 0.3", "1");
  row("1 == 1.0000001", "1");
  row("1 == 1.000001", "0");
  row("1 && 0 || 1", "1");
  row("1 || 0 && 0", "1");
}

void rowsOfChoicesAndTexts() {
  row("0 ? 1 : 2", "2");
  row("1 ? 2 : 0 ? 3 : 4", "2");
  row("1 ? a : unknown", "2");
  row("'ab' + 'cd'", "abcd");
  row("'n = ' .. 3", "n = 3");
  row("1 .. 2", "");  // no value, as soon as it is used a fault
  row("'n = ' .. 0.5", "n = 0.500000");
  row("'n = ' .. (1 + 2)", "n = 3.000000");
  row("'a' < 'b'", "1");
  row("'3' == 3", "1");
  row("4 > '3'", "1");
  row("s == 'text'", "1");
  row("a", "2");
}

void rowsOfAssignments() {
  row("x := 5", "5");
  row("x := 5; x + 1", "6");
  row("x := y := 4; x + y", "8");
  row("a = 7; a", "7");
  row("a += 3; a", "5");
  row("a -= 3; a", "-1");
  row("a *= 3; a", "6");
  row("a /= 4; a", "0.5");
  row("s += '!'; s", "text!");
  row("x := 1;\n\ny := 2 ;; x + y;", "3");
  row("x := a > 1 ? 'many' : 'few'; x", "many");
}

/// As BehaviorTree.CPP 4.10.
void rowsOfTheEngine() {
  row("a = '7'; a + 1", "8");   // text to a number
  row("3 < 2 < unknown", "0");  // a comparison ends with the first that does not hold
  row("s == 'other' == unknown", "0");
  row("~2.5", "-3");
  row("~-2.5", "1");
  row("flag := 'true'; flag == true", "1");
  row("'false' == true", "0");
  row("s ? 1 : 2", "1");  // any text
  row("a > 1 ? b := 4 : 5; b", "4");
  row("x := 1 y := 2", "1");  // a ';' is missing: the rest is not run
  row("1 2", "1");
  row("0.5 && 1", "1");
  row("x := 1; x := 2.0; x", "2");
  row("x := 1.0; x := 0.5; x", "0.5");
  row("x := 2; y := x = 3.0; y", "3");
}

}  // namespace

/// Values of scripts. The numbers were worked out by hand.
class ScriptsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_script_givesValue_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("value");
    rowsOfNumbers();
    rowsOfChoicesAndTexts();
    rowsOfAssignments();
    rowsOfTheEngine();
  }

  void run_script_givesValue() {
    QFETCH(QString, source);
    QFETCH(QString, value);
    Bench bench(source);
    QVERIFY2(bench.compiles(), bench.compiles() ? "" : bench.problem().c_str());
    QCOMPARE(bench.run(), value);
  }

  void run_badScript_fails_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("message");
    row("unknown + 1", "no value");
    row("unknown = 1", "does not exist");
    row("unknown += 1", "does not exist");
    row("s + 1", "arithmetic with text");
    row("s - s", "arithmetic with text");
    QByteArray doubling("t := 'x'");  // 2^21 bytes
    for (int k = 0; k < 21; ++k) {
      doubling += "; t := t + t";
    }
    row(doubling, "more than 1 MB");
    row("s -= 'a'", "arithmetic with text");
    row("1 && 's'", "take neither text");
    row("2 && 1", "whole numbers other than 0 and 1");
    row("x := 1 .. 2", "has no value");
    row("x := 1; x := 0.5", "does not fit");
    row("x := 1; x += 0.5", "does not fit");
    row("x := 'a'; x := 1", "does not fit");
    row("s == 3", "not a number");
    row("-s", "a sign is applied to text");
    row("1.5 & 1", "not an integer");
    row("~1e300", "too large");
    row("'' ? 1 : 2", "empty text");
    row("a = 'text'", "does not fit");
    row("0 && unknown", "no value");  // both sides are evaluated
  }

  void run_badScript_fails() {
    QFETCH(QString, source);
    QFETCH(QString, message);
    Bench bench(source);
    QVERIFY(bench.compiles());
    const QString result = bench.run();
    QVERIFY2(result.startsWith(QLatin1Char('!')) && result.contains(message), qPrintable(result));
  }

  void compile_badText_saysColumn_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("message");
    row("", "empty");
    row("1 +", "value expected at column 4");
    row("(1", "')' expected at column 3");
    row("1 ? 2", "':' expected at column 6");
    row("x := 'a", "parsed at column 6");
    row("1 # 2", "parsed at column 3");
    row("5 := 3", "name of an entry expected before ':=' at column 3");
    row("12abc", "parsed at column 1");
    row("{a} == 1", "parsed at column 1");
  }

  void compile_badText_saysColumn() {
    QFETCH(QString, source);
    QFETCH(QString, message);
    Bench bench(source);
    QVERIFY(!bench.compiles());
    QVERIFY2(QString::fromStdString(bench.problem()).contains(message), bench.problem().c_str());
  }

  void compile_deepNesting_isRefused() {
    for (const char* const opening : {"(", "!", "1 ? ", "x := ", "1 ? 1 : "}) {
      const QString source = QString::fromUtf8(opening).repeated(100000) + QStringLiteral("1");
      Bench bench(source);
      QVERIFY(!bench.compiles());
    }
  }
};

QTEST_APPLESS_MAIN(ScriptsTest)
#include "tst_Scripts.moc"
