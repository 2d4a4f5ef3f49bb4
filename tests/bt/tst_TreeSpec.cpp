#include <QtTest/QtTest>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"

/// Editing of trees, and text of ports as values.
class TreeSpecTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void equal_lineAndNotation_doNotCount();
  void referencedKey_table_data();
  void referencedKey_table();
  void textValues_table_data();
  void textValues_table();
  void checkTree_range_isWarned();
  void catalogue_find_nearest();
  void placeholders_writtenOnes_doNotCount();
};

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

}  // namespace

void TreeSpecTest::equal_lineAndNotation_doNotCount() {
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

void TreeSpecTest::referencedKey_table_data() {
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

void TreeSpecTest::referencedKey_table() {
  QFETCH(QString, text);
  QFETCH(QString, key);
  const std::optional<std::string> found = bt::referencedKey(text.toStdString(), "port");
  QCOMPARE(QString::fromStdString(found.value_or(std::string())), key);
  QCOMPARE(found.has_value(), !key.isEmpty());
}

void TreeSpecTest::textValues_table_data() {
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

void TreeSpecTest::textValues_table() {
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

void TreeSpecTest::checkTree_range_isWarned() {
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

void TreeSpecTest::catalogue_find_nearest() {
  const bt::NodeCatalogue catalogue = bt::builtinNodes();
  QVERIFY(catalogue.find("Sequence"));
  QVERIFY(!catalogue.find("sequence"));
  QVERIFY(catalogue.nearest("Falback") == std::optional<std::string>("Fallback"));
  QVERIFY(!catalogue.nearest("Xyzzy"));
  for (const bt::NodeManifest& manifest : catalogue.all()) {
    QVERIFY2(!manifest.description.empty(), manifest.id.c_str());
    QVERIFY2(!manifest.category.empty(), manifest.id.c_str());
    for (const bt::PortSpec& port : manifest.ports) {
      QVERIFY2(!port.help.empty(), (manifest.id + "." + port.key).c_str());
    }
  }
}

void TreeSpecTest::placeholders_writtenOnes_doNotCount() {
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

QTEST_APPLESS_MAIN(TreeSpecTest)
#include "tst_TreeSpec.moc"
