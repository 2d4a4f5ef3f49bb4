#include <QtTest/QtTest>

#include "bt/tree/TreeXml.h"
#include "tests/bt/TreeTexts.h"

using probe::parsed;
using probe::root;
using probe::textOf;
using probe::tree;

/// Deep and large tree files: read whole or refused, soon and with little memory.
class TreeNestingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_entityBomb_isNotExpanded();
  void read_tagsOfPieces_areWhatTheFileSays();
  void read_deepNesting_isRead();
  void read_deepBlock_isWhole();
  void read_deepNesting_isRefusedSoon();
  void read_manyDeepSiblings_takeLittle();
  void read_hundredThousandNodes_isRead();
};

void TreeNestingTest::read_entityBomb_isNotExpanded() {
  std::string bomb = "<!DOCTYPE r [<!ENTITY a 'aaaaaaaaaa'>";
  for (char c = 'b'; c < 'k'; ++c) {
    const std::string before = std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += std::string("<!ENTITY ") + c + " '";
    for (int i = 0; i < 10; ++i) {
      bomb += before;
    }
    bomb += "'>";
  }
  bomb += "]>" + root(tree("T", "<AlwaysSuccess name='&j;'/>"));
  const base::Result<bt::TreeFile> file = bt::readTreeText(bomb, "t.xml");
  if (file) {
    QVERIFY(file->trees.at(0).root.name.size() < 10);
  } else {
    QVERIFY(base::hasErrors(file.diagnostics()));
  }
}

namespace {

int nodesIn(const bt::NodeSpec& node) {
  int count = 1;
  for (const bt::NodeSpec& child : node.children) {
    count += nodesIn(child);
  }
  return count;
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) {
    result += text;
  }
  return result;
}

}  // namespace

