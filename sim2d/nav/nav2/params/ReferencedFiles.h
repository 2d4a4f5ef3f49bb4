#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Files that a parameter file names by their paths on a robot: trees, masks, graphs, databases.
namespace sim2d::nav2 {

/// The file on this computer that a path in a parameter file refers to.
struct ReferencedFile {
  std::string file;                   // normalized path; empty: not found
  std::vector<std::string> searched;  // the existing folders that were searched, in this order
};

/// Finds the file that a parameter names. `named` may be absolute, relative, or contain
/// substitutions of launch files and URLs: `$(find-pkg-share pkg)/path`, `$(find pkg)/path`,
/// `package://pkg/path`, `$(var name)/path`, `$(env NAME)/path`, `${NAME}/path`, `file:///path`,
/// `~/path`. Substitutions are not evaluated, and environment variables are not read so that runs
/// are reproducible; the path after them is searched.
///
/// A file at the path as written is taken first. Otherwise the path and its suffixes (`a/b/c`,
/// `b/c`, `c`) are searched from the longest to the shortest, each in every folder before the next:
/// the folder of the package where one is named (a folder of its name above or beside `folders`);
/// each of `folders` and its subfolders `params`, `config`, `behavior_trees`, `behavior_tree`,
/// `bt`, `trees`, `maps`, `map`, `graphs`, `masks`; the parent folder in the same way. `folders`
/// are those of the parameter files, beginning with the file of the value; an empty one is the
/// working directory.
ReferencedFile findReferencedFile(const std::string& named,
                                  const std::vector<std::string>& folders);

/// The path without substitutions: "maps/a.yaml" for "$(find-pkg-share nav)/maps/a.yaml"; empty
/// when nothing or only a part of a name remains.
std::string pathWithoutSubstitution(std::string_view named);

/// Warning nav2.file-not-found: parameter `key` names `named`, the folders in `found` were
/// searched, and `instead` ("the default tree") is used.
base::Diagnostic referencedFileMissing(const std::string& key, const std::string& named,
                                       const ReferencedFile& found, const std::string& instead);

}  // namespace sim2d::nav2
