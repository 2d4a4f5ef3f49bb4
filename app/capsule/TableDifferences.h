#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Differences between stored and repeated files, with their places.
namespace capsule {

/// results.csv of a batch.
struct ResultTable {
  struct Row {
    int line = 0;                               // in the file, from 1
    std::map<std::string, std::string> fields;  // by column
  };
  std::vector<std::string> columns;
  std::map<long long, Row> rows;  // by number of the run
};

/// Errors: a column `run` is missing, rows of a different width, invalid or repeated numbers of
/// runs.
base::Result<ResultTable> readResultTable(const std::string& text, const std::string& file);

/// Compares the rows of `found` with the stored ones, field by field; a missing column is empty.
/// One error with the id `code` per difference (values: run, column, stored, found), located in
/// `file`.
base::Diagnostics rowDifferences(const ResultTable& stored, const ResultTable& found,
                                 std::string_view code, const std::string& file);

/// The first difference between two CSV files, located in `file`; empty: they are equal. For tables
/// with the column `step` it names the step, and the column `id` if there is one.
base::Diagnostics firstCsvDifference(const std::string& stored, const std::string& found,
                                     const std::string& file);

/// Differences between two JSON texts, at most `most`, located in `file`. `keys`: only these
/// members of the objects are compared; empty: all.
base::Diagnostics jsonDifferences(const std::string& stored, const std::string& found,
                                  const std::string& file,
                                  const std::vector<std::string>& keys = {}, std::size_t most = 10);

}  // namespace capsule
