#include "app/window/MainWindow.h"
