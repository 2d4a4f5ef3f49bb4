#include <algorithm>
#include <cmath>
#include <hdf5.h>
#include <limits>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// HDF5 files of PeTrack and the Pedestrian Dynamics Data Archive: table "trajectory" with id,
/// frame, x, y [m]. Attribute "fps" of the file or table: frame rate; attributes of the table named
/// as its columns: their unit; "wkt_geometry" of the file: walkable area.
namespace sim2d {

namespace {

/// Closes an HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (isGood()) {
      close_(id_);
    }
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&&) = delete;
  Handle& operator=(Handle&&) = delete;
  bool isGood() const { return id_ >= 0; }
  operator hid_t() const { return id_; }  // NOLINT: for the functions of the library

 private:
  hid_t id_;
  Close close_;
};

struct Row {
  long long id = 0, frame = 0;
  double x = 0.0, y = 0.0;
};

constexpr hsize_t kBlock = 65536;  // rows per read, unless a chunk is larger

/// None: not a one-dimensional table.
std::optional<hsize_t> countRows(hid_t table) {
  const Handle space(H5Dget_space(table), H5Sclose);
  hsize_t count = 0;
  const bool isColumn = space.isGood() && H5Sget_simple_extent_ndims(space) == 1 &&
                        H5Sget_simple_extent_dims(space, &count, nullptr) == 1;
  return isColumn ? std::optional(count) : std::nullopt;
}

/// Rows per compressed chunk; 1: not chunked.
hsize_t rowsOfChunk(hid_t table) {
  const Handle creation(H5Dget_create_plist(table), H5Pclose);
  hsize_t rows = 1;
  const bool isChunked = creation.isGood() && H5Pget_layout(creation) == H5D_CHUNKED &&
                         H5Pget_chunk(creation, 1, &rows) == 1;
  return isChunked ? std::max<hsize_t>(rows, 1) : 1;
}

/// Whether the rows are stored in this file and not in external files.
bool isInFile(hid_t table) {
  const Handle creation(H5Dget_create_plist(table), H5Pclose);
  return creation.isGood() && H5Pget_external_count(creation) == 0 &&
         H5Pget_layout(creation) != H5D_VIRTUAL;
}

/// A table may declare rows that the file does not contain.
void checkDeclaredSize(hid_t table, hid_t type, hsize_t count, const TrackInput& input) {
  const auto most = static_cast<hsize_t>(maxUnpackedSize(input.text.size()));
  const hsize_t mostRows = most / std::max<hsize_t>(H5Tget_size(type), 1);
  const hsize_t declared = std::max(count, rowsOfChunk(table));
  if (declared > mostRows) {
    input.error("tracks.too-many-rows", {declared, mostRows});
  }
}

/// The member of that name, ignoring case; empty: none.
std::string memberNamed(hid_t type, const std::string& name) {
  const int count = H5Tget_class(type) == H5T_COMPOUND ? H5Tget_nmembers(type) : 0;
  for (int k = 0; k < count; ++k) {
    char* const text = H5Tget_member_name(type, static_cast<unsigned>(k));
    std::string found = text == nullptr ? std::string() : text;
    H5free_memory(text);
    if (base::toLower(found) == name) {
      return found;
    }
  }
  return {};
}

/// The in-memory type of the rows: HDF5 finds members by name and converts numbers. Invalid: a
/// member is missing.
hid_t rowType(hid_t type) {
  const Handle wanted(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose);
  const std::pair<const char*, std::pair<std::size_t, hid_t>> members[] = {
      {"id", {HOFFSET(Row, id), H5T_NATIVE_LLONG}},
      {"frame", {HOFFSET(Row, frame), H5T_NATIVE_LLONG}},
      {"x", {HOFFSET(Row, x), H5T_NATIVE_DOUBLE}},
      {"y", {HOFFSET(Row, y), H5T_NATIVE_DOUBLE}}};
  for (const auto& [name, member] : members) {
    const std::string memberName = memberNamed(type, name);
    if (memberName.empty() ||
        H5Tinsert(wanted, memberName.c_str(), member.first, member.second) < 0) {
      return H5I_INVALID_HID;
    }
  }
  return H5Tcopy(wanted);
}

/// Text of an attribute; empty: missing or not a text.
std::string attributeText(hid_t of, const char* name) {
  const Handle attribute(H5Aexists(of, name) > 0 ? H5Aopen(of, name, H5P_DEFAULT) : -1, H5Aclose);
  const Handle type(attribute.isGood() ? H5Aget_type(attribute) : -1, H5Tclose);
  const Handle space(attribute.isGood() ? H5Aget_space(attribute) : -1, H5Sclose);
  if (!type.isGood() || H5Tget_class(type) != H5T_STRING ||
      H5Sget_simple_extent_npoints(space) != 1) {
    return {};
  }
  if (H5Tis_variable_str(type) <= 0) {
    std::string text(H5Tget_size(type), '\0');
    return H5Aread(attribute, type, text.data()) < 0 ? std::string()
                                                     : text.substr(0, text.find('\0'));
  }
  char* text = nullptr;
  const bool isRead = H5Aread(attribute, type, &text) >= 0 && text != nullptr;
  std::string copy = isRead ? text : "";
  H5free_memory(text);
  return copy;
}

