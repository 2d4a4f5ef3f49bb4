#include <QtTest>

#include "bt/tree/TreeXml.h"
#include "editor/trees/TreeEdits.h"

using editor::NodeLocation;
using editor::OptionalLocation;
using editor::OptionalLocations;

/// Edits of trees as values, of one and of several nodes.
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
  /// A node "name" is `<Sequence name='name'>`, so that places and names are told apart.
  static bt::TreeFile named() {
    return *bt::readTreeText(
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Fallback name='r'>"
        "<Sequence name='a'><AlwaysSuccess name='a0'/><AlwaysSuccess name='a1'/>"
        "<AlwaysSuccess name='a2'/></Sequence>"
        "<Inverter name='i'><AlwaysFailure name='i0'/></Inverter>"
        "<Sequence name='b'><AlwaysSuccess name='b0'/></Sequence>"
        "</Fallback></BehaviorTree></root>");
  }
  static std::vector<NodeLocation> allAt(const std::vector<bt::NodePath>& paths) {
    std::vector<NodeLocation> places;
    places.reserve(paths.size());
    for (const bt::NodePath& path : paths) {
      places.push_back({"Main", path});
    }
    return places;
  }
  static OptionalLocations only(const bt::NodePath& path) { return OptionalLocations({at(path)}); }
  static bt::NodeSpec node(const char* id) { return editor::defaultNode(id); }

 private Q_SLOTS:
  void add_atAPlace_countsFromWhatIsThere() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::addNodes(file, at({0}), 1, {node("AlwaysSuccess")}), only({0, 1}));
    QCOMPARE(editor::addNodes(file, at({}), 99, {node("Inverter")}), only({2}));
    QCOMPARE(shortOf(file), QStringLiteral("Fallback(Sequence(AlwaysFailure AlwaysSuccess "
                                           "RunOnce(AlwaysSuccess)) StopMovement Inverter)"));
    const bt::TreeFile before = file;
    QVERIFY(
        !editor::addNodes(file, at({0, 2}), 0, {node("AlwaysSuccess")}));   // a decorator is full
    QVERIFY(!editor::addNodes(file, at({1}), 0, {node("AlwaysSuccess")}));  // a leaf
    QVERIFY(!editor::addNodes(file, at({7}), 0, {node("AlwaysSuccess")}));
    QVERIFY(!editor::addNodes(file, {"Other", {}}, 0, {node("AlwaysSuccess")}));
    QVERIFY(file == before);
  }

  void remove_choosesWhatIsLeftBesideIt() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::removeNodes(file, {at({1})}), only({0}));
    QCOMPARE(editor::removeNodes(file, {at({0})}), only({}));
    QCOMPARE(shortOf(file), QStringLiteral("Fallback"));
    QVERIFY(!editor::removeNodes(file, {at({})}));
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
    const OptionalLocations to = editor::moveNodes(file, {at({from.begin(), from.end()})},
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
    QVERIFY(*editor::nodeAt(file, to->front()) == moved);
  }

  void wrapAndUnwrap_takeEachOtherBack() {
    bt::TreeFile file = plain();
    for (const bt::NodePath& path : {bt::NodePath{}, bt::NodePath{0, 1}, bt::NodePath{1}}) {
      QCOMPARE(editor::wrapNodes(file, {at(path)}, node("Inverter")), only(path));
      QVERIFY(file != plain());
      QCOMPARE(editor::unwrapNode(file, at(path)), OptionalLocation(at(path)));
      QVERIFY(file == plain());
    }
    QVERIFY(!editor::wrapNodes(file, {at({1})}, node("StopMovement")));  // a leaf holds nothing
    QVERIFY(!editor::unwrapNode(file, at({1})));
    QVERIFY(!editor::unwrapNode(file, at({})));  // two nodes cannot be a root
    QCOMPARE(editor::unwrapNode(file, at({0})), OptionalLocation(at({0})));
    QCOMPARE(shortOf(file),
             QStringLiteral("Fallback(AlwaysFailure RunOnce(AlwaysSuccess) StopMovement)"));
  }

  void duplicate_standsBehind() {
    bt::TreeFile file = plain();
    QCOMPARE(editor::duplicateNodes(file, {at({1})}), only({2}));
    QVERIFY(*editor::nodeAt(file, at({2})) == *editor::nodeAt(file, at({1})));
    QVERIFY(!editor::duplicateNodes(file, {at({})}));
    QVERIFY(!editor::duplicateNodes(file, {at({0, 1, 0})}));  // a decorator holds one
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

  void places_inOthers_areLeftOut() {
    QVERIFY(editor::withoutDescendants(allAt({{2}, {0, 1}, {0}, {2, 0}, {1, 0}})) ==
            allAt({{0}, {1, 0}, {2}}));
    QVERIFY(editor::withoutDescendants(allAt({{0, 1}, {}})) == allAt({{}}));
    QVERIFY(editor::areSiblings(allAt({{0}, {2}})));
    QVERIFY(!editor::areSiblings(allAt({{0}, {2, 0}})));
    QVERIFY(!editor::areSiblings(allAt({{}})));
  }

  void remove_several_takesAllInAnyOrder() {
    bt::TreeFile file = named();
    QVERIFY(editor::removeNodes(file, allAt({{2, 0}, {0, 0}, {0, 2}, {1}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a1) b)"));
    QVERIFY(!editor::removeNodes(file, allAt({{}})));
  }

  void move_several_data() {
    QTest::addColumn<QString>("nodes");
    QTest::addColumn<QString>("parent");
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("result");
    const auto row = [](const char* name, const char* nodes, const char* parent, int index,
                        const char* result) {
      QTest::newRow(name) << nodes << parent << index << result;
    };
    row("to another parent", "0.0 0.2", "2", 0, "r(a(a1) i(i0) b(a0 a2 b0))");
    row("behind all there", "0.0 0.2", "2", 9, "r(a(a1) i(i0) b(b0 a0 a2))");
    row("forward in a row", "0 1", "", 3, "r(b(b0) a(a0 a1 a2) i(i0))");
    row("backward", "1 2", "", 0, "r(i(i0) b(b0) a(a0 a1 a2))");
    row("apart, together", "0.0 0.2", "0", 2, "r(a(a1 a0 a2) i(i0) b(b0))");
    row("from two parents", "0.1 2.0", "", 1, "r(a(a0 a2) a1 b0 i(i0) b)");
    row("parent after the gap", "0 1", "2", 1, "r(b(b0 a(a0 a1 a2) i(i0)))");
    row("where they are", "0 1", "", 1, "");
    row("into one of them", "0 1", "0", 0, "");
    row("no room", "0.0 0.1", "1", 1, "");
  }
  void move_several() {
    QFETCH(QString, nodes);
    QFETCH(QString, parent);
    QFETCH(int, index);
    QFETCH(QString, result);
    const auto pathOf = [](const QString& text) {
      bt::NodePath path;
      for (const QString& part : text.split(QLatin1Char('.'), Qt::SkipEmptyParts)) {
        path.push_back(part.toInt());
      }
      return path;
    };
    std::vector<bt::NodePath> paths;
    for (const QString& each : nodes.split(QLatin1Char(' '))) {
      paths.push_back(pathOf(each));
    }
    bt::TreeFile file = named();
    const OptionalLocations moved =
        editor::moveNodes(file, allAt(paths), {"Main", pathOf(parent)}, index);
    QCOMPARE(moved.has_value(), !result.isEmpty());
    if (moved) {
      QCOMPARE(shortOf(file), result);
      QCOMPARE(moved->size(), paths.size());
      for (std::size_t k = 0; k < paths.size(); ++k) {
        const bt::TreeFile before = named();
        QCOMPARE(editor::nodeAt(file, (*moved)[k])->label(),
                 editor::nodeAt(before, allAt(paths)[k])->label());
      }
    }
  }

  void wrap_siblings_standInOneNode() {
    bt::TreeFile file = named();
    bt::NodeSpec around = editor::defaultNode("Sequence");
    around.name = "w";
    QVERIFY(editor::wrapNodes(file, allAt({{0}, {2}}), around) == OptionalLocations(allAt({{0}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(w(a(a0 a1 a2) b(b0)) i(i0))"));
    file = named();
    QVERIFY(!editor::wrapNodes(file, allAt({{0}, {2, 0}}), around));
    file = named();
    QVERIFY(!editor::wrapNodes(file, allAt({{0}, {2}}), editor::defaultNode("Inverter")));
    file = named();
    QVERIFY(editor::wrapNodes(file, allAt({{}}), around));  // the root alone may be
    QCOMPARE(shortOf(file), QStringLiteral("w(r(a(a0 a1 a2) i(i0) b(b0)))"));
  }

  void duplicate_siblingsBehindTheLast_othersBehindThemselves() {
    bt::TreeFile file = named();
    QVERIFY(editor::duplicateNodes(file, allAt({{0}, {1}})) ==
            OptionalLocations(allAt({{2}, {3}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a0 a1 a2) i(i0) a(a0 a1 a2) i(i0) b(b0))"));
    file = named();
    QVERIFY(editor::duplicateNodes(file, allAt({{0, 0}, {2}})) ==
            OptionalLocations(allAt({{0, 1}, {3}})));
    QCOMPARE(shortOf(file), QStringLiteral("r(a(a0 a0 a1 a2) i(i0) b(b0) b(b0))"));
    file = named();
    QVERIFY(editor::duplicateNodes(file, allAt({{1}, {2, 0}})) ==
            OptionalLocations(allAt({{2}, {3, 1}})));
    QVERIFY(!editor::duplicateNodes(file, allAt({{1, 0}, {2}})));  // the inverter holds one
  }

  void text_ofSeveral_isReadBack() {
    const bt::TreeFile file = named();
    const std::string text = editor::nodesText(
        {editor::nodeAt(file, allAt({{0}})[0]), editor::nodeAt(file, allAt({{1, 0}})[0])});
    bt::TreeFile into;
    const auto nodes = editor::nodesFromText(text, into);
    QVERIFY(nodes && nodes->size() == 2);
    QVERIFY((*nodes)[0] == *editor::nodeAt(file, allAt({{0}})[0]));
    QVERIFY((*nodes)[1] == *editor::nodeAt(file, allAt({{1, 0}})[0]));
    QVERIFY(!editor::nodesFromText("<Sequence><", into));
    QVERIFY(!editor::nodesFromText("words", into));
  }
};

QTEST_APPLESS_MAIN(TreeEditsTest)
#include "tst_TreeEdits.moc"
