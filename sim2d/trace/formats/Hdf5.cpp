#include <hdf5.h>
#include <limits>

#include "sim2d/trace/ForeignReaders.h"

/// HDF5 files of PeTrack and of the Pedestrian Dynamics Data Archive: a table "trajectory" with id,
/// frame, x, y [m]; the rate is the attribute "fps" of the file.
namespace sim2d {

namespace {

/// Closes what it holds.
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

constexpr hsize_t kMostRows = 20000000;  // 640 MB of them, before they are tracks

/// Nothing: it is no column of rows.
std::optional<hsize_t> countRows(hid_t table) {
  const Handle space(H5Dget_space(table), H5Sclose);
  hsize_t count = 0;
  const bool isColumn = space.isGood() && H5Sget_simple_extent_ndims(space) == 1 &&
                        H5Sget_simple_extent_dims(space, &count, nullptr) == 1;
  return isColumn ? std::optional(count) : std::nullopt;
}

/// The library finds the members by name and converts their numbers. A table may claim rows that
/// are nowhere in the file: the count has a fixed limit.
bool readRows(hid_t file, const ForeignInput& input, std::vector<Row>& rows) {
  const Handle table(H5Dopen2(file, "trajectory", H5P_DEFAULT), H5Dclose);
  const std::optional<hsize_t> count = table.isGood() ? countRows(table) : std::nullopt;
  if (!count) {
    return false;
  }
  if (*count > kMostRows) {
    input.problems.push_back(base::error("tracks.too-many-rows", {*count, kMostRows}, input.path));
    return false;
  }
  const Handle type(H5Dget_type(table), H5Tclose);
  for (const char* name : {"id", "frame", "x", "y"}) {
    if (H5Tget_class(type) != H5T_COMPOUND || H5Tget_member_index(type, name) < 0) {
      return false;
    }
  }
  const Handle row(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose);
  H5Tinsert(row, "id", HOFFSET(Row, id), H5T_NATIVE_LLONG);
  H5Tinsert(row, "frame", HOFFSET(Row, frame), H5T_NATIVE_LLONG);
  H5Tinsert(row, "x", HOFFSET(Row, x), H5T_NATIVE_DOUBLE);
  H5Tinsert(row, "y", HOFFSET(Row, y), H5T_NATIVE_DOUBLE);
  rows.resize(*count);
  return H5Dread(table, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()) >= 0;
}

/// 0: it is not told.
double toldRate(hid_t file) {
  const Handle attribute(H5Aexists(file, "fps") > 0 ? H5Aopen(file, "fps", H5P_DEFAULT) : -1,
                         H5Aclose);
  double rate = 0.0;
  const Handle space(attribute.isGood() ? H5Aget_space(attribute) : -1, H5Sclose);
  const bool isOne = space.isGood() && H5Sget_simple_extent_npoints(space) == 1;
  const bool isRead = isOne && H5Aread(attribute, H5T_NATIVE_DOUBLE, &rate) >= 0;
  return isRead ? rate : 0.0;
}

TrackFile readHdf5(const ForeignInput& input) {
  if (input.path == "-") {
    input.problems.push_back(base::error("tracks.needs-file", {}, input.path));
    return {};
  }
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // what fails is told here
  const Handle file(H5Fopen(input.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  std::vector<Row> rows;
  if (!file.isGood() || !readRows(file, input, rows)) {
    if (!base::hasErrors(input.problems)) {
      input.problems.push_back(base::error("tracks.no-dataset", {}, input.path));
    }
    return {};
  }
  const double given = input.options.framesPerSecond;
  const double rate = given > 0.0 ? given : toldRate(file);
  if (!(rate > 0.0)) {
    input.problems.push_back(base::error("tracks.no-rate", {}, input.path));
    return {};
  }
  FrameTracks tracks;
  for (const Row& row : rows) {
    const Vec2 place(row.x, row.y);
    if (!place.allFinite() || row.id < 0 || row.id > std::numeric_limits<int>::max()) {
      input.problems.push_back(base::error("tracks.out-of-range", {}, input.path));
      return {};
    }
    tracks.add(static_cast<int>(row.id), row.frame, place, 0, 0);
  }
  return tracks.finish(input.path, rate);
}

Claim claim(const FirstLook& look) {
  return look.text.substr(0, 4) == "\x89HDF" ? Claim::ByContent : Claim::None;
}

}  // namespace

void addHdf5(TrackFormats& to) {
  to.add({"hdf5", 11, claim, readHdf5});
}

}  // namespace sim2d
