#include <QGraphicsView>

#include "bt/tree/TreeSpec.h"
#include "metrics/Report.h"
