#include <QtTest>

#include "bt/tree/TreeXml.h"
#include "editor/trees/TreeEdits.h"

using editor::NodeLocation;
using editor::OptionalLocation;

/// Edits of trees as values.
class TreeEditsTest : public QObject {
  Q_OBJECT

 private:
  static bt::TreeFile fileOf(const std::string& body) {
    return *bt::readTreeText("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + body +
                             "</BehaviorTree></root>");
  }
  static bt::TreeFile plain() {
    return fileOf(
        "<Fallback><Sequence><AlwaysFailure/><RunOnce><AlwaysSuccess/></RunOnce></Sequence>"
        "<StopMovement agent_id='{id}'/></Fallback>");
  }
  /// The nodes in short: "Fallback(Sequence(AlwaysFailure RunOnce(AlwaysSuccess)) StopMovement)".
  static QString shortOf(const bt::NodeSpec& node) {
    QStringList children;
    for (const bt::NodeSpec& child : node.children) {
      children << shortOf(child);
    }
    const QString label = QString::fromStdString(node.label());
    return children.isEmpty()
               ? label
               : QStringLiteral("%1(%2)").arg(label, children.join(QLatin1Char(' ')));
  }
  static QString shortOf(const bt::TreeFile& file) { return shortOf(file.trees.front().root); }
  static NodeLocation at(const bt::NodePath& path) { return {"Main", path}; }
  static bt::NodeSpec node(const char* id) { return editor::defaultNode(id); }

