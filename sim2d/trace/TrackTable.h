#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/trace/Csv.h"
#include "sim2d/trace/ForeignReaders.h"

/// Observations of bodies in a table with a line of column names; private to the folder.
namespace sim2d {

struct TableLayout {
  /// Names of a column by what it holds: "time", "frame", "id", "x", "y", "heading", "vx", "vy",
  /// "omega", "group", "radius", "kind", "active" (rows with 0 are left out). The first name that
  /// the table has counts; the names that the user gave come before. A column may have its unit
  /// behind its name: "x [mm]", "t (s)".
  std::map<std::string, std::vector<std::string>> names;
  std::string_view text;  // from the line of column names on
  int firstLine = 1;      // its number in the file
  char separator = ',';
  std::map<std::string, std::string> units;  // by column names, where the file has them apart
  double rate = 0.0;                         // frames per second that the file states
  std::string prefix;                        // before the first name
};

/// The names of the csv format: those of the quantities.
std::map<std::string, std::vector<std::string>> ownColumnNames();

/// The first of comma, semicolon and tabulator that a line holds.
char separatorIn(std::string_view line);

/// Reads the rows. A second line with units below the names is read as such. Units that the user
/// gives take precedence.
TrackFile readTrackTable(const ForeignInput& input, const TableLayout& layout);

}  // namespace sim2d
