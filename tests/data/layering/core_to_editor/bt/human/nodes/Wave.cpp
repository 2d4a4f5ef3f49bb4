#include "editor/Preferences.h"
