#include "app/run/Bundle.h"
#include "editor/canvas/View.h"
