#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <sqlite3.h>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Sqlite.h"
#include "sim2d/trace/TrackFormats.h"

/// JuPedSim SQLite trajectories: tables trajectory_data (frame, id, pos_x, pos_y, ori_x, ori_y),
/// metadata (key, value) with "fps", geometry (hash, wkt) and frame_data (frame, geometry_hash).
/// Metres.
namespace sim2d {

namespace {

class JupedsimReader {
 public:
  explicit JupedsimReader(const TrackInput& input) : input_(input) {}

  TrackFile read() {
    if (!open() || !checkTable()) {
      return {};
    }
    const double rate = rateOf(input_, statedRate());
    if (base::hasErrors(input_.problems) || !readRows()) {
      return {};
    }
    sortByTime();
    TrackFile file;
    file.tracks = tracksOf(std::move(tracks_));
    framesToSeconds(file, rate);
    addGeometry(file);
    return file;
  }

 private:
  bool fail() {
    input_.error("tracks.bad-database", {sqlite3_errmsg(connection_.get())});
    return false;
  }

  bool open() {
    if (input_.path == "-") {
      input_.error("tracks.needs-file", {"SQLite"});
      return false;
    }
    sqlite3* raw = nullptr;
    const int code = sqlite3_open_v2(input_.path.c_str(), &raw,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
    connection_.reset(raw);
    if (code != SQLITE_OK) {
      input_.error("tracks.bad-database", {sqlite3_errstr(code)});
      return false;
    }
    limitQueries(raw, databaseSize(input_.path), budget_);
    return true;
  }

  bool hasColumn(const char* table, const char* column) const {
    return sqlite3_table_column_metadata(connection_.get(), nullptr, table, column, nullptr,
                                         nullptr, nullptr, nullptr, nullptr) == SQLITE_OK;
  }

  bool checkTable() {
    const SqliteStatement any = prepare(connection_.get(), "SELECT count(*) FROM sqlite_master");
    if (!any || sqlite3_step(any.get()) != SQLITE_ROW) {
      return fail();  // not a database, or damaged
    }
    for (const char* column : {"frame", "id", "pos_x", "pos_y"}) {
      if (!hasColumn("trajectory_data", column)) {
        input_.error("tracks.no-trajectory-data");
        return false;
      }
    }
    return true;
  }

  /// The first value of the first row as text; empty: none.
  std::string textOf(const char* sql) const {
    const SqliteStatement statement = prepare(connection_.get(), sql);
    if (!statement || sqlite3_step(statement.get()) != SQLITE_ROW) {
      return {};
    }
    const auto* const text = sqlite3_column_text(statement.get(), 0);
    return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
  }

  /// 0: not stated.
  double statedRate() const {
    const std::string text = textOf("SELECT value FROM metadata WHERE lower(key) = 'fps'");
    const double rate = base::parseDouble(base::trimmed(text)).value_or(0.0);
    return std::isfinite(rate) ? rate : 0.0;
  }

  bool readRows() {
    const bool hasHeadings =
        hasColumn("trajectory_data", "ori_x") && hasColumn("trajectory_data", "ori_y");
    const SqliteStatement rows =
        prepare(connection_.get(),
                hasHeadings ? "SELECT frame, id, pos_x, pos_y, ori_x, ori_y FROM trajectory_data"
                            : "SELECT frame, id, pos_x, pos_y FROM trajectory_data");
    if (!rows) {
      return fail();
    }
    constexpr std::size_t kMaxProblems = 1000;  // of the rows
    const std::size_t before = input_.problems.size();
    constexpr std::size_t kSmallestRow = 5;  // [B]: page entry, size, key and one column
    const auto mostRows = static_cast<long long>(databaseSize(input_.path) / kSmallestRow);
    long long row = 1;
    int code = sqlite3_step(rows.get());
    for (; code == SQLITE_ROW && input_.problems.size() - before < kMaxProblems; ++row) {
      if (row > mostRows) {
        input_.error("tracks.more-rows", {mostRows});
        return false;
      }
      takeRow(rows.get(), row, hasHeadings);
      code = sqlite3_step(rows.get());
    }
    if (code == SQLITE_INTERRUPT) {
      input_.error("tracks.too-many-steps", {row});
      return false;
    }
    return code == SQLITE_DONE || code == SQLITE_ROW ? !base::hasErrors(input_.problems) : fail();
  }

  /// None: not a finite number, which is reported.
  std::optional<double> number(sqlite3_stmt* rows, int column, long long row) {
    const int type = sqlite3_column_type(rows, column);
    const double value = sqlite3_column_double(rows, column);
    if ((type != SQLITE_INTEGER && type != SQLITE_FLOAT) || !std::isfinite(value)) {
      input_.error("tracks.bad-cell", {row, sqlite3_column_name(rows, column)});
      return std::nullopt;
    }
    return value;
  }

  void takeRow(sqlite3_stmt* rows, long long row, bool hasHeadings) {
    const auto frame = number(rows, 0, row);
    const auto id = number(rows, 1, row);
    const auto x = number(rows, 2, row);
    const auto y = number(rows, 3, row);
    if (!frame || !id || !x || !y) {
      return;
    }
    constexpr double kLargest = std::numeric_limits<int>::max();
    if (*id < 0.0 || *id > kLargest || *id != std::floor(*id)) {
      input_.error("tracks.bad-cell", {row, "id"});
      return;
    }
    Track& track = tracks_[static_cast<int>(*id)];
    track.id = static_cast<int>(*id);
    TrackPoint& point = track.points.emplace_back();
    point.time = *frame;
    point.position = Vec2(*x, *y);
    if (hasHeadings) {
      const Vec2 direction(sqlite3_column_double(rows, 4), sqlite3_column_double(rows, 5));
      if (direction.allFinite() && direction.norm() > 0.0) {
        point.heading = base::headingOf(direction);
      }
    }
  }

  /// SQL rows are unordered.
  void sortByTime() {
    for (auto& [id, track] : tracks_) {
      std::stable_sort(track.points.begin(), track.points.end(),
                       [](const TrackPoint& a, const TrackPoint& b) { return a.time < b.time; });
    }
  }

  /// Adds the geometry of the first frame.
  void addGeometry(TrackFile& file) {
    const std::string count = textOf("SELECT count(*) FROM geometry");
    if (base::parseInt(count).value_or(0) > 1) {
      input_.warning("tracks.geometries", {count});
    }
    std::string wkt = textOf(
        "SELECT geometry.wkt FROM frame_data JOIN geometry ON geometry.hash = "
        "frame_data.geometry_hash ORDER BY frame_data.frame LIMIT 1");
    if (wkt.empty()) {
      wkt = textOf("SELECT wkt FROM geometry LIMIT 1");
    }
    addWalkableArea(wkt, 1.0, input_, file);
  }

  const TrackInput& input_;
  std::int64_t budget_ = 0;  // must outlive the connection
  SqliteConnection connection_;
  std::map<int, Track> tracks_;
};

FormatMatch matchFormat(const FilePreview& preview) {
  return preview.text.substr(0, 15) == "SQLite format 3" ? FormatMatch::ByContent
                                                         : FormatMatch::None;
}

}  // namespace

void addJupedsim(TrackFormats& to) {
  to.add({"jupedsim", 12, matchFormat,
          [](const TrackInput& input) { return JupedsimReader(input).read(); }});
}

}  // namespace sim2d