/// A number, or a text such as "25 fps"; 0: missing.
double attributeNumber(hid_t of, const char* name) {
  const Handle attribute(H5Aexists(of, name) > 0 ? H5Aopen(of, name, H5P_DEFAULT) : -1, H5Aclose);
  const Handle space(attribute.isGood() ? H5Aget_space(attribute) : -1, H5Sclose);
  if (!space.isGood() || H5Sget_simple_extent_npoints(space) != 1) {
    return 0.0;
  }
  const std::string text = base::trimmed(attributeText(of, name));
  double value = 0.0;
  if (!text.empty()) {
    return base::parseDouble(text.substr(0, text.find_first_of(" \tfF"))).value_or(0.0);
  }
  return H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0 ? value : 0.0;
}

/// The frame rate stated by the file or table; 0: none. If both differ, the user must give it.
double statedRate(hid_t file, hid_t table, const TrackInput& input) {
  constexpr double kSameRate = 1e-4;  // relative tolerance: one may be in single precision
  double rate = 0.0;
  for (const hid_t of : {file, table}) {
    for (const char* name : {"fps", "framerate", "frame_rate", "frameRate"}) {
      const double found = attributeNumber(of, name);
      if (rate > 0.0 && found > 0.0 && std::abs(found - rate) > kSameRate * rate &&
          !(input.options.framesPerSecond > 0.0)) {
        input.error("tracks.two-rates", {rate, found});
      }
      rate = rate > 0.0 ? rate : found;
    }
  }
  return rate;
}

/// [m] per unit of the positions: metres unless an attribute states another unit.
double statedUnit(hid_t table) {
  for (const char* name : {"x", "y", "unit", "units"}) {
    const std::string text = base::toLower(attributeText(table, name));
    if (const std::optional<double> unit = lengthUnitIn(text)) {
      return *unit;
    }
  }
  return 1.0;
}

class TableReader {
 public:
  TableReader(const TrackInput& input, hid_t table, double unit)
      : input_(input), table_(table), unit_(unit) {}

  /// Reports problems with the columns and the number of rows.
  void check(hsize_t count) {
    const Handle type(H5Dget_type(table_), H5Tclose);
    const Handle row(rowType(type), H5Tclose);
    if (!row.isGood()) {
      input_.error("tracks.no-dataset");
    } else {
      checkDeclaredSize(table_, type, count, input_);
    }
  }

  /// False: a problem was reported.
  bool read(hsize_t count) {
    const Handle type(H5Dget_type(table_), H5Tclose);
    const Handle row(rowType(type), H5Tclose);
    const Handle space(H5Dget_space(table_), H5Sclose);
    std::vector<Row> rows;
    const hsize_t piece = rowsOfChunk(table_);  // avoids unpacking a chunk repeatedly
    const hsize_t most = piece * std::max<hsize_t>(kBlock / piece, 1);
    for (hsize_t from = 0; from < count && tracks_.isUsable(); from += most) {
      const hsize_t block = std::min(most, count - from);
      rows.resize(block);
      const Handle memory(H5Screate_simple(1, &block, nullptr), H5Sclose);
      H5Sselect_hyperslab(space, H5S_SELECT_SET, &from, nullptr, &block, nullptr);
      if (H5Dread(table_, row, memory, space, H5P_DEFAULT, rows.data()) < 0) {
        input_.error("tracks.no-dataset");
        return false;
      }
      if (!take(rows)) {
        return false;
      }
    }
    return true;
  }
  TrackFile finish(double rate) { return tracks_.finish(input_.path, rate); }

 private:
  bool take(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      const Vec2 place(row.x, row.y);
      if (!place.allFinite() || row.id < 0 || row.id > std::numeric_limits<int>::max()) {
        input_.error("tracks.out-of-range");
        return false;
      }
      tracks_.add(static_cast<int>(row.id), row.frame, unit_ * place, 0, 0);
    }
    return true;
  }

  const TrackInput& input_;
  hid_t table_;
  double unit_;
  FrameTracks tracks_;
};

TrackFile readHdf5(const TrackInput& input) {
  if (input.path == "-") {
    input.error("tracks.needs-file", {"HDF5"});
    return {};
  }
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported as diagnostics
  const Handle file(H5Fopen(input.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Handle table(file.isGood() ? H5Dopen2(file, "trajectory", H5P_DEFAULT) : -1, H5Dclose);
  const auto count = table.isGood() && isInFile(table) ? countRows(table) : std::nullopt;
  if (!count) {
    input.error("tracks.no-dataset");
    return {};
  }
  const double unit = statedUnit(table);
  const double rate = rateOf(input, statedRate(file, table, input));
  TableReader reader(input, table, unit);
  reader.check(*count);
  if (base::hasErrors(input.problems) || !reader.read(*count)) {
    return {};
  }
  TrackFile tracks = reader.finish(rate);
  tracks.lengthUnit = unit;
  addWalkableArea(attributeText(file, "wkt_geometry"), unit, input, tracks);
  return tracks;
}

FormatMatch matchFormat(const FilePreview& preview) {
  return preview.text.substr(0, 4) == "\x89HDF" ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addHdf5(TrackFormats& to) {
  to.add({"hdf5", 11, matchFormat, readHdf5});
}

}  // namespace sim2d
