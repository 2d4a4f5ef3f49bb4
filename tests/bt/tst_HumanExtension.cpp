#include <QtTest>

#include "bt/human/HumanContext.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"
#include "tests/bt/FakeWorld.h"

namespace bt {

namespace {

NodeStatus isAlone(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  return successIf(human && nearestPerson(context.view(), *human) < 0);
}

// All that a new node takes: this would be the file nodes/IsAlone.cpp.
void addIsAlone(NodeLibrary& to) {
  to.addCondition(ownNode("IsAlone", "Perception", "Nobody else is in the world.", {port::agent()},
                          NodeKind::Condition),
                  isAlone);
}

}  // namespace
}  // namespace bt

class HumanExtensionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void newNode_fromOneFunction_isInCatalogueAndTree() {
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0);
    world.addPerson(2, 5.0, 0.0);
    TreeBench bench(world);
    bt::addIsAlone(bench.library());
    QVERIFY(bench.library().catalogue().find("IsAlone"));
    QVERIFY(bench.load("<Sequence><IsAlone agent_id='{id}'/></Sequence>"));
    QVERIFY(bench.loadDiagnostics().empty());
    QCOMPARE(bench.step(), base::NodeStatus::Failure);
    world.at(1).isPresent = false;
    QCOMPARE(bench.step(), base::NodeStatus::Success);
  }
};

QTEST_APPLESS_MAIN(HumanExtensionTest)
#include "tst_HumanExtension.moc"
