#include <QtTest/QtTest>
#include <algorithm>

#include "bt/engine/Program.h"
#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace {

bt::NodeSpec node(const char* id, std::vector<bt::NodeSpec> children = {}) {
  bt::NodeSpec result;
  result.id = id;
  result.children = std::move(children);
  return result;
}

/// r( a(x y) b c )
bt::TreeSpec sample() {
  bt::TreeSpec tree;
  tree.id = "T";
  tree.root = node("r", {node("a", {node("x"), node("y")}), node("b"), node("c")});
  return tree;
}

const char* const kFolder = TEST_DATA_DIR "/bt/bad/";

/// All that reading, checking and compiling say, folders left out.
QStringList problemsOf(const std::string& path) {
  base::Diagnostics problems;
  const base::Result<bt::TreeTable> table = bt::loadTrees(path);
  base::append(problems, table.diagnostics());
  if (table) {
    const bt::NodeLibrary library;
    base::append(problems, bt::diagnosticsOf(bt::checkForImport(*table, library.catalogue())));
    if (!base::hasErrors(problems)) {
      base::append(problems, bt::compile(*table, library).diagnostics());
    }
  }
  QStringList lines;
  for (const base::Diagnostic& problem : problems) {
    QString line = QString::fromStdString(problem.text());
    line.remove(QString::fromUtf8(kFolder));
    if (!lines.contains(line)) {
      lines << line;
    }
  }
  return lines;
}

}  // namespace