/// Deep files are read in pieces: an element of the file never stands for one of them.
void TreeNestingTest::read_tagsOfPieces_areWhatTheFileSays() {
  constexpr int kCalls = 60;  // of pieces, in each of three pieces
  const std::string calls = repeated("<piece-of-this-file n='0'/>", kCalls);
  const std::string one = "<Sequence>" + calls + repeated("<Inverter>", 70);
  const std::string ends = repeated(repeated("</Inverter>", 70) + "</Sequence>", 3);
  const base::Result<bt::TreeFile> file = bt::readTreeText(
      root(tree("T", (repeated(one, 3) + "<AlwaysSuccess/>" + ends).c_str())), "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec& top = file->trees.at(0).root;
  QCOMPARE(nodesIn(top), 3 * (1 + kCalls + 70) + 1);
  QCOMPARE(top.children.at(0).id, std::string("piece-of-this-file"));
  QVERIFY(top.children.at(0).children.empty());
  const auto program = bt::compile(*file, bt::NodeLibrary());
  QVERIFY(textOf(program.diagnostics()).find("piece-of-this-file") != std::string::npos);
  // The mark of a piece is no text.
  QVERIFY(!bt::readTreeText(root(tree("T", "<\xFFpiece n='0'/>")), "t.xml"));
}

/// The model block of a file is as deep as its trees may be.
void TreeNestingTest::read_deepBlock_isWhole() {
  for (const int depth : {200, 300}) {
    const std::string block = "<TreeNodesModel>" + repeated("<a>", depth) + "<b c='d'/>" +
                              repeated("</a>", depth) + "</TreeNodesModel>";
    const base::Result<bt::TreeFile> file =
        bt::readTreeText(root(tree("T", "<AlwaysSuccess/>") + block), "t.xml");
    QCOMPARE(bool(file), depth < bt::kMaxNesting);
    if (!file) {
      QVERIFY(textOf(file.diagnostics()).find("nested") != std::string::npos);
      continue;
    }
    const bt::XmlElement* last = &*file->model;
    for (int i = 0; i < depth; ++i) {
      QCOMPARE(last->children.size(), std::size_t(1));
      last = &last->children[0];
      QCOMPARE(last->tag, std::string("a"));
    }
    QCOMPARE(last->children.at(0).attributes, (bt::Attributes{{"c", "d"}}));
    const std::string written = bt::writeTree(*file, bt::NodeLibrary().catalogue());
    QVERIFY(*parsed(written).model == *file->model);
  }
}

void TreeNestingTest::read_deepNesting_isRead() {
  constexpr int kDeep = 250;
  QString text = QStringLiteral("<root BTCPP_format='4'>\n<BehaviorTree ID='T'>\n");
  for (int i = 0; i < kDeep; ++i) {
    text += QStringLiteral("<Inverter name='i%1'>\n").arg(i);
  }
  text += QStringLiteral("<AlwaysSuccess name='a > \"b'/><!-- <x> -->\n");
  text += QStringLiteral("</Inverter>\n").repeated(kDeep);
  const QString end = QStringLiteral("</BehaviorTree>\n</root>");
  const base::Result<bt::TreeFile> file = bt::readTreeText((text + end).toStdString(), "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec* node = &file->trees[0].root;
  for (int i = 0; i < kDeep; ++i) {
    QCOMPARE(node->name, "i" + std::to_string(i));
    QCOMPARE(node->line, 3 + i);
    QCOMPARE(node->children.size(), std::size_t(1));
    node = &node->children[0];
  }
  QCOMPARE(node->name, std::string("a > \"b"));
  // An error behind the pieces has its line.
  const base::Result<bt::TreeFile> broken =
      bt::readTreeText((text + QStringLiteral("<x a=/>") + end).toStdString(), "t.xml");
  QVERIFY(!broken);
  QCOMPARE(broken.diagnostics().front().line, 4 + 2 * kDeep);
}

/// 100 000 siblings, each on a line of its own, at a depth where the file is cut.
void TreeNestingTest::read_manyDeepSiblings_takeLittle() {
  constexpr int kDeep = 78;  // below root and BehaviorTree
  constexpr int kMany = 100000;
  std::string text = "<root BTCPP_format='4'>\n<BehaviorTree ID='T'>\n";
  for (int i = 0; i < kDeep; ++i) {
    text += i + 1 < kDeep ? "<Inverter>\n" : "<Sequence>\n";
  }
  for (int i = 0; i < kMany; ++i) {
    text += "<AlwaysSuccess/>\n";
  }
  text += "</Sequence>\n";
  for (int i = 1; i < kDeep; ++i) {
    text += "</Inverter>\n";
  }
  const base::Result<bt::TreeFile> file =
      bt::readTreeText(text + "</BehaviorTree>\n</root>", "t.xml");
  QVERIFY2(file, textOf(file.diagnostics()).c_str());
  const bt::NodeSpec* node = &file->trees[0].root;
  while (node->children.size() == 1) {
    node = &node->children[0];
  }
  QCOMPARE(node->children.size(), std::size_t{kMany});
  QCOMPARE(node->children.front().line, 3 + kDeep);
  QCOMPARE(node->children.back().line, 2 + kDeep + kMany);
}

void TreeNestingTest::read_deepNesting_isRefusedSoon() {
  for (const int depth : {300, 10000}) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
      text += "<Inverter>";
    }
    text += "<AlwaysSuccess/>";
    for (int i = 0; i < depth; ++i) {
      text += "</Inverter>";
    }
    const base::Result<bt::TreeFile> file =
        bt::readTreeText(root(tree("T", text.c_str())), "t.xml");
    QVERIFY(!file);
    QVERIFY(textOf(file.diagnostics()).find("nested") != std::string::npos);
  }
}

void TreeNestingTest::read_hundredThousandNodes_isRead() {
  std::string text = "<Sequence>";
  for (int i = 0; i < 100000; ++i) {
    text += "<AlwaysSuccess name='n'/>\n";
  }
  text += "</Sequence>";
  const bt::TreeFile file = parsed(root(tree("T", text.c_str())));
  QCOMPARE(file.trees.at(0).root.children.size(), std::size_t(100000));
  const auto program = bt::compile(file, bt::NodeLibrary());
  QVERIFY2(program, textOf(program.diagnostics()).c_str());
  QCOMPARE((*program)->nodeCount(), 100001);
  bt::TreeState state(*program);
  QCOMPARE(state.tickOnce({1, 0.1, nullptr}), base::NodeStatus::Success);
}

QTEST_APPLESS_MAIN(TreeNestingTest)
#include "tst_TreeNesting.moc"
