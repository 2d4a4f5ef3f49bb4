#include "app/cli/CommandRegistry.h"
#include "app/window/WindowCommand.h"

int main(int argc, char** argv) {
  return app::runProgram(argc, argv, app::addWindow);
}
