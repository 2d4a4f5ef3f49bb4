#include <QtTest>

#include "bt/human/Motions.h"
#include "tests/bt/FakeWorld.h"

namespace bt {

namespace {

bool isAlone(HumanContext& context, AgentIndex human) {
  return nearestAgent(context.view(), human) < 0;
}

constexpr const char* kNodes = R"(
Condition IsAlone own|Perception|Nobody else is in the world.
agent_id
)";

// All that a new node takes: this would be the file nodes/IsAlone.cpp.
void addIsAlone(NodeLibrary& to) {
  to.add(humanManifests(kNodes), {{"IsAlone", synchronous(withPorts<isAlone, 0>)}});
}

}  // namespace
}  // namespace bt

class HumanExtensionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void newNode_fromOneFunction_isInCatalogueAndTree() {
    FakeWorld world = withOnePerson();
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
