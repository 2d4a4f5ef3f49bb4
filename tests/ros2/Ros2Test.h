#pragma once

#include <memory>

#include "app/bridge/dds/Participant.h"

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
