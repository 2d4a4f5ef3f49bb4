#include "app/bridge/dds/RosNames.h"

#include <algorithm>
#include <cctype>

#include "sim2d/base/Text.h"

namespace bridge {
namespace {

bool isWordOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::optional<std::string> mangled(const std::string& type, const std::string& ending) {
  const std::vector<std::string> parts = base::split(type, '/');
  if (parts.size() != 3 || !std::all_of(parts.begin(), parts.end(), isNodeName)) {
    return std::nullopt;
  }
  return parts[0] + "::" + parts[1] + "::dds_::" + parts[2] + ending;
}

}  // namespace

std::string resolvedName(const std::string& name, const std::string& space,
                         const std::string& node) {
  if (!name.empty() && name.front() == '/') {
    return name;
  }
  const std::string begin = space == "/" ? "/" : space + "/";
  if (name.rfind("~/", 0) == 0) {
    return begin + node + name.substr(1);
  }
  return begin + name;
}

std::string ddsTopic(const std::string& topic) {
  return "rt" + topic;
}

std::string ddsRequestTopic(const std::string& service) {
  return "rq" + service + "Request";
}

std::string ddsReplyTopic(const std::string& service) {
  return "rr" + service + "Reply";
}

std::optional<std::string> ddsType(const std::string& type) {
  return mangled(type, "_");
}

std::optional<std::string> ddsRequestType(const std::string& type) {
  return mangled(type, "_Request_");
}

std::optional<std::string> ddsReplyType(const std::string& type) {
  return mangled(type, "_Response_");
}

bool isNodeName(const std::string& name) {
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), isWordOfName);
}

bool isNamespace(const std::string& name) {
  if (name == "/") {
    return true;
  }
  if (name.empty() || name.front() != '/') {
    return false;
  }
  const std::vector<std::string> parts = base::split(name.substr(1), '/');
  return std::all_of(parts.begin(), parts.end(), isNodeName);
}

}  // namespace bridge
