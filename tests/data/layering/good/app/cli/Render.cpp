#include "app/run/Bundle.h"
#include "editor/View.h"
