#include "app/cli/Console.h"
