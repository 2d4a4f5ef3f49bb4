#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/trace/Csv.h"
#include "sim2d/trace/TrackFormats.h"

/// Trajectory tables with a line of column names. Private to the folder.
namespace sim2d {

struct TableLayout {
  /// Column names by quantity: "time", "frame", "id", "x", "y", "heading", "vx", "vy", "omega",
  /// "group", "radius", "kind", "active" (rows with 0 are skipped). The first existing name is
  /// used; names given by the user take precedence. A unit may follow the name: "x [mm]", "t (s)".
  std::map<std::string, std::vector<std::string>> names;
  std::string_view text;  // beginning with the line of column names
  int firstLine = 1;      // line number of its start
  char separator = ',';
  std::map<std::string, std::string> units;  // by column name, if given separately
  double rate = 0.0;                         // frame rate stated in the file [1/s]
  std::string prefix;                        // text before the first name
};

/// Column names of the csv format: the names of the quantities.
std::map<std::string, std::vector<std::string>> ownColumnNames();

/// The first of comma, semicolon and tab that occurs in a line.
char separatorIn(std::string_view line);

/// Reads the rows. A second line with units is supported. Units given by the user take precedence.
TrackFile readTrackTable(const TrackInput& input, const TableLayout& layout);

}  // namespace sim2d
