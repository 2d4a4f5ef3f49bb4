#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "tests/support/Columns.h"
#include "tests/support/CommaLocale.h"

namespace {

std::string bytes(const QByteArray& array) {
  return array.toStdString();
}

void checkRoundTrips() {
  std::mt19937_64 generator(99);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t pattern = generator();
    double value = 0.0;
    std::memcpy(&value, &pattern, sizeof value);
    if (!std::isfinite(value)) {
      continue;
    }
    QVERIFY(base::parseDouble(base::formatDouble(value)) == value);
    QVERIFY(base::parseDouble(base::formatDecimals(value, 3)) == value);
  }
}

}  // namespace

class TextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void parseDouble_goodToken_isItsValue_data() {
    addColumns<QByteArray, double>({"token", "value"});
    QTest::newRow("plain") << QByteArray("1.5") << 1.5;
    QTest::newRow("exponent") << QByteArray("-2e3") << -2000.0;
    QTest::newRow("capital exponent") << QByteArray("2E-3") << 0.002;
    QTest::newRow("no leading digit") << QByteArray(".5") << 0.5;
    QTest::newRow("no trailing digit") << QByteArray("5.") << 5.0;
    QTest::newRow("plus") << QByteArray("+1") << 1.0;
    QTest::newRow("leading zero is decimal") << QByteArray("010") << 10.0;
    QTest::newRow("negative zero") << QByteArray("-0") << -0.0;
    QTest::newRow("many digits") << QByteArray("0.1000000000000000055511151231257827") << 0.1;
    QTest::newRow("subnormal") << QByteArray("5e-324") << 5e-324;
  }

  void parseDouble_goodToken_isItsValue() {
    QFETCH(QByteArray, token);
    QFETCH(double, value);
    const std::optional<double> got = base::parseDouble(bytes(token));
    QVERIFY(got.has_value());
    QVERIFY(*got == value && std::signbit(*got) == std::signbit(value));
  }

  void parseDouble_badToken_isNothing_data() {
    QTest::addColumn<QByteArray>("token");
    for (const char* token :
         {"",      " ",     "1 ",  " 1",  "1,5",      "0.88a984", "1.2.3",  "--1",  "+-1",
          "-+1",   "++1",   "+",   "-",   ".",        "e5",       "1e",     "1e+",  "0x10",
          "1_000", "1e400", "one", "INF", "infinity", "NaN",      "nan(1)", "-nan", "1.5f"}) {
      QTest::newRow(*token == '\0' ? "empty" : token) << QByteArray(token);
    }
    QTest::newRow("embedded zero") << QByteArray("1\0", 2);
  }

  void parseDouble_badToken_isNothing() {
    QFETCH(QByteArray, token);
    QVERIFY(!base::parseDouble(bytes(token)).has_value());
  }

  void parseDouble_notFinite_onlyAsSpelledInYaml() {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const char* token : {"nan", ".nan", ".NaN", ".NAN"}) {
      QVERIFY(std::isnan(base::parseDouble(token).value()));
    }
    for (const char* token : {"inf", ".inf", "+.inf", ".Inf", ".INF"}) {
      QVERIFY(base::parseDouble(token) == infinity);
    }
    QVERIFY(base::parseDouble("-inf") == -infinity);
    QVERIFY(base::parseDouble("-.inf") == -infinity);
  }

  void parseInt_tokens() {
    QVERIFY(base::parseInt("12") == 12LL);
    QVERIFY(base::parseInt("-7") == -7LL);
    QVERIFY(base::parseInt("+7") == 7LL);
    QVERIFY(base::parseInt("010") == 10LL);
    QVERIFY(base::parseInt("9223372036854775807") == std::numeric_limits<long long>::max());
    for (const char* token : {"", "1.0", "1e3", "9223372036854775808", "0x1", "+-1", " 1", "1 "}) {
      QVERIFY2(!base::parseInt(token).has_value(), token);
    }
  }

  void formatDouble_values_areShortest_data() {
    addColumns<double, QByteArray>({"value", "text"});
    QTest::newRow("tenth") << 0.1 << QByteArray("0.1");
    QTest::newRow("small") << 1e-7 << QByteArray("1e-07");
    QTest::newRow("whole") << 3.0 << QByteArray("3");
    QTest::newRow("third") << 1.0 / 3.0 << QByteArray("0.3333333333333333");
    QTest::newRow("negative zero") << -0.0 << QByteArray("-0");
    QTest::newRow("largest") << std::numeric_limits<double>::max()
                             << QByteArray("1.7976931348623157e+308");
    QTest::newRow("smallest") << -5e-324 << QByteArray("-5e-324");
    QTest::newRow("nan") << std::numeric_limits<double>::quiet_NaN() << QByteArray("nan");
    QTest::newRow("inf") << std::numeric_limits<double>::infinity() << QByteArray("inf");
    QTest::newRow("-inf") << -std::numeric_limits<double>::infinity() << QByteArray("-inf");
  }

  void formatDouble_values_areShortest() {
    QFETCH(double, value);
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(base::formatDouble(value)), text);
  }

  void formatDecimals_values_haveNoExponent_data() {
    addColumns<double, int, QByteArray>({"value", "decimals", "text"});
    QTest::newRow("padded") << 1.5 << 3 << QByteArray("1.500");
    QTest::newRow("whole") << 3.0 << 1 << QByteArray("3.0");
    QTest::newRow("none") << 3.0 << 0 << QByteArray("3");
    QTest::newRow("negative count") << 3.0 << -2 << QByteArray("3");
    QTest::newRow("more than asked") << 0.12345 << 2 << QByteArray("0.12345");
    QTest::newRow("small") << 1e-7 << 3 << QByteArray("0.0000001");
    QTest::newRow("large") << 1e21 << 1 << QByteArray("1000000000000000000000.0");
    QTest::newRow("nan") << std::numeric_limits<double>::quiet_NaN() << 3 << QByteArray("nan");
  }

  void formatDecimals_values_haveNoExponent() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(base::formatDecimals(value, decimals)), text);
  }

  void formatAndParse_anyDouble_comesBack() { checkRoundTrips(); }

  void formatAndParse_commaLocale_usesThePoint() {
    const CommaLocale locale;
    if (!locale.active()) {
      QSKIP("no locale with a decimal comma here, and none could be made (package locales)");
    }
    QVERIFY(base::parseDouble("1.5") == 1.5);
    QVERIFY(!base::parseDouble("1,5").has_value());
    QVERIFY(base::formatDouble(1.5) == "1.5");
    QVERIFY(base::formatDecimals(1.5, 3) == "1.500");
    checkRoundTrips();
  }

  void nearestName_typing_findsTheMeantOne_data() {
    QTest::addColumn<QByteArray>("word");
    QTest::addColumn<QByteArray>("meant");  // empty = nothing is close
    QTest::newRow("letter too many") << QByteArray("max_vell") << QByteArray("max_vel");
    QTest::newRow("swapped") << QByteArray("raduis") << QByteArray("radius");
    QTest::newRow("case") << QByteArray("RADIUS") << QByteArray("radius");
    QTest::newRow("short") << QByteArray("iid") << QByteArray("id");
    QTest::newRow("another word") << QByteArray("colour") << QByteArray();
    QTest::newRow("one letter") << QByteArray("x") << QByteArray();
    QTest::newRow("empty") << QByteArray() << QByteArray();
  }

  void nearestName_typing_findsTheMeantOne() {
    QFETCH(QByteArray, word);
    QFETCH(QByteArray, meant);
    const std::optional<std::string> got =
        base::nearestName(bytes(word), {"radius", "max_vel", "id", "behavior"});
    QCOMPARE(QByteArray::fromStdString(got.value_or("")), meant);
  }

  void visible_controlCharacters_areEscaped() {
    using namespace std::string_literals;
    QCOMPARE(base::escapedControls("plain Ä€ 人"), std::string("plain Ä€ 人"));
    QCOMPARE(base::escapedControls("\x1b[2Jx\x7f\0\n\t"s),
             std::string("\\x1b[2Jx\\x7f\\x00\\x0a\\x09"));
    QCOMPARE(base::escapedControls("\xc2\x9b"
                                   "31m"),
             std::string("\\x9b31m"));  // CSI as one character
    // What is no UTF-8: cut, stray, longer than needed, a surrogate, beyond U+10FFFF.
    QCOMPARE(base::escapedControls("\xc2"), std::string("\\xc2"));
    QCOMPARE(base::escapedControls("\xe4\xba|"), std::string("\\xe4\\xba|"));
    QCOMPARE(base::escapedControls("\x80\xff"), std::string("\\x80\\xff"));
    QCOMPARE(base::escapedControls("\xc0\xaf"), std::string("\\xc0\\xaf"));
    QCOMPARE(base::escapedControls("\xed\xa0\x80"), std::string("\\xed\\xa0\\x80"));
    QCOMPARE(base::escapedControls("\xf4\x90\x80\x80"), std::string("\\xf4\\x90\\x80\\x80"));
    QCOMPARE(base::escapedControls("\xf4\x8f\xbf\xbf\xc3\xa4"),
             std::string("\xf4\x8f\xbf\xbf\xc3\xa4"));
    QCOMPARE(base::escapedControls("a\nb\r", "\n"), std::string("a\nb\\x0d"));
  }

  void trimmed_spacesAround_areRemoved() {
    QVERIFY(base::trimmed(" \t a b\r\n") == "a b");
    QVERIFY(base::trimmed(" \n ").empty());
  }

  void split_separators_keepEmptyParts() {
    QVERIFY(base::split("a;;b;", ';') == (std::vector<std::string>{"a", "", "b", ""}));
    QVERIFY(base::split("", ';') == std::vector<std::string>{""});
  }

  void startsWith_endsWith_compareWholeParts() {
    QVERIFY(base::startsWith("cafe.yaml", "cafe"));
    QVERIFY(!base::startsWith("cafe", "cafe.yaml"));
    QVERIFY(base::endsWith("cafe.yaml", ".yaml"));
    QVERIFY(!base::endsWith("yaml", ".yaml"));
    QVERIFY(base::startsWith("", "") && base::endsWith("a", ""));
  }

  void shellWord_otherCharacters_areQuoted() {
    QCOMPARE(base::shellWord("maps/cafe_2:=a,b+c@d%"), std::string("maps/cafe_2:=a,b+c@d%"));
    QCOMPARE(base::shellWord(""), std::string("''"));
    QCOMPARE(base::shellWord("it's $1"), std::string("'it'\\''s $1'"));
  }

  void lowered_ascii_leavesOtherBytes() {
    QVERIFY(base::toLower("GoTo_42 \xc3\x84") == "goto_42 \xc3\x84");
  }
};

QTEST_APPLESS_MAIN(TextTest)
#include "tst_Text.moc"
