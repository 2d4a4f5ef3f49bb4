#include "sim2d/trace/SqliteHandles.h"

#include <sqlite3.h>

namespace sim2d {

void SqliteCloser::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

void SqliteCloser::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

}  // namespace sim2d
