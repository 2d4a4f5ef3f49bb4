#include "app/cli/CommandLine.h"

#include <cstdio>

#include <CLI/CLI.hpp>

#include <QString>

#include "app/cli/Console.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace app {

void addAllCommands(CommandRegistry& to);  // written by CMake

namespace {

/// Words that no option takes; the library tells them last first.
int tellExtras(const CLI::App& root, const std::string& firstWord) {
  const std::vector<CLI::App*> given = root.get_subcommands();
  std::string text = "not expected: " + base::join(root.remaining(true), " ");
  std::vector<std::string> commands;
  for (const CLI::App* command : root.get_subcommands(nullptr)) {
    commands.push_back(command->get_name());
  }
  const std::optional<std::string> meant = base::nearestName(firstWord, commands);
  if (given.empty() && meant) {
    text += " (did you mean the command '" + *meant + "'?)";
  }
  printError(text);
  printError("see hunavsim" + (given.empty() ? "" : " " + given.front()->get_name()) + " --help");
  return kWrongCommandLine;
}

/// What image libraries grumble is told by our own messages, with the file's name.
void withoutLibraryWords(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (!text.startsWith(QLatin1String("libpng"))) {
    std::fputs(qPrintable(qFormatLogMessage(type, context, text) + QLatin1Char('\n')), stderr);
  }
}

}  // namespace

int runProgram(int argc, char** argv, void (*addWindow)(CommandRegistry&)) {
  qInstallMessageHandler(withoutLibraryWords);
  keepAliveWhenFilesAreFull();
  CLI::App root{"HuNavSim Desktop: people and a robot on a map, drawn, simulated, measured"};
  root.name("hunavsim");
  root.set_version_flag("--version", "hunavsim " + programVersion() + " (" + programCommit() + ")");
  root.set_help_flag("--help", "Show this text");
  CommandRegistry commands(root);
  addWindow(commands);
  addAllCommands(commands);
  commands.addOutputOptions();
  try {
    root.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return tellExtras(root, argv[1]);
  } catch (const CLI::ParseError& problem) {
    return root.exit(problem) == 0 ? kFine : kWrongCommandLine;
  }
  return commands.start({argc, argv, {}});
}

}  // namespace app
