#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <QtTest>

#include "app/cli/CommandRegistry.h"

namespace {

struct Greeting {
  std::string name, said;
  bool asJson = false;
};

/// What a file of app/cli/commands holds.
void addGreet(app::CommandRegistry& commands, Greeting& greeting) {
  CLI::App& command =
      commands.add("greet", "Says hello", [&greeting](const app::Invocation& given) {
        greeting.said = "hello " + greeting.name;
        greeting.asJson = given.json;
        return 7;
      });
  command.add_option("name", greeting.name, "Who")->required();
}

}  // namespace

/// One made-up command: added in one place, it has its help, its options and those of all.
class MadeUpCommandTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_added_isParsedHelpedAndRun() {
    CLI::App root;
    app::CommandRegistry commands(root);
    Greeting greeting;
    addGreet(commands, greeting);
    commands.addOutputOptions();
    QVERIFY(root.help().find("Says hello") != std::string::npos);
    QVERIFY(root.get_subcommand("greet")->help().find("--quiet") != std::string::npos);
    char program[] = "hunavsim", word[] = "greet", name[] = "anna", json[] = "--json";
    char* words[] = {program, word, name, json, nullptr};
    root.parse(4, words);
    QCOMPARE(commands.start({4, words, {}}), 7);
    QCOMPARE(greeting.said, std::string("hello anna"));
    QVERIFY(greeting.asJson);
  }

  void failure_thatNobodyForesaw_isTheRuns() {
    char program[] = "hunavsim";
    char* words[] = {program, nullptr};
    QCOMPARE(app::runProgram(1, words,
                             [](app::CommandRegistry& to) {
                               to.setDefault([](const app::Invocation&) -> int {
                                 throw std::length_error("too long");
                               });
                             }),
             int{app::ExitRunFailed});
  }

  void wordsForResults_leaveOutWhatDoesNotChangeThem() {
    std::vector<std::string> texts = {"/usr/bin/hunavsim",
                                      "tune",
                                      "a.yaml",
                                      "-j",
                                      "4",
                                      "-j8",
                                      "--jobs",
                                      "2",
                                      "--jobs=3",
                                      "--seeds",
                                      "5",
                                      "-q",
                                      "--quiet",
                                      "--json",
                                      "--resume",
                                      "--force",
                                      "-o",
                                      "out"};
    std::vector<char*> words;
    words.reserve(texts.size());
    for (std::string& text : texts) {
      words.push_back(text.data());
    }
    const app::Invocation given{static_cast<int>(words.size()), words.data()};
    QCOMPARE(given.argumentsForResults(),
             (std::vector<std::string>{"hunavsim", "tune", "a.yaml", "--seeds", "5", "-o", "out"}));
  }

  void noCommand_doesTheDefault() {
    CLI::App root;
    app::CommandRegistry commands(root);
    commands.setDefault([](const app::Invocation&) { return 3; });
    char program[] = "hunavsim";
    char* words[] = {program, nullptr};
    root.parse(1, words);
    QCOMPARE(commands.start({1, words, {}}), 3);
  }
};

QTEST_APPLESS_MAIN(MadeUpCommandTest)
#include "tst_MadeUpCommand.moc"
