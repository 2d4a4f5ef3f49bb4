#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/MapImages.h"
#include "app/cli/Ros2Words.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"

#ifdef HUNAV_ROS2
#include "app/bridge/nodes/AgentServer.h"
#endif

namespace app {

namespace {

struct ServeOptions {
  RunOptions run;
  Ros2Words ros2;
  std::string space = "/";
  std::vector<std::string> also;  // loader, generator
};

#ifdef HUNAV_ROS2
constexpr std::chrono::milliseconds kLookEvery(100);  // for Ctrl-C

bridge::ServeSettings settingsOf(const ServeOptions& options,
                                 const bridge::DomainSettings& domain) {
  const auto has = [&](const char* word) {
    return std::find(options.also.begin(), options.also.end(), word) != options.also.end();
  };
  bridge::ServeSettings settings;
  settings.domain = domain;
  settings.space = options.space;
  settings.actsAsLoader = has("loader");
  settings.actsAsGenerator = has("generator");
  return settings;
}

void tell(const base::Diagnostic& said) {
  printDiagnostics({said});
}

int serveAgents(const ServeOptions& options, const bridge::DomainSettings& domain,
                const Bundle& bundle, const Invocation& given) {
  base::Result<std::unique_ptr<bridge::AgentServer>> server =
      bridge::AgentServer::create(bundle, settingsOf(options, domain), tell);
  requireFine(server.diagnostics(), ExitBadInput, base::Severity::Warning);
  catchInterrupts();
  if (given.json) {
    printLine(base::jsonText(nlohmann::ordered_json{{"serving", options.run.scenario},
                                                    {"domain", domain.domain},
                                                    {"network", !domain.localhostOnly}},
                             -1));
  } else if (!given.quiet) {
    printLine("serving " + options.run.scenario + " in domain " + std::to_string(domain.domain) +
              (domain.localhostOnly ? " on this machine" : " on the network") + "; Ctrl-C ends it");
  }
  while (!wasInterrupted()) {
    (*server)->spin(kLookEvery);
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
  return ExitBadInput;  // told before
}
#endif

int serveCommand(const ServeOptions& options, const Invocation& given) {
  const base::Result<RunSettings> settings = runSettingsOf(options.run);
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf(options.ros2);
  requireFine(settings.diagnostics(), ExitWrongCommandLine);
  requireFine(domain.diagnostics());
  const Bundle bundle = readBundle(options.run, *settings, loadMapImage);
  requireFine(bundle.wrongWords, ExitWrongCommandLine);
  return serveAgents(options, *domain, bundle, given);
}

}  // namespace

void addServe(CommandRegistry& commands) {
  const auto added = commands.add(
      "serve", "Move the people of another simulator, in the place of HuNavSim's agent manager",
      serveCommand);
  CLI::App& command = added.first;
  ServeOptions& options = added.second;
  command
      .add_option("scenario", options.run.scenario, "Scenario: a file, or a name of list scenarios")
      ->required()
      ->transform(scenarioFile);
  addRos2Options(command, options.ros2, "Offer the services of HuNavSim's nodes in ROS 2");
  command.get_option("--ros2")->required();
  command.add_option("--namespace", options.space, "Namespace of the nodes, such as /lab")
      ->check(namespaceName());
  command
      .add_option("--also", options.also,
                  "loader: the scenario as hunav_loader tells it; generator: get_agents as the "
                  "world generator of a wrapper answers it")
      ->check(oneOf({"loader", "generator"}))
      ->allow_extra_args(false);
  command.add_option("--map", options.run.map,
                     "Map to use instead of the scenario's; none = open plane");
  command.add_option("--trees", options.run.trees, "Folder with the behaviour trees");
  command.add_option("--seed", options.run.seed, "Seed of all random numbers");
  command.add_option("--model", options.run.model, "How people walk: see list models");
  command.add_option("--set", options.run.set, "PATH=VALUE: any value of the scenario")
      ->allow_extra_args(false);
  command.add_option("--threads", options.run.threads, "Number of threads; results stay the same");
  command.add_option("--compat", options.run.compat,
                     "hunav2, or quirks of the original: Q-13,Q-20");
}

}  // namespace app
