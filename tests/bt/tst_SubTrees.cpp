#include <QtTest/QtTest>

#include "bt/tree/TreeXml.h"
#include "tests/bt/TraceRows.h"
#include "tests/bt/TreeTexts.h"

using probe::parsed;
using probe::root;
using probe::textOf;
using probe::tree;
using traces::row;

namespace {

/// Two trees; the first one runs.
std::string trees(const char* main, const char* sub, const char* model = "") {
  return std::string("<root BTCPP_format='4' main_tree_to_execute='M'>") + model +
         "<BehaviorTree ID='M'>" + main + "</BehaviorTree><BehaviorTree ID='Sub'>" + sub +
         "</BehaviorTree></root>";
}

void rowsOfEntries() {
  row("mapped down",
      trees("<Sequence><Script code='a := 3'/><SubTree ID='Sub' x='{a}'/></Sequence>",
            "<ReadDouble value='{x}'/>"),
      "3 -> SUCCESS");
  row("mapped up",
      trees("<Sequence><SubTree ID='Sub' x='{a}'/><ReadInt value='{a}'/></Sequence>",
            "<Put value='{x}' number='4'/>"),
      "4 -> SUCCESS");
  row("not mapped",
      trees("<Sequence><Script code='a := 3'/><SubTree ID='Sub'/></Sequence>",
            "<ScriptCondition code='a == 3'/>"),
      "!no value");
  row("automatic",
      trees("<Sequence><Script code='a := 3'/><SubTree ID='Sub' _autoremap='true'/></Sequence>",
            "<ReadDouble value='{a}'/>"),
      "3 -> SUCCESS");
  row("private keys are not automatic",
      trees("<Sequence><Script code='_a := 3'/><SubTree ID='Sub' _autoremap='true'/></Sequence>",
            "<ScriptCondition code='_a == 3'/>"),
      "!no value");
  row("root entries",
      trees("<Sequence><Script code='a := 3'/><SubTree ID='Sub'/></Sequence>",
            "<Sequence><ReadDouble value='{@a}'/><Script code='@b := 5'/></Sequence>"),
      "3 -> SUCCESS");
  row("same name",
      trees("<Sequence><Script code='x := 3'/><SubTree ID='Sub' x='{=}'/></Sequence>",
            "<ReadDouble value='{x}'/>"),
      "3 -> SUCCESS");
}

void rowsOfValuesAndCalls() {
  row("literal number", trees("<SubTree ID='Sub' x='7'/>", "<ReadInt value='{x}'/>"),
      "7 -> SUCCESS");
  row("literal whole number for a real",
      trees("<SubTree ID='Sub' x='7'/>", "<ReadDouble value='{x}'/>"), "7 -> SUCCESS");
  row("literal text", trees("<SubTree ID='Sub' x='a b'/>", "<ReadText value='{x}'/>"),
      "a b -> SUCCESS");
  row("literal is a copy of each call",
      trees("<Sequence><SubTree ID='Sub' x='1'/><SubTree ID='Sub' x='2'/></Sequence>",
            "<Sequence><ReadInt value='{x}'/><Put value='{x}' number='9'/><ReadInt value='{x}'/>"
            "</Sequence>"),
      "1 9 2 9 -> SUCCESS|9 9 9 9 -> SUCCESS");
  row("model default",
      trees("<SubTree ID='Sub'/>", "<ReadInt value='{x}'/>",
            "<TreeNodesModel><SubTree ID='Sub'><input_port name='x' default='5'/></SubTree>"
            "</TreeNodesModel>"),
      "5 -> SUCCESS");
  row("status", trees("<Inverter><SubTree ID='Sub'/></Inverter>", "<St/>"),
      "start -> RUNNING|run1 -> FAILURE|start -> RUNNING");
  row("halted", trees("<Timeout msec='100'><SubTree ID='Sub'/></Timeout>", "<St runs='9'/>"),
      "start -> RUNNING|halt -> FAILURE");
  row("literal counts as written",
      trees("<SubTree ID='Sub' x='7'/>",
            "<Sequence><WasEntryUpdated entry='x'/><ReadInt value='{x}'/></Sequence>"),
      "7 -> SUCCESS|-> FAILURE");
  row("unset removes what is of the SubTree alone",
      trees("<Sequence><Put value='{a}' number='3'/><SubTree ID='Sub' x='{a}' y='5'/>"
            "<ReadInt value='{a}'/></Sequence>",
            "<Sequence><UnsetBlackboard key='x'/><UnsetBlackboard key='@a'/><ReadInt value='{x}'/>"
            "<UnsetBlackboard key='y'/><Inverter><WasEntryUpdated entry='y'/></Inverter>"
            "</Sequence>"),
      "3 3 -> SUCCESS");
  row("the key of another blackboard is in an entry",
      trees("<Sequence><Put value='{a}' number='3'/><SubTree ID='Sub' x='{a}' k='x'/>"
            "<ReadInt value='{a}'/></Sequence>",
            "<SetBlackboard value='4' output_key='{k}'/>"),
      "4 -> SUCCESS");
  row("three levels",
      "<root BTCPP_format='4' main_tree_to_execute='A'><BehaviorTree ID='A'><Sequence>"
      "<Script code='k := 1'/><SubTree ID='B' k='{k}'/><ReadDouble value='{k}'/></Sequence>"
      "</BehaviorTree><BehaviorTree ID='B'><SubTree ID='C' _autoremap='1'/></BehaviorTree>"
      "<BehaviorTree ID='C'><Script code='k := k + 1'/></BehaviorTree></root>",
      "2 -> SUCCESS");
  row("conditions of a SubTree use the caller's entries",
      trees("<Sequence><Script code='a := 1'/><SubTree ID='Sub' _skipIf='a == 1'/></Sequence>",
            "<S/>"),
      "-> SUCCESS");
}

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

/// Blackboards of nested trees, and the typing of entries.
class SubTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_subTree_givesTrace_data() {
    traces::columns();
    rowsOfEntries();
    rowsOfValuesAndCalls();
  }

