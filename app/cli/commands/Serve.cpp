#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"

#ifdef HUNAV_ROS2
#include "app/bridge/nodes/AgentServer.h"
#endif

namespace app {

namespace {

struct ServeOptions {
  RunSpec run;
  Ros2Options ros2;
  std::string space = "/";
  std::vector<std::string> also;  // loader, generator
};

#ifdef HUNAV_ROS2
constexpr std::chrono::milliseconds kPollInterval(100);  // for Ctrl-C

bridge::ServeSettings settingsOf(const ServeOptions& options,
                                 const bridge::DomainSettings& domain) {
  const auto has = [&](const char* word) {
    return std::find(options.also.begin(), options.also.end(), word) != options.also.end();
  };
  bridge::ServeSettings settings;
  settings.domain = domain;
  settings.nameSpace = options.space;
  settings.actsAsLoader = has("loader");
  settings.actsAsGenerator = has("generator");
  return settings;
}

void printDiagnostic(const base::Diagnostic& diagnostic) {
  printDiagnostics({diagnostic});
}

int serveAgents(const ServeOptions& options, const bridge::DomainSettings& domain,
                const Bundle& bundle, const Invocation& given) {
  base::Result<std::unique_ptr<bridge::AgentServer>> server =
      bridge::AgentServer::create(bundle, settingsOf(options, domain), printDiagnostic);
  requireFine(server.diagnostics(), ExitBadInput, base::Severity::Warning);
  catchInterrupts();
  if (given.json) {
    printLine(base::jsonText(nlohmann::ordered_json{{"serving", options.run.scenario},
                                                    {"domain", domain.domain},
                                                    {"network", !domain.localhostOnly}},
                             -1));
  } else if (!given.quiet) {
    printLine("serving " + options.run.scenario + " in domain " + std::to_string(domain.domain) +
              (domain.localhostOnly ? " on this machine" : " on the network") +
              "; press Ctrl-C to stop");
  }
  while (!wasInterrupted()) {
    (*server)->spin(kPollInterval);
  }
  if (given.json) {
    printLine(base::jsonText(nlohmann::ordered_json{{"answered", (*server)->answered()}}, -1));
  } else if (!given.quiet) {
    printLine(std::to_string((*server)->answered()) + " requests answered");
  }
  return ExitFine;
}
#else
int serveAgents(const ServeOptions& /*options*/, const bridge::DomainSettings& /*domain*/,
                const Bundle& /*bundle*/, const Invocation& /*given*/) {
  return ExitBadInput;  // reported by domainSettingsOf
}
#endif

int serveCommand(const ServeOptions& options, const Invocation& given) {
  const base::Result<RunSettings> settings = runSettingsOf(options.run);
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf(options.ros2);
  requireFine(settings.diagnostics(), ExitWrongCommandLine);
  requireFine(domain.diagnostics());
  const Bundle bundle = readBundle(options.run, *settings, loadMapImage);
  requireFine(bundle.wrongOptions, ExitWrongCommandLine);
  return serveAgents(options, *domain, bundle, given);
}

}  // namespace

void addServe(CommandRegistry& commands) {
  const auto added = commands.add(
      "serve",
      "Control the agents of another simulator as a replacement for HuNavSim's agent manager",
      serveCommand);
  CLI::App& command = added.first;
  ServeOptions& options = added.second;
  command
      .add_option("scenario", options.run.scenario,
                  "Scenario file, or the name of a shipped scenario (hunavsim list scenarios)")
      ->required()
      ->transform(scenarioFile);
  addRos2Options(command, options.ros2, "Provide the services of HuNavSim's nodes in ROS 2");
  command.get_option("--ros2")->required();
  command.add_option("--namespace", options.space, "Namespace of the nodes, for example /lab")
      ->check(namespaceName());
  command
      .add_option("--also", options.also,
                  "Also act as loader (parameters of the scenario, like hunav_loader) or generator "
                  "(service get_agents, like the world generator of a wrapper)")
      ->check(oneOf({"loader", "generator"}))
      ->allow_extra_args(false);
  for (const char* name : {"map", "trees", "seed", "model", "set", "threads", "compat"}) {
    addRunOption(command, name, options.run);
  }
  commands.addExamples(command, {{"hunavsim serve corner_cafe_agents --ros2",
                                  "Move the people of Gazebo, Webots or Isaac Sim", "ROS 2"}});
}

}  // namespace app
