#include "app/window/WindowCommand.h"
namespace app { int windowCommand(int, char**, const RunOptions&, const WindowOptions&) { return 0; } }