/// Editing of trees, and text of ports as values.
class TreeSpecTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void equal_lineAndNotation_doNotCount() {
    bt::TreeSpec a = sample();
    bt::TreeSpec b = sample();
    b.root.line = 9;
    b.root.children[0].explicitNotation = true;
    QVERIFY(a == b);
    b.root.children[1].name = "n";
    QVERIFY(!(a == b));
    b = sample();
    bt::setAttribute(b.root.ports, "p", "1");
    QVERIFY(!(a == b));
    bt::removeAttribute(b.root.ports, "p");
    QVERIFY(a == b);
  }

  void referencedKey_table_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("key");
    const auto row = [](const char* text, const char* key) {
      QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(key);
    };
    row("{id}", "id");
    row("  {id} ", "id");
    row("{@id}", "@id");
    row("{=}", "port");
    row("=", "port");
    row("{}", "");
    row("{id", "");
    row("id}", "");
    row("id", "");
    row("", "");
    row("a {id}", "");
  }

  void referencedKey_table() {
    QFETCH(QString, text);
    QFETCH(QString, key);
    const std::optional<std::string> found = bt::referencedKey(text.toStdString(), "port");
    QCOMPARE(QString::fromStdString(found.value_or(std::string())), key);
    QCOMPARE(found.has_value(), !key.isEmpty());
  }

  void textValues_table_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("asInt");
    QTest::addColumn<QString>("asUnsigned");
    QTest::addColumn<QString>("asDouble");
    QTest::addColumn<QString>("asBool");
    const auto row = [](const char* text, const char* i, const char* u, const char* d,
                        const char* b) {
      QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(i) << QString::fromUtf8(u)
                          << QString::fromUtf8(d) << QString::fromUtf8(b);
    };
    row("5", "5", "5", "5", "-");
    row("-5", "-5", "-", "-5", "-");
    row("+5", "-", "-", "-", "-");
    row(" 5", "-", "-", "-", "-");
    row("5abc", "5", "5", "5", "-");
    row("5.75", "5", "5", "5.75", "-");
    row("1", "1", "1", "1", "1");
    row("0", "0", "0", "0", "0");
    row("true", "-", "-", "-", "1");
    row("True", "-", "-", "-", "1");
    row("TRUE", "-", "-", "-", "1");
    row("false", "-", "-", "-", "0");
    row("False", "-", "-", "-", "0");
    row("yes", "-", "-", "-", "-");
    row("2147483647", "2147483647", "2147483647", "2147483647", "-");
    row("2147483648", "-", "2147483648", "2147483648", "-");
    row("4294967296", "-", "-", "4294967296", "-");
    row("99999999999999999999", "-", "-", "1e+20", "-");
    row("1e3", "1", "1", "1000", "-");
    row("1e", "1", "1", "1", "-");
    row("1e-2x", "1", "1", "0.01", "-");
    row(".5", "-", "-", "0.5", "-");
    row("5.", "5", "5", "5", "-");
    row(".", "-", "-", "-", "-");
    row("-", "-", "-", "-", "-");
    row("0,5", "0", "0", "0", "-");
    row("nan", "-", "-", "-", "-");
    row("inf", "-", "-", "inf", "-");
    row("1e999", "1", "1", "-", "-");
  }

  void textValues_table() {
    QFETCH(QString, text);
    const std::string t = text.toStdString();
    const auto shown = [](const auto& value) {
      return value ? QString::number(static_cast<double>(*value), 'g', 12) : QStringLiteral("-");
    };
    QTEST(shown(bt::intFromText(t)), "asInt");
    QTEST(shown(bt::unsignedFromText(t)), "asUnsigned");
    QTEST(shown(bt::doubleFromText(t)), "asDouble");
    QTEST(shown(bt::boolFromText(t)), "asBool");
  }

  void checkTree_range_isWarned() {
    bt::NodeCatalogue catalogue = bt::builtinNodes();
    bt::NodeManifest manifest;
    manifest.id = "Go";
    bt::PortSpec speed;
    speed.key = "speed";
    speed.portType = bt::PortType::Double;
    speed.range = {0.0, 3.0};
    manifest.ports = {speed};
    catalogue.add(manifest);
    bt::TreeSpec tree;
    tree.id = "T";
    tree.root = node("Sequence", {node("Go"), node("Go"), node("Go")});
    bt::setAttribute(tree.root.children[0].ports, "speed", "-1");
    bt::setAttribute(tree.root.children[1].ports, "speed", "3.5");
    bt::setAttribute(tree.root.children[2].ports, "speed", "{v}");
    const bt::TreeIssues issues = bt::checkTree(tree, catalogue, {"T"}, "f.xml");
    QCOMPARE(issues.size(), std::size_t(2));
    QVERIFY(issues[0].node == bt::NodePath{0});
    QVERIFY(issues[0].diagnostic.text() ==
            "f.xml: warning: T/Sequence/Go: port 'speed' is -1, less than 0");
    QVERIFY(issues[1].node == bt::NodePath{1});
    QVERIFY(issues[1].treeId == "T");
  }

  void catalogue_find_nearest() {
    const bt::NodeCatalogue catalogue = bt::builtinNodes();
    QVERIFY(catalogue.find("Sequence"));
    QVERIFY(!catalogue.find("sequence"));
    QVERIFY(catalogue.nearest("Falback") == std::optional<std::string>("Fallback"));
    QVERIFY(!catalogue.nearest("Xyzzy"));
  }

  void placeholders_writtenOnes_doNotCount() {
    bt::TreeTable table;
    bt::TreeSpec tree;
    tree.id = "T";
    bt::NodeSpec see = node("IsRobotVisible");
    bt::setAttribute(see.ports, "distance", "{dist}");
    bt::NodeSpec wait = node("Wait");
    bt::setAttribute(wait.ports, "time", "{duration}");
    bt::NodeSpec write = node("SetBlackboard");
    bt::setAttribute(write.ports, "output_key", "duration");
    tree.root = node("Sequence", {see, write, wait});
    table.entries["T"] = {tree, "f.xml"};
    QVERIFY(bt::legacyPlaceholders(table) == std::vector<std::string>{"dist"});
  }

  // Every file of data/bt/bad with exactly the problems that expected.txt names for it.

  void load_badFile_saysWhatIsWrong_data() {
    QTest::addColumn<QStringList>("expected");
    QMap<QString, QStringList> expected;
    QFile file(QString::fromUtf8(kFolder) + QStringLiteral("expected.txt"));
    QVERIFY(file.open(QIODevice::ReadOnly | QIODevice::Text));
    QString name;
    for (const QString& line :
         QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
      if (line.startsWith(QLatin1String("  "))) {
        expected[name] << line.mid(2);
      } else {
        name = line;
        expected[name];
      }
    }
    const QStringList files = QDir(QString::fromUtf8(kFolder)).entryList({QStringLiteral("*.xml")});
    QCOMPARE(QStringList(expected.keys()), files);
    for (const QString& one : files) {
      QTest::newRow(qPrintable(one)) << expected[one];
    }
  }

  void load_badFile_saysWhatIsWrong() {
    QFETCH(QStringList, expected);
    const std::string path = kFolder + std::string(QTest::currentDataTag());
    const QStringList problems = problemsOf(path);
    if (qEnvironmentVariableIsSet("BT_PRINT_PROBLEMS")) {
      QTextStream(stdout) << "=" << QTest::currentDataTag()
                          << "\n=  " << problems.join(QStringLiteral("\n=  ")) << "\n";
    }
    QCOMPARE(problems, expected);
    QVERIFY(!problems.isEmpty());
  }
};

QTEST_APPLESS_MAIN(TreeSpecTest)
#include "tst_TreeSpec.moc"
