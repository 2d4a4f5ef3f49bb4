#include "app/bridge/nodes/Node.h"

#include <algorithm>

#include "app/bridge/messages/Time.h"
#include "sim2d/base/Find.h"

namespace bridge {
namespace {

using rcl_interfaces::Parameter;
using rcl_interfaces::ParameterValue;

std::string firstOf(const base::Diagnostics& why) {
  return why.empty() ? std::string() : why.front().message;
}

/// Applies `make` to each named parameter. Empty if one is missing, as in rclcpp.
template <class T, class Make>
std::vector<T> ofAll(const std::vector<std::string>& names, const Node& node, Make make) {
  std::vector<T> found;
  for (const std::string& name : names) {
    const ParameterValue* const value = node.parameter(name);
    if (value == nullptr) {
      return {};
    }
    found.push_back(make(name, *value));
  }
  return found;
}

/// Whether the rest of a parameter name after a prefix is within the depth.
bool isWithin(const std::string& rest, std::uint64_t depth) {
  const auto dots = static_cast<std::uint64_t>(std::count(rest.begin(), rest.end(), '.'));
  return depth == 0 || dots < depth;
}

bool isListed(const std::string& name, const rcl_interfaces::ListParameters::Request& request) {
  if (request.prefixes.empty()) {
    return isWithin(name, request.depth);
  }
  return std::any_of(request.prefixes.begin(), request.prefixes.end(),
                     [&](const std::string& prefix) {
                       const bool isBelow = name.rfind(prefix + ".", 0) == 0;
                       return name == prefix ||
                              (isBelow && isWithin(name.substr(prefix.size() + 1), request.depth));
                     });
}

/// The key that identifies a problem for reporting it once. It does not depend on the bytes of the
/// message.
std::string problemKey(const base::Diagnostic& diagnostic) {
  const bool isOfBytes =
      diagnostic.code == "ros2.other-version" || diagnostic.code == "ros2.bad-message";
  return isOfBytes && !diagnostic.values.empty()
             ? std::string(diagnostic.code) + diagnostic.values.front().second
             : diagnostic.text();
}

const char* rmwName(Rmw rmw) {
  return rmw == Rmw::FastRtps ? "fastrtps" : "cyclonedds";
}

}  // namespace

Node::Node(Participant& participant, const DomainSettings& settings, const std::string& nameSpace,
           const std::string& name, Parameters parameters, ReportCallback report)
    : participant_(participant),
      rmw_(settings.rmw),
      fullName_((nameSpace == "/" ? "/" : nameSpace + "/") + name),
      name_(name),
      node_(participant.addNode(nameSpace, name)),
      parameters_(std::move(parameters)),
      report_(std::move(report)),
      log_(publisher<rcl_interfaces::Log>("/rosout", Qos::log())),
      events_(publisher<rcl_interfaces::ParameterEvent>("/parameter_events", Qos::parameters())) {
  serveParameters();
}

const ParameterValue* Node::parameter(const std::string& name) const {
  const Parameter* const found = base::findBy(parameters_, &Parameter::name, name);
  return found == nullptr ? nullptr : &found->value;
}

void Node::serveParameters() {
  using namespace rcl_interfaces;  // NOLINT: only their services
  const Qos qos = Qos::parameters();
  serve<GetParameters>("~/get_parameters", qos, [this](const GetParameters::Request& request) {
    return GetParameters::Response{ofAll<ParameterValue>(
        request.names, *this, [](const std::string&, const ParameterValue& v) { return v; })};
  });
  serve<GetParameterTypes>(
      "~/get_parameter_types", qos, [this](const GetParameterTypes::Request& request) {
        return GetParameterTypes::Response{ofAll<std::uint8_t>(
            request.names, *this,
            [](const std::string&, const ParameterValue& v) { return v.type; })};
      });
  serve<DescribeParameters>(
      "~/describe_parameters", qos, [this](const DescribeParameters::Request& request) {
        return DescribeParameters::Response{ofAll<ParameterDescriptor>(
            request.names, *this, [](const std::string& name, const ParameterValue& v) {
              ParameterDescriptor descriptor;
              descriptor.name = name;
              descriptor.type = v.type;
              return descriptor;
            })};
      });
  serve<ListParameters>("~/list_parameters", qos, [this](const ListParameters::Request& request) {
    return ListParameters::Response{list(request)};
  });
  serve<SetParameters>("~/set_parameters", qos, [this](const SetParameters::Request& request) {
    SetParameters::Response response;
    for (const Parameter& wanted : request.parameters) {
      response.results.push_back(set({wanted}));
    }
    return response;
  });
  serve<SetParametersAtomically>(
      "~/set_parameters_atomically", qos, [this](const SetParametersAtomically::Request& request) {
        return SetParametersAtomically::Response{set(request.parameters)};
      });
}

std::string Node::whyNot(const Parameter& wanted) const {
  const ParameterValue* const value = parameter(wanted.name);
  if (value == nullptr) {
    return "there is no parameter " + wanted.name;
  }
  return value->type == wanted.value.type ? std::string() : wanted.name + " has a different type";
}

/// Sets all parameters or none.
rcl_interfaces::SetParametersResult Node::set(const Parameters& wanted) {
  rcl_interfaces::SetParametersResult result;
  for (const Parameter& each : wanted) {
    result.reason = whyNot(each);
    if (!result.reason.empty()) {
      return result;
    }
  }
  for (const Parameter& each : wanted) {
    base::findBy(parameters_, &Parameter::name, each.name)->value = each.value;
  }
  result.successful = true;
  rcl_interfaces::ParameterEvent event;
  event.stamp = stampOfNanoseconds(wallClockNanoseconds());
  event.node = fullName_;
  event.changedParameters = wanted;
  events_.publish(event);
  return result;
}

rcl_interfaces::ListParametersResult Node::list(
    const rcl_interfaces::ListParameters::Request& request) const {
  rcl_interfaces::ListParametersResult result;
  for (const Parameter& each : parameters_) {
    if (!isListed(each.name, request)) {
      continue;
    }
    result.names.push_back(each.name);
    const std::size_t dot = each.name.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : each.name.substr(0, dot);
    const bool isNew =
        std::find(result.prefixes.begin(), result.prefixes.end(), prefix) == result.prefixes.end();
    if (!prefix.empty() && isNew) {
      result.prefixes.push_back(prefix);
    }
  }
  return result;
}

void Node::log(std::uint8_t level, const std::string& text) {
  rcl_interfaces::Log entry;
  entry.stamp = stampOfNanoseconds(wallClockNanoseconds());
  entry.level = level;
  entry.name = name_;
  entry.msg = text;
  log_.publish(entry);
}

void Node::reportBadMessage(const std::string& topic, const base::Diagnostics& why) {
  report_(base::problem(base::Severity::Warning, "ros2.bad-message", {topic, firstOf(why)}));
}

void Node::reportBadRequest(const std::string& service, const ServiceRequest& asked,
                            const base::Diagnostics& why) {
  if (asked.clientRmw != rmw_) {
    report_(base::problem(base::Severity::Warning, "ros2.other-rmw",
                          {service, rmwName(asked.clientRmw), rmwName(rmw_),
                           std::string("rmw_") + rmwName(rmw_) + "_cpp"}));
    return;
  }
  report_(base::problem(base::Severity::Warning, "ros2.other-version", {service, firstOf(why)}));
}

std::optional<base::Diagnostic> NoPeerCheck::check(const Participant& participant) {
  if (isDone_ || std::chrono::steady_clock::now() < due_) {
    return std::nullopt;
  }
  isDone_ = true;
  if (participant.hasDiscoveredPeers()) {
    return std::nullopt;
  }
  return base::problem(base::Severity::Warning,
                       settings_.localhostOnly ? "ros2.no-peer-here" : "ros2.no-peer-on-network",
                       {settings_.domain, kNoPeerAfter.count()});
}

std::unique_ptr<Node> NodeProgram::makeNode(const std::string& nameSpace, const std::string& name,
                                            Node::Parameters parameters) {
  return std::make_unique<Node>(
      *participant_, domain_, nameSpace, name, std::move(parameters),
      [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
}

base::Diagnostics NodeProgram::finishStart() {
  participant_->publishGraph();
  hasStarted_ = true;
  return startProblems_;
}

void NodeProgram::reportOnce(const base::Diagnostic& diagnostic) {
  if (!reported_.isNew(problemKey(diagnostic))) {
    return;
  }
  if (hasStarted_) {
    report_(diagnostic);
  } else {
    startProblems_.push_back(diagnostic);
  }
}

void NodeProgram::reportMissingPeers() {
  if (const std::optional<base::Diagnostic> diagnostic = noPeer_.check(*participant_)) {
    reportOnce(*diagnostic);
  }
}

}  // namespace bridge
