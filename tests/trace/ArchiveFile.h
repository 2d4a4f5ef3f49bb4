#pragma once

#include <algorithm>
#include <hdf5.h>
#include <string>
#include <vector>

namespace foreign {

/// A table of the Pedestrian Dynamics Data Archive, with attributes.
class ArchiveFile {
 public:
  struct Row {
    long long id;
    int frame;
    float x;
    double y, z;
  };

  /// `chunk` > 0: the rows are in pieces of so many, packed. `count`: rows of the table, if only
  /// the given ones are ever written.
  ArchiveFile(const std::string& path, const std::vector<Row>& rows, hsize_t chunk = 0,
              hsize_t count = 0)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {
    const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
    H5Tinsert(type, "id", HOFFSET(Row, id), H5T_NATIVE_LLONG);
    H5Tinsert(type, "frame", HOFFSET(Row, frame), H5T_NATIVE_INT);
    H5Tinsert(type, "x", HOFFSET(Row, x), H5T_NATIVE_FLOAT);
    H5Tinsert(type, "y", HOFFSET(Row, y), H5T_NATIVE_DOUBLE);
    H5Tinsert(type, "z", HOFFSET(Row, z), H5T_NATIVE_DOUBLE);
    const hsize_t all = std::max<hsize_t>(count, rows.size());
    const hsize_t most = H5S_UNLIMITED;
    const hid_t space = H5Screate_simple(1, &all, chunk > 0 ? &most : nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    if (chunk > 0) {
      H5Pset_chunk(creation, 1, &chunk);
      H5Pset_deflate(creation, 9);
    }
    table_ = H5Dcreate2(file_, "trajectory", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (!rows.empty()) {
      H5Dwrite(table_, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data());
    }
    H5Pclose(creation);
    H5Sclose(space);
    H5Tclose(type);
  }
  ~ArchiveFile() {
    H5Dclose(table_);
    H5Fclose(file_);
  }
  ArchiveFile(const ArchiveFile&) = delete;
  ArchiveFile& operator=(const ArchiveFile&) = delete;
  ArchiveFile(ArchiveFile&&) = delete;
  ArchiveFile& operator=(ArchiveFile&&) = delete;

  hid_t root() const { return file_; }
  hid_t table() const { return table_; }

  /// An attribute; `count` > 1: a list of the same number.
  static void number(hid_t of, const char* name, double value, hsize_t count = 1) {
    const hid_t space = count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
    const hid_t attribute =
        H5Acreate2(of, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, std::vector<double>(count, value).data());
    H5Aclose(attribute);
    H5Sclose(space);
  }
  /// A text attribute of fixed length, or as h5py writes a Python str.
  static void text(hid_t of, const char* name, const std::string& value, bool isVariable) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, isVariable ? H5T_VARIABLE : value.size());
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t attribute = H5Acreate2(of, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const char* const pointer = value.c_str();
    H5Awrite(attribute, type, isVariable ? static_cast<const void*>(&pointer) : pointer);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
  }

 private:
  hid_t file_, table_ = -1;
};

}  // namespace foreign
