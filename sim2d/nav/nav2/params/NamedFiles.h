#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Files that a parameter file names by their places on a robot: trees, masks, graphs, databases.
namespace sim2d::nav2 {

/// What a path of a parameter file stands for on this computer.
struct NamedFile {
  std::string file;                   // without "." and ".."; empty: there is none
  std::vector<std::string> searched;  // the existing folders that were searched, in this order
};

/// Finds the file that a parameter names. `named` may be absolute, relative, or have what launch
/// files and URLs replace: `$(find-pkg-share pkg)/path`, `$(find pkg)/path`, `package://pkg/path`,
/// `$(var name)/path`, `$(env NAME)/path`, `${NAME}/path`, `file:///path`, `~/path`. What they
/// stand for is not known here (no variable of the environment is read, so that runs can be
/// repeated); the path after them is searched.
///
/// A file at the path as written is taken first. Then the path, its last parts (`a/b/c`, `b/c`,
/// `c`) and thus the file's name alone are searched in this order, each of them in every place
/// before the next shorter one: the folder of the package where one is named (a folder of its name
/// above or beside `folders`); each of `folders`, in it and in its folders `params`, `config`,
/// `behavior_trees`, `behavior_tree`, `bt`, `trees`, `maps`, `map`, `graphs`, `masks`; the folder
/// above, in the same way. `folders` are those of the parameter files, that of the value first; an
/// empty one is the working directory.
NamedFile findNamedFile(const std::string& named, const std::vector<std::string>& folders);

/// The path without what launch files replace: "maps/a.yaml" of "$(find-pkg-share
/// nav)/maps/a.yaml"; empty when nothing is left, or only a part of a name.
std::string pathWithoutPlaceholder(std::string_view named);

/// Warning nav2.file-not-found: parameter `key` names `named`, the places of `found`, and what is
/// used `instead` ("the default tree").
base::Diagnostic namedFileMissing(const std::string& key, const std::string& named,
                                  const NamedFile& found, const std::string& instead);

}  // namespace sim2d::nav2
