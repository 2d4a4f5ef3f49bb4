#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/robot/NavigatorHost.h"
#include "sim2d/base/Result.h"

namespace bt {

/// Messages and service calls to a robot's navigator at given times, from the scenario's
/// `nav2_topics`. A plain value.
class NavigatorTopics {
 public:
  /// Parses "12.0 controller_selector FollowPath2; 20 /pause": entries separated by ';', each with
  /// its time [s], the name of the topic or service and the message text (empty for a call).
  /// Errors: a missing or negative time, a missing name.
  static base::Result<NavigatorTopics> read(const std::string& text);

  /// The last message of a topic published by `now` [s]. A leading '/' is ignored.
  TopicMessage lastOf(const std::string& topic, double now) const;
  /// The messages after the one with that number, oldest first.
  std::vector<TopicMessage> after(const std::string& topic, int number, double now) const;

 private:
  struct Published {
    double time = 0.0;  // [s]
    std::string text;
  };
  std::map<std::string, std::vector<Published>> topics_;  // by name without '/', ordered by time
};

}  // namespace bt
