#pragma once

#include <functional>
#include <memory>

#include <QtTest>

#include "app/bridge/dds/Participant.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/std_msgs.h"

/// For tests over the loopback of this machine.
Q_DECLARE_METATYPE(bridge::Rmw)

namespace ros2test {

using namespace bridge;

/// Each test program has domains of its own, so that those that run at once do not meet.
inline DomainSettings inDomain(int domain, Rmw rmw = Rmw::FastRtps,
                               Distro distro = Distro::Humble) {
  DomainSettings settings;
  settings.domain = domain;
  settings.rmw = rmw;
  settings.distro = distro;
  return settings;
}

inline std::unique_ptr<Participant> participant(const DomainSettings& settings) {
  base::Result<std::unique_ptr<Participant>> made = Participant::create(settings);
  return made ? *std::move(made) : nullptr;
}

constexpr Milliseconds kLong(15000);  // until others are met, on a busy machine

inline QString text(const char* words) {
  return QString::fromLatin1(words);
}

inline Bytes encodedText(const std::string& words) {
  std_msgs::String message;
  message.data = words;
  return encode(message);
}

inline std::string textIn(const Bytes& bytes) {
  const base::Result<std_msgs::String> message = decode<std_msgs::String>(bytes);
  return message ? message->data : "?";
}

inline void addRmws() {
  QTest::addColumn<Rmw>("rmw");
  QTest::newRow("fastrtps") << Rmw::FastRtps;
  QTest::newRow("cyclonedds") << Rmw::CycloneDds;
}

/// Takes each message of the topic that can be read.
template <class M, class Take>
std::unique_ptr<Subscription> hear(Participant& by, int node, const char* topic, const Qos& qos,
                                   Take take) {
  auto made = by.subscription(node, topic, M::kType, qos, [take](const Bytes& bytes) {
    if (const base::Result<M> message = decode<M>(bytes)) {
      take(*message);
    }
  });
  return made ? *std::move(made) : nullptr;
}

/// Both spin until it is done; false: it never was.
inline bool spinBoth(Participant& a, Participant& b, const std::function<bool()>& isDone) {
  const auto until = std::chrono::steady_clock::now() + kLong;
  bool done = isDone();
  while (!done && std::chrono::steady_clock::now() < until) {
    a.spin(Milliseconds(5));
    b.spin(Milliseconds(5));
    done = isDone();
  }
  return done;
}

}  // namespace ros2test
