#include "editor/document/Document.h"
#include "editor/tools/Tool.h"