  void tick_subTree_givesTrace() { traces::checkRow(); }

  void compile_types_data() {
    QTest::addColumn<QString>("xml");
    QTest::addColumn<QString>("problem");  // empty = compiles
    const auto add = [](const char* name, const std::string& xml, const char* problem) {
      QTest::newRow(name) << QString::fromStdString(xml) << QString::fromUtf8(problem);
    };
    add("same type twice", "<Sequence><Put value='{n}'/><ReadInt value='{n}'/></Sequence>", "");
    add("int and double", "<Sequence><ReadInt value='{n}'/><ReadDouble value='{n}'/></Sequence>",
        "port 'value' is double, but {n} is int");
    add("text is read by any port",
        "<Sequence><ReadText value='{n}'/><ReadDouble value='{n}'/><ReadInt "
        "value='{n}'/></Sequence>",
        "");
    add("int is not read as text",
        "<Sequence><ReadInt value='{n}'/><ReadText value='{n}'/></Sequence>",
        "port 'value' is std::string, but {n} is int");
    add("id is an int", "<ReadInt value='{id}'/>", "");
    add("id is no real", "<ReadDouble value='{id}'/>", "but {id} is int (by the program)");
    add("dt is no int", "<ReadInt value='{dt}'/>", "but {dt} is double");
    add("types cross SubTrees",
        trees("<Sequence><ReadInt value='{a}'/><SubTree ID='Sub' x='{a}'/></Sequence>",
              "<ReadDouble value='{x}'/>"),
        "port 'value' is double, but {x} is int");
    add("literal number as text", trees("<SubTree ID='Sub' x='7'/>", "<ReadText value='{x}'/>"),
        "port 'value' is std::string, but {x} is int");
    add("named without a type first",
        "<Sequence><SetBlackboard value='{n}' output_key='m'/><ReadInt value='{n}'/>"
        "<ReadDouble value='{n}'/></Sequence>",
        "");
    add("named without a type first, by the caller",
        trees("<Sequence><SetBlackboard value='{n}' output_key='m'/>"
              "<SubTree ID='Sub' _autoremap='true'/></Sequence>",
              "<Sequence><ReadInt value='{n}'/><ReadDouble value='{n}'/></Sequence>"),
        "");
    add("untyped ports fit everything",
        "<Sequence><ReadInt value='{n}'/><SetBlackboard value='{n}' output_key='m'/>"
        "<ReadInt value='{m}'/></Sequence>",
        "");
  }

