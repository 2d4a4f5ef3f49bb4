#include <QtTest>

#include "WildRun.h"
#include "sim2d/trace/FramePacking.h"

using namespace sim2d;

namespace {

std::vector<FramePtr> wildFrames(std::int64_t from, int count, int people) {
  std::vector<FramePtr> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    frames.push_back(std::make_shared<const Frame>(wild::frameAt(from + k, people)));
  }
  return frames;
}

}  // namespace

class FramePackingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void unpack_anyStates_areEqualBitByBit_data();
  void unpack_anyStates_areEqualBitByBit();
  void pack_straightWalk_takesHalfAByteForANumber();
  void unpack_bytesThatEndEarly_doesNotReadOn();
};

void FramePackingTest::unpack_anyStates_areEqualBitByBit_data() {
  QTest::addColumn<int>("count");
  QTest::addColumn<int>("people");
  QTest::addColumn<double>("interval");
  QTest::newRow("none") << 0 << 5 << 0.05;
  QTest::newRow("one") << 1 << 5 << 0.0;
  QTest::newRow("nobody") << 10 << 0 << 0.05;
  QTest::newRow("few") << 200 << 3 << 0.05;
  QTest::newRow("crowd") << 64 << 150 << 0.05;
  QTest::newRow("no interval") << 64 << 20 << 0.0;
}

void FramePackingTest::unpack_anyStates_areEqualBitByBit() {
  QFETCH(int, count);
  QFETCH(int, people);
  QFETCH(double, interval);
  const std::vector<FramePtr> frames = wildFrames(17, count, people);
  const std::vector<FramePtr> found = unpackFrames(packFrames(frames, interval));
  QCOMPARE(found.size(), frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    QVERIFY2(wild::isSameState(*found[k], *frames[k]), QByteArray::number(int(k)));
  }
}

/// Without forces everybody goes on as before: of the 14 numbers of each only the lengths are kept,
/// four bits each. A fixed part of a state comes to it.
void FramePackingTest::pack_straightWalk_takesHalfAByteForANumber() {
  constexpr int kPeople = 100, kStates = 64;
  constexpr double kInterval = 0.05;  // [s]
  std::vector<FramePtr> frames;
  Frame frame;
  for (int id = 1; id <= kPeople; ++id) {
    const Vec2 velocity(0.01 * id, 1.0 - 0.003 * id);
    frame.humans.add(id, {Vec2(0.3 * id, -0.7 * id), base::headingOf(velocity)}, velocity, 0.0, 1);
    frame.humans.group.push_back(-1);
    frame.humans.state.push_back(0);
    for (std::vector<Vec2>* force :
         {&frame.forces.goal, &frame.forces.social, &frame.forces.obstacle, &frame.forces.group}) {
      force->emplace_back(0.0, 0.0);
    }
  }
  for (int k = 0; k < kStates; ++k) {
    frames.push_back(std::make_shared<const Frame>(frame));
    ++frame.step;
    for (std::size_t i = 0; i < frame.humans.size(); ++i) {
      frame.humans.x[i] += frame.humans.vx[i] * kInterval;
      frame.humans.y[i] += frame.humans.vy[i] * kInterval;
    }
  }
  const std::size_t first = packFrames({frames.front()}, kInterval).size();
  const std::size_t all = packFrames(frames, kInterval).size();
  const double perState = static_cast<double>(all - first) / (kStates - 1);
  QVERIFY2(perState >= 7.0 * kPeople && perState < 7.0 * kPeople + 100.0,
           QByteArray::number(perState));
}

void FramePackingTest::unpack_bytesThatEndEarly_doesNotReadOn() {
  const std::string bytes = packFrames(wildFrames(3, 6, 4), 0.05);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string cut = bytes.substr(0, size);  // sanitizers see its end
    QVERIFY(unpackFrames(cut).size() <= 6);
  }
}

QTEST_APPLESS_MAIN(FramePackingTest)
#include "tst_FramePacking.moc"
