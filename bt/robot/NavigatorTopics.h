#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/robot/NavigatorHost.h"
#include "sim2d/base/Result.h"

namespace bt {

/// What is published to a robot's navigator in a run, by the scenario's `nav2_topics`: messages of
/// topics and calls of services, each at a time. A plain value.
class NavigatorTopics {
 public:
  /// "12.0 controller_selector FollowPath2; 20 /pause": with ';' between, each has its time [s],
  /// the name of the topic or service, and the text of the message (none of a call). Errors: no
  /// time or one below 0, no name.
  static base::Result<NavigatorTopics> read(const std::string& text);

  /// The last message of a topic that was published by `now` [s]. A leading '/' does not matter.
  TopicMessage lastOf(const std::string& topic, double now) const;
  /// Those after the message with that number, oldest first.
  std::vector<TopicMessage> after(const std::string& topic, int number, double now) const;

 private:
  struct Published {
    double time = 0.0;  // [s]
    std::string text;
  };
  std::map<std::string, std::vector<Published>> topics_;  // by name without '/'; by time
};

}  // namespace bt
