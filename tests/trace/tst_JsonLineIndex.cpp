#include <QtTest>

#include "sim2d/trace/JsonInput.h"

using sim2d::JsonLineIndex;

namespace {

constexpr char kText[] =
    "{\n"
    " \"dt\": 0.05,\n"
    " \"empty\": [],\n"
    " \"humans\": [\n"
    "  {\"id\": 1, \"name\": \"a \\\" b\"},\n"
    "  {\"id\": 2,\n"
    "   \"goals\": [\n"
    "     {\"x\": 1.0},\n"
    "     {\"x\": 2.0}]}\n"
    " ],\n"
    " \"map\": {\n"
    "  \"cells\": [0, 12]\n"
    " }\n"
    "}\n";

}  // namespace

/// Lines counted by hand.
class JsonPlacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lineOf_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("line");
    const auto row = [](const char* path, int line) {
      QTest::newRow(path) << QString::fromUtf8(path) << line;
    };
    row("dt", 2);
    row("empty", 3);
    row("humans", 4);
    row("humans[0]", 5);
    row("humans[0].name", 5);
    row("humans[1]", 6);
    row("humans[1].goals", 7);
    row("humans[1].goals[1].x", 9);
    row("map.cells", 12);
    row("map.cells[1]", 12);       // a number: where its list is
    row("map.width", 11);          // is not there: its object
    row("humans[1].velocity", 6);  // idem
    row("humans[7].id", 4);
    row("nothing", 0);
  }
  void lineOf() {
    QFETCH(QString, path);
    QTEST(JsonLineIndex(kText).lineOf(path.toStdString()), "line");
  }

  void noJson_hasNoPlaces() {
    QCOMPARE(JsonLineIndex("{\"a\": 1,\n\"b\": }").lineOf("a"), 0);
    QCOMPARE(JsonLineIndex("").lineOf("a"), 0);
  }
};

QTEST_APPLESS_MAIN(JsonPlacesTest)
#include "tst_JsonLineIndex.moc"
