#include "app/bridge/dds/Domain.h"

#include "app/bridge/messages/TypeNames.h"

namespace bridge {

std::string resolvedName(const std::string& name, const std::string& nameSpace,
                         const std::string& node) {
  if (!name.empty() && name.front() == '/') {
    return name;
  }
  const std::string begin = nameSpace == "/" ? "/" : nameSpace + "/";
  if (name.rfind("~/", 0) == 0) {
    return begin + node + name.substr(1);
  }
  return begin + name;
}

std::string ddsTopic(const std::string& topic) {
  return "rt" + topic;
}

std::string rosTopic(const std::string& ddsTopic) {
  return ddsTopic.rfind("rt/", 0) == 0 ? ddsTopic.substr(2) : std::string();
}

std::string ddsRequestTopic(const std::string& service) {
  return "rq" + service + "Request";
}

std::string ddsReplyTopic(const std::string& service) {
  return "rr" + service + "Reply";
}

std::string ddsRequestType(const std::string& type) {
  return ddsTypeName(type + "_Request");
}

std::string ddsReplyType(const std::string& type) {
  return ddsTypeName(type + "_Response");
}

}  // namespace bridge
