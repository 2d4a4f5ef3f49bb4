#include <functional>

#include <QtTest>

#include "bt/tree/TreeXml.h"
#include "editor/trees/TreeRefusals.h"

using editor::NodeLocation;

/// What the tree editor says when an edit is impossible, and that it says so only then.
class TreeRefusalsTest : public QObject {
  Q_OBJECT

 private:
  static bt::TreeFile tree() {
    return *bt::readTreeText(
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\"><BehaviorTree ID=\"Main\">"
        "<Fallback><Inverter name='not'><AlwaysFailure/></Inverter>"
        "<IfThenElse><AlwaysSuccess/><AlwaysFailure/></IfThenElse>"
        "<Sequence><AlwaysSuccess/><AlwaysSuccess/><Inverter><Sequence name='inner'>"
        "<AlwaysSuccess/><AlwaysFailure/></Sequence></Inverter></Sequence>"
        "<SubTree ID='Part' _autoremap='true'/><SubTree ID='Part'/><SubTree ID='Gone' "
        "_autoremap='true'/></Fallback></BehaviorTree>"
        "<BehaviorTree ID=\"Part\"><AlwaysSuccess/></BehaviorTree></root>");
  }
  static NodeLocation at(const bt::NodePath& path) { return {"Main", path}; }
  static void collect(const bt::NodeSpec& node, const bt::NodePath& path,
                      std::vector<NodeLocation>& places) {
    places.push_back(at(path));
    for (std::size_t k = 0; k < node.children.size(); ++k) {
      bt::NodePath below = path;
      below.push_back(static_cast<int>(k));
      collect(node.children[k], below, places);
    }
  }
  static std::vector<NodeLocation> allPlaces() {
    const bt::TreeFile file = tree();
    std::vector<NodeLocation> places;
    collect(file.trees.front().root, {}, places);
    return places;
  }
  static QString text(const char* words) { return QString::fromUtf8(words); }

 private Q_SLOTS:
  void onlyChildOfAnInverter_isToldInPlainWords() {
    const bt::TreeFile file = tree();
    const NodeLocation only = at({0, 0});
    QCOMPARE(editor::whyNotDuplicated(file, {only}), text("An Inverter takes one child only"));
    QCOMPARE(editor::whyNotAdded(file, at({0}), 1), text("An Inverter takes one child only"));
    QCOMPARE(editor::whyNotMovedBy(file, only, 1), text("AlwaysFailure is the only child"));
    QCOMPARE(editor::whyNotMovedBy(file, only, -1), text("AlwaysFailure is the only child"));
    QCOMPARE(editor::whyNotUnwrapped(file, at({2, 2, 0})),
             text("An Inverter takes one child only"));
  }

  void limits_ofOtherNodes_areNamed() {
    const bt::TreeFile file = tree();
    QCOMPARE(editor::whyNotAdded(file, at({0, 0}), 1), text("An AlwaysFailure takes no children"));
    QCOMPARE(editor::whyNotAdded(file, at({3}), 1), text("A SubTree takes no children"));
    QCOMPARE(editor::whyNotAdded(file, at({1}), 2), text("An IfThenElse takes at most 3 children"));
    QCOMPARE(editor::whyNotAdded(file, at({1}), 1), QString());
    QCOMPARE(editor::whyNotReplaced(file, at({2}), editor::defaultNode("Inverter")),
             text("An Inverter takes one child only: Sequence has 3 children"));
    QCOMPARE(editor::whyNotReplaced(file, at({0}), editor::defaultNode("AlwaysSuccess")),
             text("An AlwaysSuccess takes no children: not has one child"));
  }

  void rootsAndEnds_areNamed() {
    const bt::TreeFile file = tree();
    QCOMPARE(editor::whyNotRemoved(file, {at({})}),
             text("A tree needs a root: replace it instead"));
    QCOMPARE(editor::whyNotDuplicated(file, {at({})}), text("A tree can have only one root"));
    QCOMPARE(editor::whyNotUnwrapped(file, at({})), text("A tree can have only one root"));
    QCOMPARE(editor::whyNotUnwrapped(file, at({2, 0})), text("AlwaysSuccess has no children"));
    QCOMPARE(editor::whyNotExtracted(file, at({})), text("The root already has a tree of its own"));
    QCOMPARE(editor::whyNotMovedBy(file, at({}), 1), text("The root has no siblings"));
    QCOMPARE(editor::whyNotMovedBy(file, at({0}), -1), text("not is the first child"));
    QCOMPARE(editor::whyNotMovedBy(file, at({5}), 1), text("Gone is the last child"));
    QCOMPARE(editor::whyNotWrapped(file, {at({0, 0}), at({1, 0})}, editor::defaultNode("Sequence")),
             text("Only nodes with the same parent can be wrapped together"));
    QCOMPARE(editor::whyNotInlined(file, at({4})), text("Part has its own blackboard entries"));
    QCOMPARE(editor::whyNotInlined(file, at({5})), text("Gone is in an included file"));
    QCOMPARE(editor::whyNotInlined(file, at({0})), text("Only a SubTree can be inlined"));
  }

  /// An entry of the menu is enabled exactly if its edit works.
  void reason_isGivenExactlyIfTheEditFails() {
    const auto compare = [](const QString& why, const auto& edit) {
      bt::TreeFile file = tree();
      const bool works = edit(file).has_value();
      QVERIFY2(why.isEmpty() == works, qPrintable(why));
    };
    const bt::TreeFile file = tree();
    for (const NodeLocation& place : allPlaces()) {
      const std::vector<NodeLocation> one = {place};
      compare(editor::whyNotRemoved(file, one),
              [&](bt::TreeFile& to) { return editor::removeNodes(to, one); });
      compare(editor::whyNotDuplicated(file, one),
              [&](bt::TreeFile& to) { return editor::duplicateNodes(to, one); });
      compare(editor::whyNotUnwrapped(file, place),
              [&](bt::TreeFile& to) { return editor::unwrapNode(to, place); });
      compare(editor::whyNotExtracted(file, place),
              [&](bt::TreeFile& to) { return editor::extractTree(to, place, "New"); });
      compare(editor::whyNotInlined(file, place),
              [&](bt::TreeFile& to) { return editor::inlineTree(to, place); });
      for (const char* id : {"Inverter", "Sequence", "AlwaysSuccess", "IfThenElse"}) {
        const bt::NodeSpec node = editor::defaultNode(id);
        compare(editor::whyNotAdded(file, place, 1),
                [&](bt::TreeFile& to) { return editor::addNodes(to, place, 0, {node}); });
        compare(editor::whyNotReplaced(file, place, node),
                [&](bt::TreeFile& to) { return editor::replaceNode(to, place, node); });
        compare(editor::whyNotWrapped(file, one, node),
                [&](bt::TreeFile& to) { return editor::wrapNodes(to, one, node); });
        for (const NodeLocation& other : allPlaces()) {
          const std::vector<NodeLocation> two = {place, other};
          const bool hasRoot = place.isRoot() || other.isRoot();
          if (!hasRoot) {
            compare(editor::whyNotWrapped(file, two, node),
                    [&](bt::TreeFile& to) { return editor::wrapNodes(to, two, node); });
          }
        }
      }
    }
  }
};

QTEST_MAIN(TreeRefusalsTest)
#include "tst_TreeRefusals.moc"
