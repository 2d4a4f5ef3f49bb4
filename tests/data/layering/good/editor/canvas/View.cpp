#include <QGraphicsView>

#include "bt/tree/TreeSpec.h"
#include "editor/document/Document.h"
#include "editor/look/Theme.h"
#include "metrics/Report.h"