  void compile_types() {
    QFETCH(QString, xml);
    QFETCH(QString, problem);
    const auto program = probe::compiled(xml.toStdString());
    const std::string problems = probe::textOf(program.diagnostics());
    QCOMPARE(static_cast<bool>(program), problem.isEmpty());
    QVERIFY2(QString::fromStdString(problems).contains(problem), problems.c_str());
  }

  void hostEntries_areSeenBelow() {
    probe::Run run(
        trees("<SubTree ID='Sub' agent='{id}' step='{dt}'/>",
              "<Sequence><ReadInt value='{agent}'/><ReadDouble value='{step}'/></Sequence>"));
    QVERIFY2(run.state && run.problems.empty(), run.problems.c_str());
    const bt::Program& program = run.state->program();
    QVERIFY(run.state->set(program.hostSlot(0), 12));
    QVERIFY(run.state->set(program.hostSlot(1), 0.25));
    QCOMPARE(run.trace(), std::string("12 0.25 -> SUCCESS"));
    QCOMPARE(program.findSlot("id"), program.hostSlot(0));
    QCOMPARE(program.findSlot("unknown"), -1);
    QVERIFY(!run.state->set(program.hostSlot(0), 0.5));  // an int
    QVERIFY(run.state->set(program.hostSlot(0), 3.0));
  }

  void entries_list_hasPathsOfSubTrees() {
    probe::Run run(
        trees("<Sequence><Script code='a := 1.5'/><SubTree ID='Sub' name='s'/></Sequence>",
              "<Script code=\"b := 'text'\"/>"));
    run.tick();
    using Entries = std::vector<std::pair<std::string, std::string>>;
    QVERIFY((run.state->entries() == Entries{{"a", "1.5"}, {"Sequence/s/b", "text"}}));
  }

  void compile_tooManySubTrees_isRefused() {
    std::string xml = "<root BTCPP_format='4' main_tree_to_execute='T0'>";
    for (int i = 0; i < 40; ++i) {  // 2^40 nodes
      const std::string call = "<SubTree ID='T" + std::to_string(i + 1) + "'/>";
      xml += "<BehaviorTree ID='T" + std::to_string(i) + "'><Sequence>";
      xml.append(call).append(call).append("</Sequence></BehaviorTree>");
    }
    xml += "<BehaviorTree ID='T40'><AlwaysSuccess/></BehaviorTree></root>";
    const auto program = probe::compiled(xml);
    QVERIFY(!program);
    QVERIFY(probe::textOf(program.diagnostics()).find("too large") != std::string::npos);
  }

  void interop_reactionTree_runs() {
    probe::Run run(
        "<root main_tree_to_execute='CuriousNavTree'>"
        "<BehaviorTree ID='CuriousNavTree'><Fallback name='CuriousFallback'>"
        "<Sequence name='CurNav'><F name='IsRobotVisible'/></Sequence>"
        "<Sequence name='RegNav'><SetBlackboard output_key='agentid' value='{id}'/>"
        "<SetBlackboard output_key='timestep' value='{dt}'/>"
        "<SubTree ID='RegularNavTree' id='agentid' dt='timestep'/></Sequence></Fallback>"
        "</BehaviorTree><BehaviorTree ID='RegularNavTree'><Sequence>"
        "<ReadInt value='{id}'/><ReadDouble value='{dt}'/></Sequence></BehaviorTree></root>");
    QVERIFY2(run.state, run.problems.c_str());
    run.state->set(run.state->program().hostSlot(0), 5);
    run.state->set(run.state->program().hostSlot(1), 0.1);
    QCOMPARE(run.trace(), std::string("IsRobotVisible 5 0.1 -> SUCCESS"));
  }

  // Deep and large tree files: read whole or refused, soon and with little memory.

  void read_entityBomb_isNotExpanded() {
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

  /// Deep files are read in pieces: an element of the file never stands for one of them.
  void read_tagsOfPieces_areWhatTheFileSays() {
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

  void read_deepNesting_isRead() {
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

  /// The model block of a file is as deep as its trees may be.
  void read_deepBlock_isWhole() {
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

  void read_deepNesting_isRefusedSoon() {
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

  /// 100 000 siblings, each on a line of its own, at a depth where the file is cut.
  void read_manyDeepSiblings_takeLittle() {
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

  void read_hundredThousandNodes_isRead() {
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
};

QTEST_APPLESS_MAIN(SubTreesTest)
#include "tst_SubTrees.moc"