 private Q_SLOTS:
  void add_atAPlace_countsFromWhatIsThere() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::addNode(file, at({0}), 1, node("AlwaysSuccess")),
             OptionalLocation(at({0, 1})));
    QCOMPARE(editor::addNode(file, at({}), 99, node("Inverter")), OptionalLocation(at({2})));
    QCOMPARE(shortOf(file), QStringLiteral("Fallback(Sequence(AlwaysFailure AlwaysSuccess "
                                           "RunOnce(AlwaysSuccess)) StopMovement Inverter)"));
    const bt::TreeFile before = file;
    QVERIFY(!editor::addNode(file, at({0, 2}), 0, node("AlwaysSuccess")));  // a decorator is full
    QVERIFY(!editor::addNode(file, at({1}), 0, node("AlwaysSuccess")));     // a leaf
    QVERIFY(!editor::addNode(file, at({7}), 0, node("AlwaysSuccess")));
    QVERIFY(!editor::addNode(file, {"Other", {}}, 0, node("AlwaysSuccess")));
    QVERIFY(file == before);
  }

  void remove_choosesWhatIsLeftBesideIt() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::removeNode(file, at({1})), OptionalLocation(at({0})));
    QCOMPARE(editor::removeNode(file, at({0})), OptionalLocation(at({})));
    QCOMPARE(shortOf(file), QStringLiteral("Fallback"));
    QVERIFY(!editor::removeNode(file, at({})));
  }

  void move_withinAndBetweenParents_data() {
    QTest::addColumn<QList<int>>("from");
    QTest::addColumn<QList<int>>("parent");
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("becomes");  // empty: it cannot be done
    QTest::newRow("to the end") << QList<int>{0} << QList<int>{} << 2
                                << "F(StopMovement S(A R(B)))";
    QTest::newRow("into an earlier sibling")
        << QList<int>{1} << QList<int>{0} << 1 << "F(S(A StopMovement R(B)))";
    QTest::newRow("out of its parent")
        << QList<int>{0, 0} << QList<int>{} << 0 << "F(A S(R(B)) StopMovement)";
    QTest::newRow("behind its parent")
        << QList<int>{0, 1} << QList<int>{} << 2 << "F(S(A) StopMovement R(B))";
    QTest::newRow("where it is") << QList<int>{0} << QList<int>{} << 0 << QString();
    QTest::newRow("behind itself") << QList<int>{0} << QList<int>{} << 1 << QString();
    QTest::newRow("into itself") << QList<int>{0} << QList<int>{0, 1} << 0 << QString();
    QTest::newRow("into a full one") << QList<int>{1} << QList<int>{0, 1} << 0 << QString();
    QTest::newRow("the root") << QList<int>{} << QList<int>{0} << 0 << QString();
  }
  void move_withinAndBetweenParents() {
    QFETCH(QList<int>, from);
    QFETCH(QList<int>, parent);
    QFETCH(int, index);
    QFETCH(QString, becomes);
    bt::TreeFile file = plain();
    const bt::NodeSpec moved = *editor::nodeAt(file, at({from.begin(), from.end()}));
    const OptionalLocation to = editor::moveNode(file, at({from.begin(), from.end()}),
                                                 at({parent.begin(), parent.end()}), index);
    QCOMPARE(to.has_value(), !becomes.isEmpty());
    if (!to) {
      QVERIFY(file == plain());
      return;
    }
    becomes.replace(QStringLiteral("F("), QStringLiteral("Fallback("))
        .replace(QStringLiteral("S("), QStringLiteral("Sequence("))
        .replace(QStringLiteral("R(B)"), QStringLiteral("RunOnce(AlwaysSuccess)"))
        .replace(QRegularExpression(QStringLiteral("\\bA\\b")), QStringLiteral("AlwaysFailure"));
    QCOMPARE(shortOf(file), becomes);
    QVERIFY(*editor::nodeAt(file, *to) == moved);
  }

  void wrapAndUnwrap_takeEachOtherBack() {
    bt::TreeFile file = plain();
    for (const bt::NodePath& path : {bt::NodePath{}, bt::NodePath{0, 1}, bt::NodePath{1}}) {
      QCOMPARE(editor::wrapNode(file, at(path), node("Inverter")), OptionalLocation(at(path)));
      QVERIFY(file != plain());
      QCOMPARE(editor::unwrapNode(file, at(path)), OptionalLocation(at(path)));
      QVERIFY(file == plain());
    }
    QVERIFY(!editor::wrapNode(file, at({1}), node("StopMovement")));  // a leaf holds nothing
    QVERIFY(!editor::unwrapNode(file, at({1})));
    QVERIFY(!editor::unwrapNode(file, at({})));  // two nodes cannot be a root
    QCOMPARE(editor::unwrapNode(file, at({0})), OptionalLocation(at({0})));
    QCOMPARE(shortOf(file),
             QStringLiteral("Fallback(AlwaysFailure RunOnce(AlwaysSuccess) StopMovement)"));
  }

  void duplicate_standsBehind() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::duplicateNode(file, at({1})), OptionalLocation(at({2})));
    QVERIFY(*editor::nodeAt(file, at({2})) == *editor::nodeAt(file, at({1})));
    QVERIFY(!editor::duplicateNode(file, at({})));
    QVERIFY(!editor::duplicateNode(file, at({0, 1, 0})));  // a decorator holds one
  }

  void replace_keepsChildrenAndPortsThatItHas() {
    bt::TreeFile file = fileOf(
        "<Sequence name='walk' _uid='3'><IsRobotVisible agent_id='{id}' distance='7'/></Sequence>");
    QCOMPARE(editor::replaceNode(file, at({}), node("Fallback")), OptionalLocation(at({})));
    QCOMPARE(shortOf(file), QStringLiteral("walk(IsRobotVisible)"));
    QCOMPARE(file.trees[0].root.id, std::string("Fallback"));
    QCOMPARE(file.trees[0].root.others.size(), std::size_t{1});
    QVERIFY(!editor::replaceNode(file, at({}), node("StopMovement")));  // has no room for it
    QVERIFY(editor::replaceNode(file, at({0}), node("StopMovement")));
    const bt::NodeSpec& leaf = *editor::nodeAt(file, at({0}));
    QCOMPARE(*bt::findAttribute(leaf.ports, "agent_id"), std::string("{id}"));
    QVERIFY(bt::findAttribute(leaf.ports, "distance") == nullptr);
  }

  void extractAndInline_takeEachOtherBack() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::extractTree(file, at({0}), "Say it!"), OptionalLocation(at({0})));
    QCOMPARE(file.trees.size(), std::size_t{2});
    QCOMPARE(file.trees[1].id, std::string("Sayit"));
    QCOMPARE(file.mainTree, std::string("Main"));
    QVERIFY(editor::nodeAt(file, at({0}))->autoRemap);
    QVERIFY(bt::readTreeText(bt::writeTree(file, bt::builtinNodes())));
    bt::TreeFile twice = file;
    QVERIFY(editor::extractTree(twice, at({1}), "Sayit"));
    QCOMPARE(twice.trees[2].id, std::string("Sayit2"));
    QCOMPARE(editor::inlineTree(file, at({0})), OptionalLocation(at({0})));
    QCOMPARE(file.trees.size(), std::size_t{1});
    QCOMPARE(shortOf(file), shortOf(plain()));
    QVERIFY(!editor::extractTree(file, at({}), "x"));
    QVERIFY(!editor::inlineTree(file, at({0})));
  }

  void inline_ofATreeWithEntriesOfItsOwn_isRefused() {
    bt::TreeFile file = fileOf("<Sequence><SubTree ID='Sub' id='{id}'/></Sequence>");
    bt::TreeSpec sub;
    sub.id = "Sub";
    sub.root = node("AlwaysSuccess");
    file.trees.push_back(sub);
    QVERIFY(!editor::inlineTree(file, at({0})));
    bt::NodeSpec& tree = file.trees[0].root.children[0];
    tree.ports.clear();
    QVERIFY(!editor::inlineTree(file, at({0})));  // shares nothing
    tree.autoRemap = true;
    QVERIFY(editor::inlineTree(file, at({0})));
  }

  void xml_ofANode_comesBack() {
    bt::TreeFile file = plain();
    const bt::NodeSpec& part = *editor::nodeAt(file, at({0}));
    const std::string text = editor::nodeText(part);
    QVERIFY(text.rfind("<Sequence>", 0) == 0);
    const base::Result<bt::NodeSpec> again = editor::nodeFromText(text, file);
    QVERIFY(again);
    QVERIFY(*again == part);
    QVERIFY(!editor::nodeFromText("<Sequence>", file));
    QVERIFY(!editor::nodeFromText("no xml", file));
    QVERIFY(!editor::nodeFromText("<A/><B/>", file));
  }

  void xml_ofAFile_bringsItsTreesAlong() {
    bt::TreeFile file = plain();
    const base::Result<bt::NodeSpec> node = editor::nodeFromText(
        "<root BTCPP_format='4' main_tree_to_execute='B'><BehaviorTree ID='A'><AlwaysSuccess/>"
        "</BehaviorTree><BehaviorTree ID='B'><SubTree ID='A'/></BehaviorTree></root>",
        file);
    QVERIFY(node);
    QCOMPARE(node->subTree, std::string("A"));
    QCOMPARE(file.trees.size(), std::size_t{2});
    QCOMPARE(file.trees[1].id, std::string("A"));
  }

  void fresh_hasTheValuesOfANewNode() {
    const bt::NodeSpec fresh = node("IsRobotVisible");
    QCOMPARE(*bt::findAttribute(fresh.ports, "agent_id"), std::string("{id}"));
    QVERIFY(node("no such node").ports.empty());
    QVERIFY(editor::canHaveChildren(node("no such node")));
    QVERIFY(!editor::canHaveChildren(node("IsRobotVisible")));
  }
};

QTEST_APPLESS_MAIN(TreeEditsTest)
#include "tst_TreeEdits.moc"
