#include "app/cli/RunObservers.h"
#include "app/window/MainWindow.h"
#include "editor/look/AppStyle.h"
#include "tests/app/QuietWindow.h"
#include "tests/bridge/LiveClient.h"
#ifdef HUNAV_ROS2
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "tests/ros2/Ros2Test.h"
#endif

using editor::SimulationRunner;

/// Runs of the window that others see.
class RunSharingTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() {
    qunsetenv("ROS_DOMAIN_ID");
    end();
  }

  void run_nobodyAsked_isToldToNobody();
  void run_inFoxglove_isWatchedAndPaused();
  void run_onTopics_isHeardAndOrdered();

 private:
  SimulationRunner& runner() { return window_->workspace().runner(); }
  int portOfNotice() const {
    const QString text = told("live-view").text;
    const int from = text.indexOf(QStringLiteral("localhost:")) + 10;
    return from < 10 ? 0 : text.mid(from, text.indexOf(QLatin1Char(' '), from) - from).toInt();
  }
};

void RunSharingTest::run_nobodyAsked_isToldToNobody() {
  QVERIFY(window_->open(copyOfDemo()));
  window_->workspace().playback().playPause->trigger();
  QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step > 3);
  QVERIFY(told("live-view").text.isEmpty());
}

void RunSharingTest::run_inFoxglove_isWatchedAndPaused() {
  QVERIFY(window_->open(copyOfDemo()));
  window_->actions().publishFoxglove->setChecked(true);
  window_->workspace().playback().playPause->trigger();
  QTRY_VERIFY(!told("live-view").text.isEmpty());
  quiet::shoot(*window_, "live-view");
  client::LiveClient client(portOfNotice());
  QVERIFY(client.isConnected() && client.open());
  QCOMPARE(client.await("serverInfo").value(QLatin1String("name")).toString(),
           QStringLiteral("hunavsim: demo"));
  QVERIFY(!client.await("advertise").isEmpty());
  const auto set = [&client](const char* name, const char* value) {
    client.text(std::string(R"({"op":"setParameters","parameters":[{"name":")") + name +
                R"(","value":)" + value + "}]}");
  };
  set("/hunavsim.real_time_factor", "2.5");
  QTRY_COMPARE(runner().speed(), 2.5);
  set("/hunavsim.paused", "true");
  QTRY_COMPARE(runner().state(), SimulationRunner::State::Paused);
  const std::int64_t step = runner().newestFrame()->step;
  window_->workspace().playback().playPause->trigger();  // by the window again
  QTRY_VERIFY(runner().newestFrame()->step > step + 2);
  window_->actions().publishFoxglove->setChecked(false);  // of the runs after this one
  runner().reset();
  QVERIFY(told("live-view").text.isEmpty());
  QVERIFY(client.awaitClose() > 0);
}

/// Another node hears the people; what it sends on /goal_pose is an input of the run.
void RunSharingTest::run_onTopics_isHeardAndOrdered() {
  QCOMPARE(window_->actions().publishRos2->isVisible(), app::hasRos2Support());
#ifdef HUNAV_ROS2
  using namespace ros2test;
  constexpr int kDomain = 36;
  qputenv("ROS_DOMAIN_ID", QByteArray::number(kDomain));
  QVERIFY(window_->open(copyOfDemo()));
  window_->actions().publishRos2->setChecked(true);
  window_->workspace().playback().playPause->trigger();
  const std::unique_ptr<Participant> other = participant(inDomain(kDomain));
  QVERIFY(other != nullptr);
  const int node = other->addNode("/", "other");
  std::size_t people = 0;
  const auto hears = other->subscription(
      node, "/human_states", hunav_msgs::Agents::kType, Qos(), [&](const Bytes& bytes) {
        const base::Result<hunav_msgs::Agents> agents = decode<hunav_msgs::Agents>(bytes);
        people = agents ? agents->agents.size() : 0;
      });
  const auto orders =
      other->publisher(node, "/goal_pose", geometry_msgs::PoseStamped::kType, Qos());
  QVERIFY(hears && orders);
  geometry_msgs::PoseStamped order;
  order.header.frameId = "map";
  order.pose.position = {7.8, 0.9, 0.0};
  const auto isOrdered = [&] {
    const editor::RecordingPtr recording = runner().recording();
    return recording != nullptr && recording->inputs().size() > 0;
  };
  QElapsedTimer clock;
  clock.start();
  while ((people == 0 || !isOrdered()) && clock.elapsed() < kLong.count()) {
    (*orders)->publish(encode(order));
    other->spin(Milliseconds(20));
    QCoreApplication::processEvents();
  }
  QCOMPARE(people, std::size_t{8});
  QVERIFY(isOrdered());
  QVERIFY(runner().recording()->inputs()[0].second.kind == sim2d::InputKind::Goal);
#endif
}

QTEST_MAIN(RunSharingTest)
#include "tst_RunSharing.moc"
